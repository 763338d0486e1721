#pragma once

#include <array>

#include "model/gcode/program.h"

namespace limitgauge::model {

/// An arc from its start in cylinder coordinates about its centre; the radius may drift a little
/// along it, as the reader's tolerance allows.
struct ArcSweep {
  std::array<int, 3> axes{};
  double centre1 = 0, centre2 = 0;
  double angle = 0, swept = 0;  ///< radians, signed: positive is counter-clockwise
  double radius_mm = 0, radius_growth_mm = 0;
  double height_mm = 0, rise_mm = 0;

  /// `arc` from `start`. One that ends within 1e-6 radians beyond its start is a full turn.
  ArcSweep(const Motion& arc, const Vec3& start);

  Vec3 point_at(double fraction) const;
  /// Largest distance between the arc and `chords` equal chords. Exact for a circle and a helix
  /// (r - r cos(h/2)); for a spiral the bound h²/8 · |p''| of linear interpolation.
  double error_mm(double chords) const;
  /// The same bound between places of the arc and of the chords at the same share of the way.
  double even_error_mm(double chords) const;
  /// How many equal chords, of a quarter turn at most, stay within `limit_mm`; 1e15 for any more.
  double chords_within(double limit_mm) const;
};

}  // namespace limitgauge::model
