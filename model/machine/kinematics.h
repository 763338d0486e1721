#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry/pose.h"

namespace limitgauge::model {

/// Where the rotary axes A, B and C stand, in degrees; those that a machine lacks stand at 0.
using RotaryAngles = std::array<double, 3>;

/// A rotary axis of a machine.
struct RotaryAxis {
  char word = 'A';  ///< A, B or C
  /// Of a right-handed turn of what the axis carries, workpiece or tool, as its word grows; a unit
  /// vector in the machine's frame, all axes at zero.
  Vec3 direction{1, 0, 0};
  /// On the axis, in the machine's frame. Of a head: as it lies with X, Y and Z at zero, which
  /// makes it the way from the spindle's gauge point to the axis.
  Vec3 point_mm;
  double low_deg = -std::numeric_limits<double>::infinity();
  double high_deg = std::numeric_limits<double>::infinity();

  std::size_t index() const { return static_cast<std::size_t>(word - 'A'); }
  /// How it moves what it carries from where that is at 0.
  Pose turn(double angle_deg) const;
};

enum class MachineKind { table_table, head_table, head_head };
const char* name(MachineKind kind);  ///< as in a job: "table-table", ...

/// Where a tool stands in the workpiece as it lies with all rotary axes at zero.
struct ToolStand {
  Vec3 tip_mm;
  Vec3 axis;  ///< from the tip to the spindle, of length 1
};

/// The rotary axes of a machine whose tool stands along +Z where they are all at zero, and whose X,
/// Y and Z move the spindle. "The workpiece" below is its frame on the table, which is the
/// machine's where all rotary axes stand at zero.
///
/// A gauge point at j, with a tool of length L, and angles θ put the tip at
/// T(θ)⁻¹ (j + H(θ) (0, 0, -L)), along T⁻¹H ẑ: T is the turn of the tables, the one that carries
/// the other last, and H that of the heads about their axes, seen from the gauge point. That is
/// what the kinematics modules of LinuxCNC compute for such machines (xyzac-trt, xyzbc-trt,
/// xyzab-tdr, 5axiskins).
struct Kinematics {
  MachineKind kind = MachineKind::table_table;
  /// One or two. Of two tables, and of two heads, the first carries the other; a head comes before
  /// a table.
  std::vector<RotaryAxis> axes;

  /// Whether axis `i` turns the tool, not the workpiece.
  bool is_head(std::size_t i) const;
  bool has_head() const { return kind != MachineKind::table_table; }
  /// T: the workpiece's frame to the machine's.
  Pose table(const RotaryAngles& angles_deg) const;
  /// H: of a place that moves with the tool, seen from the gauge point, as it is at zero.
  Pose head(const RotaryAngles& angles_deg) const;
  /// How far the heads take the tip of a tool from where it hangs at zero: H (0, 0, -L) less
  /// (0, 0, -L), in the machine's frame.
  Vec3 tip_aside_mm(const RotaryAngles& angles_deg, double tool_length_mm) const;
  /// How far the turns of the axes that carry `word` and of itself move something that is mounted
  /// on it: the machine's frame at zero to the machine's frame. For nothing: what stands still.
  Pose carried_by(std::optional<char> word, const RotaryAngles& angles_deg) const;
  /// H of the heads that carry head `word` and of itself alone: of something that is mounted on it,
  /// seen from the gauge point, as it is at zero.
  Pose head_carrying(char word, const RotaryAngles& angles_deg) const;
  ToolStand stand(const Vec3& gauge_mm, const RotaryAngles& angles_deg,
                  double tool_length_mm) const;
  /// The workpiece's frame to one in which the tool stands along +Z: the machine's own where only
  /// tables turn, and for heads turned back with them about the machine's zero.
  Pose upright(const RotaryAngles& angles_deg) const;
  /// "A90C-45": where its axes stand, in their order; `between` stands between them.
  std::string to_text(const RotaryAngles& angles_deg, const char* between = "") const;
  /// Nothing where the machine has no such axis.
  const RotaryAxis* axis(char word) const;

  /// The angles that put the tool along `axis` of the workpiece, of length 1: those within the
  /// limits that are nearest to `from_deg`, by the longest way that an axis goes; ways are told
  /// apart to 1e-6 degrees. An axis whose angle does not matter stays, or goes to its limit where
  /// it is outside. Nothing where no angles do, within 1e-9.
  std::optional<RotaryAngles> angles_for(const Vec3& axis, const RotaryAngles& from_deg) const;
};

}  // namespace limitgauge::model
