#include "engine/strategy/stage_path.h"

#include <chrono>
#include <cmath>
#include <stdexcept>
#include <string>

#include "engine/strategy/contour.h"
#include "engine/strategy/zigzag.h"

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
  model::require_valid(request.stock);
  require_positive(request.cut.step_mm, "step");
  require_positive(request.cut.tolerance_mm, "tolerance");
  require_positive(request.cut.feed_mm_min, "feed");
  require_positive(request.cut.plunge_feed_mm_min, "plunge_feed");
  require_positive(request.clearance_mm, "clearance");
  require(std::isfinite(request.allowance_mm) && request.allowance_mm >= 0,
          "allowance must be zero or more");
  require(std::isfinite(request.floor_z_mm), "floor must be a finite height");
  require(request.cut.strategy == Strategy::contour || request.cut.strategy == Strategy::zigzag,
          "strategy: expected contour or zigzag");
  require(
      request.cut.strategy != Strategy::zigzag || request.cutter.type == model::CutterType::ball,
      "cutter: zigzag serves ball cutters only; use contour for this one");
}

}  // namespace

StagePath plan_stage(const surface::FinishModel& model, const StageRequest& request,
                     const model::RunControl& control) {
  require_valid(request);
  const auto begin = std::chrono::steady_clock::now();
  StagePath stage = request.cut.strategy == Strategy::zigzag
                        ? plan_zigzag(model, request, control)
                        : plan_contour(model, request, control);
  stage.memory_bytes = stage.path.moves.size() * sizeof(model::Move);
  stage.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return stage;
}

}  // namespace limitgauge::engine::strategy
