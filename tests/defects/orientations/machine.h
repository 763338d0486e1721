#pragma once

#include <array>
#include <cstddef>

#include "model/geometry/pose.h"

namespace limitgauge::tests::defects {

/// The turn by `angle_deg` about an axis through a point, right-handed: by Rodrigues' formula,
/// written here so that a program is posted by nothing that reads it.
model::Pose turned_about(const model::Vec3& axis, double angle_deg,
                         const model::Vec3& through_mm = {});

/// Where the two rotary axes stand, in degrees and in the machine's order.
using Angles = std::array<double, 2>;

enum class Chain { table_table, head_table, head_head };
const char* name(Chain chain);  ///< as in a job

/// A rotary axis as docs/rotary.md has it: of a head the point is the way from the gauge point.
struct Rotary {
  char word = 'A';
  model::Vec3 direction;
  model::Vec3 point_mm;
};

/// A machine of two rotary axes, the harness's own (compare fixtures/rotary/post.py). The first
/// axis carries the other, or is the head of a head and a table.
struct Machine {
  Chain chain = Chain::table_table;
  std::array<Rotary, 2> axes;
  model::Vec3 zero_mm;   ///< the work's zero (G54) in the machine's frame
  double length_mm = 0;  ///< of the tool, from the gauge point to the tip

  bool is_head(std::size_t axis) const;
  /// The workpiece to where the tables take it, both in the machine's frame.
  model::Pose table(const Angles& angles_deg) const;
  /// From the gauge point to the tip.
  model::Vec3 arm_mm(const Angles& angles_deg) const;
  /// The turn of the workpiece that puts the tool along +Z.
  model::Pose upright(const Angles& angles_deg) const;
  /// The tip in the work's frame (from its zero, as it lies with the axes at 0) for places X Y Z of
  /// the machine, as G54 and G43 count them; and back.
  model::Vec3 tip_mm(const model::Vec3& joints_mm, const Angles& angles_deg) const;
  model::Vec3 joints_mm(const model::Vec3& tip_mm, const Angles& angles_deg) const;

 private:
  model::Pose head(const Angles& angles_deg) const;
};

}  // namespace limitgauge::tests::defects
