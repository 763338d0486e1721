#include "engine/strategy/linking/linking.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/strategy/linking/approach.h"
#include "engine/strategy/linking/link_choice.h"
#include "engine/strategy/linking/pass_index.h"
#include "engine/strategy/linking/path_builder.h"
#include "model/base/angle.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

/// Height above standing material and surfaces at which cutters go down at the plunge feed.
constexpr double kAir_mm = 1;
/// Nearest passes that are weighed against each other.
constexpr std::size_t kCandidates = 8;

/// The tips of a pass in the order of cutting; closed ones come back to their start.
std::vector<Vec3> ordered_tips(const CutPass& pass, const PassStart& start) {
  std::vector<Vec3> tips = pass.tips;
  if (start.reversed) std::reverse(tips.begin(), tips.end());
  if (!pass.closed) return tips;
  std::rotate(tips.begin(), tips.begin() + start.point, tips.end());
  tips.push_back(tips.front());
  return tips;
}

double highest_tip(const std::vector<std::vector<CutPass>>& groups) {
  double top = -std::numeric_limits<double>::infinity();
  for (const auto& group : groups)
    for (const CutPass& pass : group)
      for (const Vec3& tip : pass.tips) top = std::max(top, tip.z);
  return top;
}

class Linker {
 public:
  Linker(const CutterLocations& locations, const StageRequest& request, double clear_z_mm)
      : rule_{locations, request, std::min(kAir_mm, request.clearance_mm)},
        chooser_(rule_, clear_z_mm),
        path_(request, clear_z_mm),
        ramp_slope_(std::tan(model::radians(request.cut.ramp_angle_deg))) {}

  void cut_group(const std::vector<CutPass>& passes, const model::RunControl& control) {
    PassIndex index(passes);
    while (index.left() > 0) {
      control.check();
      const Next next = before_.empty() ? first_of(passes) : next_of(passes, index);
      index.remove(next.start.pass);
      const CutPass& pass = passes[next.start.pass];
      std::vector<Vec3> tips = ordered_tips(pass, next.start);
      go_to(pass, tips, next.link);
      for (const Vec3& tip : tips) path_.cut_to(tip);
      before_ = std::move(tips);
    }
  }

  model::Toolpath take() {
    if (!before_.empty()) cut_along(way_out(rule_, before_));
    return path_.take();
  }

 private:
  struct Next {
    PassStart start;
    Link link;
  };

  static Next first_of(const std::vector<CutPass>& passes) {
    const auto first = std::find_if(passes.begin(), passes.end(),
                                    [](const CutPass& pass) { return !pass.tips.empty(); });
    return {{static_cast<int>(first - passes.begin()), 0, false}, {}};
  }

  Next next_of(const std::vector<CutPass>& passes, PassIndex& index) const {
    const Vec3& from = before_.back();
    Next best;
    best.link.seconds = std::numeric_limits<double>::infinity();
    for (const PassIndex::Near& near : index.nearest(from, kCandidates)) {
      const CutPass& pass = passes[near.start.pass];
      const Vec3& to = pass.tips[near.start.point];
      if (chooser_.least_seconds(from, to) >= best.link.seconds) continue;
      const Link link = chooser_.choose(from, to, pass.stands_to_mm);
      if (link.seconds < best.link.seconds) best = {near.start, link};
    }
    return best;
  }

  void go_to(const CutPass& pass, const std::vector<Vec3>& tips, const Link& link) {
    if (!before_.empty() && link.kind == LinkKind::straight) return go_straight(tips.front(), link);
    const Approach in = way_in(rule_, pass, tips);
    come_from_above(in, pass.stands_to_mm);
    for (const Vec3& tip : in.tips) in.ramps ? path_.plunge_to(tip) : path_.cut_to(tip);
  }

  void go_straight(const Vec3& to, const Link& link) {
    const Vec3 up{0, 0, link.raised_mm}, from = path_.position();
    const double level = level_distance(from, to);
    path_.link_to(from + up);
    if (from.z - to.z > ramp_slope_ * level)
      path_.plunge_to(to + up);
    else
      path_.link_to(to + up);
    path_.link_to(to);
  }

  void come_from_above(const Approach& in, std::optional<double> stands_to_mm) {
    const Vec3& to = in.tips.front();
    const double plunge_from = in.begins_in_air ? to.z : chooser_.plunge_from_mm(to, stands_to_mm);
    Link link;
    if (!before_.empty()) {
      cut_along(way_out(rule_, before_));
      link = chooser_.choose_from_above(path_.position(), to, stands_to_mm);
    }
    if (link.kind == LinkKind::over) {
      path_.link_to({path_.position().x, path_.position().y, link.over_z_mm});
      path_.link_to({to.x, to.y, link.over_z_mm});
    } else {
      path_.rapid_over_to({to.x, to.y, chooser_.rapid_to_mm(plunge_from)});
    }
    if (path_.position().z > plunge_from) path_.link_to({to.x, to.y, plunge_from});
    path_.plunge_to(to);
  }

  void cut_along(const Approach& way) {
    for (const Vec3& tip : way.tips) path_.cut_to(tip);
  }

  ApproachRule rule_;
  LinkChooser chooser_;
  PathBuilder path_;
  double ramp_slope_;
  std::vector<Vec3> before_;  ///< tips of the pass cut last
};

}  // namespace

double clear_height_mm(const CutterLocations& locations, const StageRequest& request) {
  // Of an empty extent minus infinity.
  return clear_height_mm(request, locations.extent().high.z);
}

model::Toolpath link_passes(const std::vector<std::vector<CutPass>>& groups,
                            const CutterLocations& locations, const StageRequest& request,
                            const model::RunControl& control) {
  const double clear_z =
      std::max(clear_height_mm(locations, request), clear_height_mm(request, highest_tip(groups)));
  Linker linker(locations, request, clear_z);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    linker.cut_group(groups[g], control);
    control.report(static_cast<double>(g + 1) / static_cast<double>(groups.size()));
  }
  return linker.take();
}

}  // namespace limitgauge::engine::strategy
