#include "tests/benchmark/aircraft_stages.h"

#include <memory>

#include "engine/strategy/strategies.h"
#include "engine/surface/patch_model.h"
#include "model/part/cage_obj.h"
#include "tests/benchmark/dome_finish.h"
#include "tests/support/folders.h"

namespace limitgauge::benchmarks {
namespace {

using engine::strategy::CutDirection;
using engine::strategy::StageRequest;
using engine::strategy::Strategy;
using engine::surface::FinishModel;

StageRequest stage_request(const char* cutter) {
  StageRequest r;
  r.cutter = model::parse_cutter(cutter);
  r.stock = kBlock;
  r.clearance_mm = 2;
  r.cut.angle_deg = 90;
  return r;
}

StageRequest rough_request() {
  StageRequest r = stage_request("flat:D=8,L=25");
  r.cut.strategy = Strategy::contour;
  r.cut.direction = CutDirection::climb;
  r.cut.step_mm = 0.2;
  r.cut.tolerance_mm = 0.05;
  r.cut.feed_mm_min = r.cut.link_feed_mm_min = 1200;
  r.cut.plunge_feed_mm_min = 300;
  r.allowance_mm = 0.2;
  r.floor_z_mm = -3;
  return r;
}

StageRequest rows_request(const FinishModel& model, double step_mm, double allowance_mm,
                          double tolerance_mm) {
  StageRequest r = stage_request("ball:D=6,L=20");
  r.cut.strategy = Strategy::zigzag;
  r.cut.step_mm = step_mm;
  r.cut.tolerance_mm = tolerance_mm;
  r.cut.feed_mm_min = r.cut.link_feed_mm_min = 1500;
  r.cut.plunge_feed_mm_min = 400;
  r.allowance_mm = allowance_mm;
  r.floor_z_mm = model.patches().bounding_box().low.z - r.cutter.radius_mm();
  return r;
}

simulator::Pass planned(const FinishModel& model, const StageRequest& request) {
  auto stage = plan_stage(model, request, {2, nullptr, {}});
  return {request.cutter, std::make_shared<const model::Toolpath>(std::move(stage.path))};
}

AircraftStages plan_stages() {
  const model::Cage cage = model::read_cage_obj(tests::fixtures() / "cages/aircraft.obj");
  // The semi-finish stage asks for the largest offset: radius, allowance and tolerance.
  const FinishModel model(cage, {0.01, kRadius_mm + 0.2 + 0.02, 10}, {2, nullptr, {}});
  return {planned(model, rough_request()), planned(model, rows_request(model, 0.25, 0.2, 0.02)),
          planned(model, rows_request(model, 0.1, 0, 0.005))};
}

}  // namespace

const AircraftStages& aircraft_stages() {
  static const AircraftStages stages = plan_stages();
  return stages;
}

}  // namespace limitgauge::benchmarks
