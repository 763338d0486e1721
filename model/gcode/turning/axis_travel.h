#pragma once

#include <cstdint>
#include <vector>

#include "model/gcode/program.h"

namespace limitgauge::model {

/// What motions of a machine with rotary axes are held against.
struct AxisTravel {
  const Kinematics& machine;
  /// Of X, Y and Z; infinite where an axis has no limit.
  Box3 limits_mm;
  /// To the frame of the limits, which is the machine's but for where its zero lies.
  Pose limits_from_machine = {};
  Vec3 start_mm = {};  ///< of the tip, in the machine's frame
  /// From the gauge line to the tip; without meaning where no head turns the tool.
  double tool_length_mm = 0;
};

/// A motion that takes X, Y or Z beyond a limit.
struct TravelBreach {
  std::size_t motion = 0;
  std::uint32_t line = 0;
  int axis = 0;         ///< the one that is farthest out
  bool above = false;   ///< ... beyond its upper limit
  double depth_mm = 0;  ///< by how much, somewhere on the motion: a lower bound of the most
};

/// Of motions [first, last) of `program`, by rising motion, those during which X, Y or Z stand
/// beyond a limit. They are taken as they show where the tip is while all rotary axes are at zero:
/// the gauge point less the tool's length along the machine's Z.
///
/// Ends of motions are exact but for rounding (1e-6 mm). Between them a motion that turns axes with
/// the tip under control, and an arc, may be beyond by 0.01 mm (kTravelLook_mm) without being
/// named. Heights that nothing states are not looked at, nor places of reference points that
/// nothing states.
std::vector<TravelBreach> beyond_travel(const Program& program, const AxisTravel& travel,
                                        std::size_t first, std::size_t last);

}  // namespace limitgauge::model
