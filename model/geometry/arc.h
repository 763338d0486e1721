#pragma once

#include "model/geometry/vec3.h"

namespace limitgauge::model {

/// An arc in cylinder coordinates about its centre, which may climb along its axis as a helix does;
/// the radius may drift a little along it, as the reader of a program's arcs allows.
struct Arc {
  Vec3 centre;                  ///< at the height of its start
  Vec3 axis1, axis2;            ///< unit vectors of its plane; angles count from the first
  Vec3 rise_mm;                 ///< from the height of its start to that of its end
  double angle = 0, swept = 0;  ///< radians, signed: positive goes from axis1 to axis2
  double radius_mm = 0, radius_growth_mm = 0;

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
