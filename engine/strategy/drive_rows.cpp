#include "engine/strategy/drive_rows.h"

#include "engine/strategy/ball_rows.h"
#include "engine/strategy/sampled_rows.h"

namespace limitgauge::engine::strategy {

DriveRows make_rows(const surface::FinishModel& model, const StageRequest& request,
                    const model::RunControl& control) {
  if (request.cutter.type == model::CutterType::ball)
    return make_ball_rows(model, request, control);
  return make_sampled_rows(model, request, control);
}

}  // namespace limitgauge::engine::strategy
