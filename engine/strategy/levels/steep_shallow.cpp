#include "engine/strategy/levels/steep_shallow.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "engine/strategy/levels/level_choice.h"
#include "engine/strategy/levels/waterline.h"
#include "engine/strategy/linking/cut_pass.h"
#include "engine/strategy/linking/pass_clip.h"
#include "engine/strategy/locations/cutter_shape.h"
#include "engine/strategy/raster/contact_mask.h"
#include "engine/strategy/rows/ball_rows.h"
#include "engine/strategy/rows/boundary_pass.h"
#include "engine/strategy/rows/row_places.h"
#include "engine/strategy/rows/sampled_rows.h"
#include "engine/strategy/strategies.h"
#include "model/base/angle.h"

namespace limitgauge::engine::strategy {
namespace {

/// How far the cells of a steep contact may be from it, in cells: their corners see its slope.
constexpr double kNearCells = 2;
/// Share of the tolerance by which leaving out points may move a row: contours end beside rows, so
/// these come as close as those.
constexpr double kRowsReductionShare = 0.1;

/// Cells so small that a step sees what lies between two passes, and the cutter its own radius.
double cell_size(const StageRequest& request) {
  constexpr double kOfStep = 0.5, kOfRadius = 0.25;
  return std::min(kOfStep * request.cut.step_mm, kOfRadius * request.cutter.radius_mm());
}

/// Whether the cutter is a ball, and shank and holder stay above the part wherever it touches that.
bool touches_with_ball_alone(const LimitLocations& limit, const StageRequest& request) {
  if (request.cutter.type != model::CutterType::ball) return false;
  const std::vector<CutterShape> bodies = cutter_shapes(request.cutter, limit.kept_mm, true);
  return std::all_of(bodies.begin() + 1, bodies.end(), [&](const CutterShape& body) {
    return limit.lowest_contact_mm + body.bottom_mm() > limit.part.high.z;
  });
}

void require_serves(const StageRequest& request) {
  const double angle = request.cut.steep_angle_deg;
  if (!(angle > 0 && angle < 90))
    throw std::invalid_argument("steep_angle must lie between 0 and 90 degrees");
  if (!(request.cut.overlap_or_default_mm() >= 0))
    throw std::invalid_argument("overlap must be zero or more");
}

/// Half a turn of the cutter around an edge is cut on: it is shorter than a retract.
BridgeRule bridge_rule(const SteepRegions& regions, const StageRequest& request) {
  const double half_turn = std::numbers::pi * request.cutter.radius_mm();
  const double overlap = request.cut.overlap_or_default_mm();
  return {regions.touched, overlap, overlap + half_turn};
}

void add_contours(const LimitLocations& limit, const SteepRegions& regions,
                  const StageRequest& request, const model::RunControl& control,
                  SteepShallowPasses& made) {
  const LevelRule levels_by{tip_distance_mm(request), regions.lowest_mm};
  const BridgeRule rule = bridge_rule(regions, request);
  const std::vector<double> levels =
      choose_levels(regions.slopes, regions.contours, regions.steep, levels_by);
  // The mesh has its share twice, see kLimitMeshShare.
  const double tolerance = (1 - 2 * kLimitMeshShare) * request.cut.tolerance_mm;
  const CurveNeed need{regions.contours, rule.longest_mm, regions.touched, rule.repeated_mm};
  for (const auto& level :
       waterlines(limit.surface, regions.tips, need, levels, tolerance, control)) {
    std::vector<CutPass> passes;
    for (const Waterline& line : level)
      for (ClippedPass& clipped : clip_to(line.tips, line.closed, regions.contours, rule))
        passes.push_back(contour_pass(std::move(clipped.tips), clipped.closed, request));
    if (passes.empty()) continue;
    ++made.planes;
    made.levels.push_back(std::move(passes));
  }
}

/// Raises the ends of chords by what the exact surface asks for: rows from sections rest on another
/// mesh. Ends that are higher than a chord asks for only take it farther away.
void raise_clear(const CutterLocations& surface, std::vector<Vec3>& tips) {
  std::vector<double> by(tips.size(), 0);
  for (std::size_t i = 1; i < tips.size(); ++i) {
    const double lift = surface.lift_above(tips[i - 1], tips[i], 0).value_or(0);
    by[i - 1] = std::max(by[i - 1], lift);
    by[i] = std::max(by[i], lift);
  }
  for (std::size_t i = 0; i < tips.size(); ++i) tips[i].z += by[i];
}

void add_rows(const surface::PatchModel& model, const LimitLocations& limit,
              const SteepRegions& regions, const StageRequest& request,
              const model::RunControl& control, SteepShallowPasses& made) {
  DriveRows rows = touches_with_ball_alone(limit, request)
                       ? make_ball_rows(model, request, control, {kRowsReductionShare})
                       : make_sampled_rows(limit, request, control);
  made.sampling_intervals = std::move(rows.sampling_intervals);
  const SteepClip steep{model::radians(request.cut.steep_angle_deg),
                        request.cut.overlap_or_default_mm()};
  for (const DriveRow& row : rows.rows) {
    const std::size_t before = made.rows.size();
    for (const auto& run : row.runs)
      for (ClippedPass& clipped :
           clip_row(run, regions.rows, bridge_rule(regions, request), steep)) {
        raise_clear(limit.surface, clipped.tips);
        made.rows.push_back(row_pass(std::move(clipped.tips), request));
      }
    if (made.rows.size() > before) ++made.planes;
  }
}

}  // namespace

SteepRegions find_regions(const surface::PatchModel& model, const LimitLocations& limit,
                          const StageRequest& request, const model::RunControl& control) {
  SteepRegions regions;
  const double cell = cell_size(request), overlap = request.cut.overlap_or_default_mm();
  const model::Box3 window = limit.surface.fluted_extent().grown(2 * cell);
  regions.tips = touches_with_ball_alone(limit, request)
                     ? make_ball_raster(model, request, window, cell, control)
                     : make_tip_raster(limit.surface, window, cell, control);
  // What shank, holder or a taper's flank hold up alone is as good as nothing.
  for (double& z : regions.tips.z)
    if (z < limit.lowest_contact_mm) z = -std::numeric_limits<double>::infinity();
  const ContactReach reach = contact_reach(model, limit, request, regions.tips.raster);
  regions.lowest_mm = std::max(reach.lowest_mm, request.floor_z_mm);
  regions.slopes = measure_slopes(regions.tips, regions.lowest_mm);
  const double angle = model::radians(request.cut.steep_angle_deg);
  // Steep places of the cutter location surface that no steep place of the part asks for roll over
  // its boundary or a crease.
  regions.steep = both(steep_cells(regions.slopes, angle),
                       grown(reach.steep, regions.slopes, kNearCells * cell));
  regions.touched = grown(reach.cells, regions.slopes, overlap);
  regions.contours = both(grown(regions.steep, regions.slopes, overlap), regions.touched);
  regions.rows =
      both(grown(shallow_cells(regions.slopes, angle), regions.slopes, overlap), regions.touched);
  return regions;
}

SteepShallowPasses steep_shallow_passes(const surface::PatchModel& model,
                                        const LimitLocations& limit, const StageRequest& request,
                                        const model::RunControl& control) {
  require_serves(request);
  const SteepRegions regions = find_regions(model, limit, request, control);
  SteepShallowPasses made;
  add_contours(limit, regions, request, control, made);
  add_rows(model, limit, regions, request, control, made);
  return made;
}

StagePath plan_steep_shallow(const surface::FinishModel& model, const StageRequest& request,
                             const model::RunControl& control) {
  const LimitLocations limit = limit_locations(model.patches(), request);
  SteepShallowPasses made = steep_shallow_passes(model.patches(), limit, request, control);
  StagePath stage;
  stage.planes = made.planes;
  set_intervals(stage, std::move(made.sampling_intervals));
  std::vector<std::vector<CutPass>> groups = std::move(made.levels);
  groups.push_back(std::move(made.rows));
  if (request.cut.boundary_pass) groups.push_back(boundary_passes(limit, request, control));
  stage.path = link_passes(groups, limit.surface, request, control);
  return stage;
}

}  // namespace limitgauge::engine::strategy
