#include "engine/strategy/steep_shallow.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "engine/strategy/boundary_pass.h"
#include "engine/strategy/contact_mask.h"
#include "engine/strategy/level_choice.h"
#include "engine/strategy/pass_clip.h"
#include "engine/strategy/row_places.h"
#include "engine/strategy/sampled_rows.h"
#include "engine/strategy/waterline.h"

namespace limitgauge::engine::strategy {
namespace {

using Groups = std::vector<std::vector<CutPass>>;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180;
}
double overlap_of(const StageRequest& request) {
  return request.cut.overlap_mm.value_or(2 * request.cut.step_mm);
}

/// Cells so small that a step sees what lies between two passes, and the cutter its own radius.
double cell_size(const StageRequest& request) {
  constexpr double kOfStep = 0.5, kOfRadius = 0.25;
  return std::min(kOfStep * request.cut.step_mm, kOfRadius * request.cutter.radius_mm());
}

void require_serves(const StageRequest& request) {
  const double angle = request.cut.steep_angle_deg;
  if (!(angle > 0 && angle < 90))
    throw std::invalid_argument("steep_angle must lie between 0 and 90 degrees");
  if (!(overlap_of(request) >= 0)) throw std::invalid_argument("overlap must be zero or more");
}

CutPass row_pass(std::vector<Vec3> tips, const StageRequest& request) {
  CutPass pass;
  pass.tips = std::move(tips);
  pass.reversible = request.cut.pattern == RowPattern::zigzag;
  return pass;
}

CutPass contour_pass(ClippedPass clipped, const StageRequest& request) {
  CutPass pass;
  pass.tips = std::move(clipped.tips);
  pass.closed = clipped.closed;
  if (request.cut.direction == CutDirection::conventional)
    std::reverse(pass.tips.begin(), pass.tips.end());
  pass.reversible = request.cut.direction == CutDirection::either;
  return pass;
}

class SteepShallowPlanner {
 public:
  SteepShallowPlanner(const surface::PatchModel& model, const StageRequest& request,
                      const model::RunControl& control)
      : model_(model),
        request_(request),
        control_(control),
        limit_(limit_locations(model, request)) {}

  StagePath plan() {
    regions_ = find_regions(model_, limit_, request_, control_);
    StagePath stage;
    add_contours(stage);
    add_rows(stage);
    if (request_.cut.boundary_pass)
      groups_.push_back(boundary_passes(model_, limit_, request_, control_));
    stage.path = link_passes(groups_, limit_.surface, request_, control_);
    return stage;
  }

 private:
  void add_contours(StagePath& stage) {
    LevelRule rule;
    rule.distance_mm = tip_distance_mm(request_);
    rule.lowest_mm = regions_.lowest_mm;
    const std::vector<double> levels =
        choose_levels(regions_.slopes, regions_.contours, regions_.steep, rule);
    const double tolerance = (1 - 2 * kLimitMeshShare) * request_.cut.tolerance_mm;
    for (auto& level : waterlines(limit_.surface, regions_.tips, levels, tolerance, control_)) {
      std::vector<CutPass> passes;
      for (const Waterline& line : level)
        for (ClippedPass& clipped :
             clip_to(line.tips, line.closed, regions_.contours, overlap_of(request_)))
          passes.push_back(contour_pass(std::move(clipped), request_));
      if (passes.empty()) continue;
      ++stage.planes;
      groups_.push_back(std::move(passes));
    }
  }

  void add_rows(StagePath& stage) {
    const DriveRows made = make_sampled_rows(limit_, request_, control_);
    set_intervals(stage, made.sampling_intervals);
    const SteepClip steep{radians(request_.cut.steep_angle_deg), overlap_of(request_)};
    std::vector<CutPass> passes;
    for (const DriveRow& row : made.rows) {
      const std::size_t before = passes.size();
      for (const auto& run : row.runs)
        for (ClippedPass& clipped : clip_row(run, regions_.rows, steep))
          passes.push_back(row_pass(std::move(clipped.tips), request_));
      if (passes.size() > before) ++stage.planes;
    }
    groups_.push_back(std::move(passes));
  }

 public:
  static void set_intervals(StagePath& stage, std::vector<int> intervals) {
    const auto [least, most] = std::minmax_element(intervals.begin(), intervals.end());
    if (least != intervals.end()) {
      stage.sampling_interval_min = *least;
      stage.sampling_interval_max = *most;
    }
    stage.sampling_intervals = std::move(intervals);
  }

 private:
  const surface::PatchModel& model_;
  const StageRequest& request_;
  const model::RunControl& control_;
  LimitLocations limit_;
  SteepRegions regions_;
  Groups groups_;
};

}  // namespace

SteepRegions find_regions(const surface::PatchModel& model, const LimitLocations& limit,
                          const StageRequest& request, const model::RunControl& control) {
  SteepRegions regions;
  const double cell = cell_size(request), overlap = overlap_of(request);
  regions.tips = make_tip_raster(limit.surface, limit.surface.extent().grown(2 * cell), cell,
                                 control);
  const ContactReach reach =
      contact_reach(model, limit, request.cutter, regions.tips.raster);
  regions.lowest_mm = std::max(reach.lowest_mm, request.floor_z_mm);
  regions.slopes = measure_slopes(regions.tips, regions.lowest_mm);
  const double angle = radians(request.cut.steep_angle_deg);
  regions.steep = steep_cells(regions.slopes, angle);
  const CellMask touched = grown(reach.cells, regions.slopes, overlap);
  regions.contours = both(grown(regions.steep, regions.slopes, overlap), touched);
  regions.rows =
      both(grown(shallow_cells(regions.slopes, angle), regions.slopes, overlap), touched);
  return regions;
}

StagePath plan_steep_shallow(const surface::FinishModel& model, const StageRequest& request,
                             const model::RunControl& control) {
  require_serves(request);
  return SteepShallowPlanner(model.patches(), request, control).plan();
}

StagePath plan_sampled_zigzag(const surface::FinishModel& model, const StageRequest& request,
                              const model::RunControl& control) {
  const LimitLocations limit = limit_locations(model.patches(), request);
  const DriveRows made = make_sampled_rows(limit, request, control);
  StagePath stage;
  stage.planes = static_cast<int>(made.rows.size());
  SteepShallowPlanner::set_intervals(stage, made.sampling_intervals);
  Groups groups(1);
  for (const DriveRow& row : made.rows)
    for (const auto& run : row.runs) groups.front().push_back(row_pass(run, request));
  if (request.cut.boundary_pass)
    groups.push_back(boundary_passes(model.patches(), limit, request, control));
  stage.path = link_passes(groups, limit.surface, request, control);
  return stage;
}

}  // namespace limitgauge::engine::strategy
