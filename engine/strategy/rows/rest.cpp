#include "engine/strategy/strategies.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/strategy/levels/steep_shallow.h"
#include "engine/strategy/linking/cut_pass.h"
#include "engine/strategy/raster/clip.h"

namespace limitgauge::engine::strategy {
namespace {

class RegionClip {
  auto wanted() const {
    return [this](const model::Vec3& tip) { return comes_near_regions(request_, overlap_, tip); };
  }

 public:
  explicit RegionClip(const StageRequest& request)
      : request_(request), overlap_(request.cut.overlap_or_default_mm()) {}

  void add_to(std::vector<CutPass>& kept, CutPass pass) const {
    const auto outside = std::find_if_not(pass.tips.begin(), pass.tips.end(), wanted());
    if (pass.closed) {
      if (outside == pass.tips.end() && whole_ring(pass)) {
        kept.push_back(std::move(pass));
        return;
      }
      if (outside != pass.tips.end()) std::rotate(pass.tips.begin(), outside, pass.tips.end());
      pass.tips.push_back(pass.tips.front());
    }
    for (auto& run : runs(pass.tips)) {
      CutPass part = pass;
      part.closed = false;
      part.tips = std::move(run);
      if (part.tips.size() > 1) kept.push_back(std::move(part));
    }
  }

 private:
  /// Regions reach over a step at least on either side, so none is stepped over.
  std::vector<Polyline<model::Vec3>> runs(const Polyline<model::Vec3>& tips) const {
    constexpr double kOfStep = 0.5;
    return clipped(
        tips, kOfStep * request_.cut.step_mm, wanted(),
        [](const model::Vec3& a, const model::Vec3& b, double t) { return lerp(a, b, t); },
        [](const model::Vec3& a, const model::Vec3& b) { return distance(a, b); });
  }
  bool whole_ring(const CutPass& pass) const {
    Polyline<model::Vec3> ring = pass.tips;
    ring.push_back(ring.front());
    const auto parts = runs(ring);
    return parts.size() == 1 && parts[0].size() == ring.size();
  }

  const StageRequest& request_;
  double overlap_;
};

std::vector<CutPass> clipped_passes(const RegionClip& clip, std::vector<CutPass> passes) {
  std::vector<CutPass> kept;
  for (CutPass& pass : passes) clip.add_to(kept, std::move(pass));
  return kept;
}

}  // namespace

bool comes_near_regions(const StageRequest& request, double overlap_mm, const model::Vec3& tip) {
  const double corner = request.cutter.corner_radius_mm;
  const double flat = request.cutter.radius_mm() - corner, height = tip.z + corner;
  const double reach = corner + request.allowance_mm + overlap_mm;
  return std::any_of(request.regions.begin(), request.regions.end(), [&](const model::Box3& box) {
    const double x = std::max({box.low.x - tip.x, 0.0, tip.x - box.high.x});
    const double y = std::max({box.low.y - tip.y, 0.0, tip.y - box.high.y});
    const double beside = std::max(0.0, std::hypot(x, y) - flat);
    const double above = std::max({box.low.z - height, 0.0, height - box.high.z});
    return std::hypot(beside, above) <= reach;
  });
}

StagePath plan_rest(const surface::FinishModel& model, const StageRequest& request,
                    const model::RunControl& control) {
  const LimitLocations limit = limit_locations(model.patches(), request);
  StagePath stage;
  if (request.regions.empty()) {
    const model::Box3 stock = model::bounding_box(request.stock);
    stage.path.start = {stock.low.x, stock.low.y, clear_height_mm(limit.surface, request)};
    set_intervals(stage, limit.sampler.intervals());
    return stage;
  }
  SteepShallowPasses made = steep_shallow_passes(model.patches(), limit, request, control);
  const RegionClip clip(request);
  std::vector<std::vector<CutPass>> groups;
  for (auto& level : made.levels) groups.push_back(clipped_passes(clip, std::move(level)));
  groups.push_back(clipped_passes(clip, std::move(made.rows)));
  std::erase_if(groups, [](const auto& group) { return group.empty(); });
  stage.planes = static_cast<int>(groups.size());
  set_intervals(stage, std::move(made.sampling_intervals));
  stage.path = link_passes(groups, limit.surface, request, control);
  return stage;
}

}  // namespace limitgauge::engine::strategy
