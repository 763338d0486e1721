#pragma once

#include <optional>

#include "model/machine/turning_motion.h"

namespace limitgauge::model::gcode {

/// Where a machine's rotary axes stand, and what the control makes of programmed places meanwhile.
struct Orientation {
  std::optional<Kinematics> machine;  ///< empty: no axis of it turns
  RotaryAngles angles_deg{};
  bool tool_centred = false;       ///< G43.4, G43.5, G234, M428
  bool by_vector = false;          ///< G43.5: I, J and K are the tool's axis
  bool dynamic_offset = false;     ///< G254
  std::optional<Pose> plane;       ///< of G68.2: from it to the active work frame
  bool control_is_assumed = true;  ///< nobody said whether places are joints or the tip's
  bool frame_is_told = false;      ///< what the above lean on has been listed as assumed

  /// Whether programmed places lie otherwise than along the machine's axes at zero.
  bool transforms() const { return tool_centred || dynamic_offset || plane.has_value(); }
  bool is_turned() const { return angles_deg != RotaryAngles{}; }
};

}  // namespace limitgauge::model::gcode
