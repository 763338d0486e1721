#include "engine/strategy/strategies.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/strategy/axes/leaning_rows.h"
#include "model/base/clock.h"

namespace limitgauge::engine::strategy {
namespace {

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

void require_positive(double value, const std::string& name) {
  require(std::isfinite(value) && value > 0, name + " must be a positive number");
}

void require_valid(const StageRequest& request) {
  model::require_valid(request.cutter);
  const model::CutterType type = request.cutter.type;
  require(type != model::CutterType::drill && type != model::CutterType::apt,
          "cutter: a strategy takes flat, ball, bull or taper");
  model::require_valid(request.stock);
  require_positive(request.cut.step_mm, "step");
  require_positive(request.cut.tolerance_mm, "tolerance");
  require_positive(request.cut.feed_mm_min, "feed");
  require_positive(request.cut.plunge_feed_mm_min, "plunge_feed");
  require_positive(request.clearance_mm, "clearance");
  require(std::isfinite(request.allowance_mm) && request.allowance_mm >= 0,
          "allowance must be zero or more");
  require(std::isfinite(request.floor_z_mm), "floor must be a finite height");
  require(!request.cut.scallop_mm ||
              (std::isfinite(*request.cut.scallop_mm) && *request.cut.scallop_mm > 0),
          "scallop must be a positive number");
}

StagePath plan(const surface::FinishModel& model, const StageRequest& request,
               const model::RunControl& control) {
  switch (request.cut.strategy) {
    case Strategy::contour:
      return plan_contour(model, request, control);
    case Strategy::zigzag:
      if (request.cut.lean)
        return LeaningRows(model, request, control).leaning(request.cut.lean->tilt_deg);
      return plan_zigzag(model, request, control);
    case Strategy::steep_shallow:
      return plan_steep_shallow(model, request, control);
    case Strategy::rest:
      return plan_rest(model, request, control);
  }
  throw std::invalid_argument("strategy: expected contour, zigzag, steep_shallow or rest");
}

}  // namespace

StagePath plan_stage(const surface::FinishModel& model, const StageRequest& request,
                     const model::RunControl& control) {
  require_valid(request);
  const model::Stopwatch watch;
  StagePath stage = plan(model, request, control);
  const std::size_t of_move = sizeof(model::Move) + (stage.axes ? sizeof(model::Vec3) : 0);
  stage.memory_bytes = stage.path.moves.size() * of_move;
  stage.seconds = watch.seconds();
  return stage;
}

}  // namespace limitgauge::engine::strategy
