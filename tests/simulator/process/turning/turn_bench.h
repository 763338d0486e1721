#pragma once

#include <vector>

#include "simulator/process/turning/turn_check.h"
#include "tests/simulator/process/process_bench.h"

namespace limitgauge::simulator::test {

/// A tool that stands as `tool` says and is turned about `axis` through `pivot`.
struct Swing {
  model::Pose tool;
  model::Vec3 pivot, axis{0, 1, 0};
  double from_deg = 0, to_deg = 0;

  model::Pose at(double t) const;
  TurningPose pose() const;
};

/// As a head does that hangs over the block: about Y through (0, 0, 50), the tool pointing down,
/// its tip `arm_mm` from there.
Swing pendulum(double arm_mm, double from_deg = -50, double to_deg = 60);
/// Standing still, far above everything.
TurningPose parked();

model::Pose shifted(const model::Vec3& by);

/// A rapid, among no fixtures.
TurningTool rapid_turn(const TurningPose& in_stock);
TurningTool feed_turn(const TurningPose& in_stock);
std::vector<Finding> turn_findings(const StockModel& stock, const model::Cutter& cutter,
                                   const TurningTool& motion,
                                   const ProcessLimits& limits = plain_limits(),
                                   unsigned threads = 2);

/// The block with a slot along X, one that leans, and one from the side.
StockModel slotted_block();

}  // namespace limitgauge::simulator::test
