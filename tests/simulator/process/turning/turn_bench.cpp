#include "tests/simulator/process/turning/turn_bench.h"

#include <cmath>

#include "model/base/angle.h"

namespace limitgauge::simulator::test {

using model::Pose;
using model::Vec3;

Pose shifted(const Vec3& by) {
  Pose pose;
  pose.shift_mm = by;
  return pose;
}

Pose Swing::at(double t) const {
  return shifted(pivot) * turn_about(axis, from_deg + (to_deg - from_deg) * t) *
         shifted(pivot * -1) * tool;
}

TurningPose Swing::pose() const {
  const double turn = model::radians(std::abs(to_deg - from_deg));
  return TurningPose::even([*this](double t) { return at(t); },
                           turn * distance(tool.shift_mm, pivot), turn);
}

Swing pendulum(double arm_mm, double from_deg, double to_deg) {
  return {shifted({0, 0, 50 - arm_mm}), {0, 0, 50}, {0, 1, 0}, from_deg, to_deg};
}

TurningPose parked() {
  return TurningPose::even([](double) { return shifted({0, 0, 1000}); }, 0, 0);
}

TurningTool rapid_turn(const TurningPose& in_stock) {
  return {7, true, in_stock, {}};
}
TurningTool feed_turn(const TurningPose& in_stock) {
  return {7, false, in_stock, {}};
}

std::vector<Finding> turn_findings(const StockModel& stock, const model::Cutter& cutter,
                                   const TurningTool& motion, const ProcessLimits& limits,
                                   unsigned threads) {
  return check_turn(stock, cutter, motion, limits, {threads});
}

StockModel slotted_block() {
  Pass leaning = PathBuilder({-20, 1, -2}).feed({20, 1, -2}).pass(ball4());
  leaning.pose = model::turn_about({1, 0, 0}, 35);
  Pass side = PathBuilder({-12, -3, -14}).feed({12, -3, -14}).pass(flat4());
  side.pose = model::turn_about({1, 0, 0}, 90);
  return block()
      .cut(PathBuilder({-20, -4, -3}).feed({5, -4, -3}).feed({5, 4, -4}).pass(flat4()), {2})
      .cut(leaning, {2})
      .cut(side, {2});
}

}  // namespace limitgauge::simulator::test
