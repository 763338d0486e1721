#include "engine/strategy/drive_rows.h"

#include <stdexcept>

#include "engine/strategy/ball_rows.h"

namespace limitgauge::engine::strategy {

DriveRows make_rows(const surface::FinishModel& model, const StageRequest& request,
                    const model::RunControl& control) {
  if (request.cutter.type == model::CutterType::ball)
    return make_ball_rows(model, request, control);
  throw std::invalid_argument("cutter: rows serve ball cutters only");
}

}  // namespace limitgauge::engine::strategy
