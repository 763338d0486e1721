#include "verifier/gate/stage_scene.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

#include "model/base/angle.h"
#include "verifier/gate/finer_passes.h"
#include "verifier/surface/surface_tree.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

/// For how long the rim of what can be reached is resolved. The contact of a flat moves far as the
/// normal turns, so its proofs take smaller cells. To a cutter as wide as the part every cell is
/// near every other, and of a drill's or an undercutting cutter's contacts no cell is proven: then
/// each is looked at once.
ReachOptions reach_effort(const CutterProfile& cutter, double area_mm2) {
  ReachOptions effort = kReachEffort;
  const double radius = cutter.rounding_mm + cutter.flat_mm;
  if (cutter.is_pointed() || cutter.undercuts() ||
      std::numbers::pi * radius * radius > area_mm2 / 2)
    effort.largest_cell_count = 1;
  else if (cutter.flat_mm > 0)
    effort.largest_cell_count = 250'000;
  return effort;
}

CertificateRequest request_of(const StageCheck& check) {
  const double unlimited = std::numeric_limits<double>::infinity();
  return {check.allowance_mm, check.limits.has_gouge ? check.limits.gouge_mm : unlimited,
          check.limits.has_uncut ? check.limits.uncut_mm : unlimited, check.resolution_mm,
          check.largest_cell_count};
}

/// Cells that are looked at for one of many ways in which a cutter stood.
constexpr std::size_t kCellsOfWay = 5000;

/// A cutter, and how the frame at work lies in the one in which it stood along +Z.
struct StandingCutter {
  model::Cutter cutter;
  std::string text;  ///< all of it but its name
  model::Pose to_own;
  bool among_others = false;  ///< the pass turns it as it goes: one of the ways in which it stood

  /// Where a frame lies decides nothing of reach.
  bool is_like(const StandingCutter& other) const {
    return text == other.text && to_own.rows == other.to_own.rows &&
           among_others == other.among_others;
  }
};

/// How the frame of a pass lies in one in which a cutter along `axis` is upright.
model::Pose upright_from(const model::Vec3& axis) {
  const model::Vec3 up{0, 0, 1}, about = cross(axis, up);
  if (!(length(about) > kUnitRounding))
    return axis.z > 0 ? model::Pose{} : model::turn_about({1, 0, 0}, 180);
  return model::turn_about(about, model::angle_between(axis, up) / model::radians(1));
}

/// Some of the ways in which a pass that turns its cutter has it stand at a feed, far from each
/// other: each the farthest from those before, until none is far.
std::vector<model::Vec3> ways_of(const Pass& pass) {
  constexpr std::size_t kMostWays = 12;
  constexpr double kNear_rad = 0.25;
  std::vector<model::Vec3> ways, all;
  for (std::size_t i = 0; i < pass.path->moves.size(); ++i)
    if (pass.path->moves[i].kind == model::MoveKind::feed) all.push_back(pass.axes->to[i]);
  if (all.empty()) all.push_back(pass.axes->start);
  std::vector<double> apart_rad(all.size(), std::numeric_limits<double>::infinity());
  std::size_t next = 0;
  do {
    ways.push_back(all[next]);
    for (std::size_t i = 0; i < all.size(); ++i)
      apart_rad[i] = std::min(apart_rad[i], model::angle_between(ways.back(), all[i]));
    next = static_cast<std::size_t>(std::max_element(apart_rad.begin(), apart_rad.end()) -
                                    apart_rad.begin());
  } while (ways.size() < kMostWays && apart_rad[next] > kNear_rad);
  return ways;
}

/// The cutters used so far, each of its kind and way once: that of the last pass first. A stage
/// that moves nothing at a feed has a cutter too: what it ought to have reached is asked of it.
std::vector<StandingCutter> distinct_cutters(std::span<const Pass> passes) {
  std::vector<StandingCutter> out;
  for (std::size_t k = passes.size(); k-- > 0;) {
    if (passes[k].only_positions && k + 1 < passes.size()) continue;
    StandingCutter cutter{passes[k].cutter, {}, passes[k].pose.inverse()};
    cutter.cutter.id.clear();
    cutter.text = to_text(cutter.cutter);
    const auto add = [&] {
      const bool known = std::any_of(out.begin(), out.end(), [&](const StandingCutter& other) {
        return other.is_like(cutter);
      });
      if (!known) out.push_back(cutter);
    };
    if (!passes[k].axes) {
      add();
      continue;
    }
    cutter.among_others = true;
    const model::Pose to_pass = cutter.to_own;
    for (const model::Vec3& way : ways_of(passes[k])) {
      cutter.to_own = upright_from(way) * to_pass;
      add();
    }
  }
  return out;
}

model::Box3 region_of(const ReferenceSurface& surface, double allowance_mm) {
  return surface.bounding_box().grown(std::max(0.0, allowance_mm) + kRounding_mm);
}

std::vector<Sweep> sweeps_of(std::span<const AssemblySweep> parts) {
  std::vector<Sweep> sweeps;
  for (const AssemblySweep& part : parts) sweeps.push_back(part.sweep);
  return sweeps;
}

/// Where one side's reach ends and the next one's begins, a cell is in reach as a whole of neither:
/// of balls, whose proofs are cheap there, the seam is resolved more finely.
ReachOptions seam_effort(ReachOptions effort) {
  constexpr double kSeam_mm = 0.012;
  constexpr std::size_t kMore = 4;
  effort.smallest_radius_mm = std::min(effort.smallest_radius_mm, kSeam_mm);
  if (effort.largest_cell_count > 1) effort.largest_cell_count *= kMore;
  return effort;
}

}  // namespace

ReachOfCutters::ReachOfCutters(const SurfaceCells& cells, std::span<const Pass> passes,
                               double allowance_mm, double area_mm2, bool resolves_seams) {
  std::vector<model::Pose> ways;  // beside turned_
  for (const StandingCutter& standing : distinct_cutters(passes)) {
    const model::Cutter& cutter = cutters.emplace_back(standing.cutter);
    searches.emplace_back(cells, cutter, allowance_mm, kContact_mm);
    efforts.push_back(reach_effort(CutterProfile(cutter), area_mm2));
    if (standing.among_others) {
      searches.back() = searches.back().among_others();
      efforts.back().largest_cell_count = std::min(efforts.back().largest_cell_count, kCellsOfWay);
    }
    if (!standing.to_own.turns()) continue;
    const auto same = std::find_if(ways.begin(), ways.end(), [&](const model::Pose& way) {
      return way.rows == standing.to_own.rows;
    });
    const auto at = static_cast<std::size_t>(same - ways.begin());
    if (same == ways.end()) {
      ways.push_back(standing.to_own);
      turned_.push_back(std::make_unique<const SurfaceCells>(cells.turned(standing.to_own)));
    }
    searches.back() = searches.back().from(*turned_[at], ways[at]);
  }
  for (std::size_t k = 0; resolves_seams && k < efforts.size() && !turned_.empty(); ++k)
    if (searches[k].profile().flat_mm <= 0) efforts[k] = seam_effort(efforts[k]);
}

StageScene::StageScene(const ReferenceSurface& surface, const model::Stock& raw_stock,
                       std::span<const Pass> passes, const StageCheck& check)
    : highest_mm(surface.bounding_box().high.z + check.allowance_mm + kRounding_mm),
      cells(surface.tree(), first_cell_radius_mm(surface.tree())),
      cut(raw_stock, passes),
      raw(raw_stock, {}),
      parts(assembly_sweeps(gouging(passes, check.finer_passes),
                            region_of(surface, check.allowance_mm))),
      by(cells, passes, check.allowance_mm, surface.area_mm2(), check.limits.has_unreachable),
      request(request_of(check)) {
  if (!check.finer_passes.empty()) fluted_.emplace(raw_stock, gouging(passes, check.finer_passes));
  if (!parts.empty()) swept_.emplace((fluted_ ? *fluted_ : cut).with(sweeps_of(parts)));
}

}  // namespace limitgauge::verifier
