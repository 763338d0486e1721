#include "engine/strategy/axes/leaning_rows.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "engine/strategy/axes/leaning_axis.h"
#include "engine/strategy/axes/leaning_path.h"
#include "engine/strategy/rows/drive_rows.h"
#include "engine/strategy/rows/zigzag.h"
#include "model/base/clock.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

/// Of a ball's radius: the normal is that of the ball's heights so far to either side, so that it
/// turns evenly over creases.
constexpr double kNormalWidth = 0.5;

void require_leaning(const StageRequest& request) {
  const CutOptions& cut = request.cut;
  if (!cut.lean) throw std::invalid_argument("rows lean by a lead and a tilt");
  if (cut.strategy != Strategy::zigzag || request.cutter.type != model::CutterType::ball)
    throw std::invalid_argument("tilt: the rows of a zigzag lean, cut by a ball");
  if (cut.boundary_pass) throw std::invalid_argument("boundary_pass: of no use where rows lean");
  if (!(std::abs(cut.lean->lead_deg) <= kMostLean_deg))
    throw std::invalid_argument("lead must lie between -60 and 60 degrees");
}

/// Links are weighed for the ball alone: shank and holder do not stand above it.
StageRequest ball_alone(StageRequest request) {
  request.cutter.shank.clear();
  request.cutter.holder.clear();
  return request;
}

}  // namespace

LeaningRows::LeaningRows(const surface::FinishModel& model, const StageRequest& request,
                         const model::RunControl& control)
    : model_(model), control_(control), request_(request) {
  require_leaning(request);
  if (request.cut.lean->from == LeanFrom::surface)
    surface_ = limit_locations(model.patches(), ball_alone(request)).surface;
}

double LeaningRows::centre_height_mm(double x, double y) const {
  return surface_->tip_z_above(x, y, request_.floor_z_mm).value_or(request_.floor_z_mm);
}

/// Of the surface that the ball's centre goes on, by its heights to either side.
Vec3 LeaningRows::normal_at(double x, double y) const {
  const double h = kNormalWidth * request_.cutter.radius_mm();
  const Vec3 slope{(centre_height_mm(x + h, y) - centre_height_mm(x - h, y)) / (2 * h),
                   (centre_height_mm(x, y + h) - centre_height_mm(x, y - h)) / (2 * h), 0};
  const double steep = length(slope), most = std::tan(model::radians(kSteepestNormal_deg));
  return normalized(Vec3{0, 0, 1} - slope * (steep > most ? most / steep : 1));
}

StagePath LeaningRows::leaning(double tilt_deg) const {
  if (!(std::abs(tilt_deg) <= kMostLean_deg))
    throw std::invalid_argument("tilt must lie between -60 and 60 degrees");
  LeanRule rule{*request_.cut.lean, DriveFrame(request_.cut.angle_deg).to_part({1, 0, 0})};
  rule.lean.tilt_deg = tilt_deg;
  rule.bow_mm = kBowShare * request_.cut.tolerance_mm;
  if (surface_) {
    rule.normal = [this](double x, double y) { return normal_at(x, y); };
    rule.spacing_mm = kNormalWidth * request_.cutter.radius_mm();
  }
  const model::Stopwatch watch;
  StageRequest ball = ball_alone(request_);
  ball.cut.lean->tilt_deg = tilt_deg;
  StagePath stage = plan_zigzag(model_, ball, control_);
  LeaningPath made = lean_path(stage.path, request_.cutter, rule);
  stage.path = std::move(made.path);
  stage.axes = std::move(made.axes);
  stage.seconds = watch.seconds();
  stage.memory_bytes = stage.path.moves.size() * (sizeof(model::Move) + sizeof(Vec3));
  return stage;
}

}  // namespace limitgauge::engine::strategy
