#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "model/geometry/pose.h"
#include "simulator/process/tool_bodies.h"
#include "simulator/stock/material.h"

namespace limitgauge::simulator {

/// How a tool moves among something else over t in [0, 1].
struct TurningPose {
  /// The tool's frame, tip at its zero and +Z up its axis, in the other's. May be asked from
  /// several threads at once.
  std::function<model::Pose(double t)> at;
  double tip_speed_mm = 0;  ///< the tip never goes faster than this, by t
  double turn_rad = 0;      ///< the tool never turns faster than this, by t
};

/// The place of a body that comes deepest into a solid, and when.
struct DeepestTurn {
  double t = 0;
  model::Vec3 in_tool;  ///< in the tool's frame
  double depth_mm = 0;  ///< there; minus the distance where nothing touches
  bool proven = true;   ///< false: the search was given up, and it may be deeper anywhere
};

/// The deepest place of `body` in `solid` while it moves as `pose` says, if it is deeper than
/// `least_mm` (negative: nearer than that). What is deeper than `least_mm` by `precision_mm` is
/// never missed, and the place found is as deep as the deepest but for `precision_mm`.
///
/// Branch and bound over blocks of the body's own frame and stretches of time: the depth in the
/// solid is 1-Lipschitz, and a place at distance r from the tip goes no faster than tip_speed_mm +
/// turn_rad r. Where that takes more looks than a few million it is given up.
std::optional<DeepestTurn> deepest_turn(const Material& solid, const ToolBody& body,
                                        const TurningPose& pose, double least_mm,
                                        double precision_mm);

}  // namespace limitgauge::simulator
