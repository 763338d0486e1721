#pragma once

#include "model/machine/kinematics.h"

namespace limitgauge::model {

/// What a control makes of programmed places while rotary axes are not at zero.
enum class TipControl {
  joints,       ///< they move X, Y and Z, whatever that does to the tip
  tool_centre,  ///< they are the tip's in the workpiece: G43.4, G234, LinuxCNC's kinematics, G68.2
  dynamic_offset  ///< the tip's along the machine's axes, from where the work's zero has gone: G254
};

/// How the places that motions name lie in the workpiece.
struct MotionFrame {
  TipControl control = TipControl::joints;
  double tool_length_mm = 0;  ///< of joints, on a machine with a head
  Vec3 work_zero_mm;          ///< of dynamic_offset, in the machine's frame
  Pose plane;                 ///< of tool_centre: a tilted working plane in the workpiece
  /// Of tool_centre: by how much the control takes the tool for longer than it is, so that the tip
  /// stands so far back along it.
  double length_error_mm = 0;

  /// From motions to the workpiece.
  Pose in_workpiece(const Kinematics& machine, const RotaryAngles& angles_deg) const;
  /// From motions to the workpiece as `machine.upright` has it: the tool along +Z.
  Pose upright(const Kinematics& machine, const RotaryAngles& angles_deg) const;

  friend bool operator==(const MotionFrame&, const MotionFrame&) = default;
};

/// A motion during which rotary axes turn: what it names goes evenly from `from_mm` to `to_mm`, the
/// angles likewise.
struct TurningMotion {
  MotionFrame frame;
  Vec3 from_mm, to_mm;
  RotaryAngles from_deg{}, to_deg{};

  RotaryAngles angles_at(double t) const;  ///< 0 ≤ t ≤ 1
  /// The frame of the tool, tip at its zero and spindle along +Z, in the workpiece.
  Pose tool_at(const Kinematics& machine, double t) const;
  /// Bounds over all of it: on how fast the tip goes in the workpiece, and on how fast the tool
  /// turns there; by t.
  double tip_speed_mm(const Kinematics& machine) const;
  double turn_rad() const;
  /// Of the tip as the machine sees it, or what only some tables carry: on top of its speed in the
  /// workpiece, the tables take it with them.
  double machine_tip_speed_mm(const Kinematics& machine) const;
};

}  // namespace limitgauge::model
