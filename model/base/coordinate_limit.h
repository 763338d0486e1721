#pragma once

#include <cmath>
#include <string>

#include "model/base/tolerance.h"
#include "model/geometry/vec3.h"
#include "model/text/number_text.h"

namespace limitgauge::model {

/// No coordinate of a cage, a stock, a fixture, a cutter or a path may lie further from zero: 10 m.
/// The certificate allows for 1e-9 mm of rounding (verifier/CERTIFICATE.md), which holds while an
/// ulp of every coordinate is below 2e-12 mm. What lies further out is moved nearer, or is in the
/// wrong unit.
inline constexpr double kFarthestMm = 10'000;

inline constexpr const char* kFarthestExpected =
    "at most 10000 mm (10 m) from zero, as far as the certificate's allowance for rounding holds";

/// Whether a length or coordinate is one; NaN and the infinities are not.
inline bool is_near(double value_mm) {
  return std::abs(value_mm) <= kFarthestMm;
}
inline bool is_near(const Vec3& point_mm) {
  return is_near(point_mm.x) && is_near(point_mm.y) && is_near(point_mm.z);
}
/// An empty box is.
inline bool is_near(const Box3& box_mm) {
  return box_mm.empty() || (is_near(box_mm.low) && is_near(box_mm.high));
}

/// Whether a length that is stated can be worked with.
inline bool is_length(double length_mm) {
  return length_mm >= kLeastLengthMm && is_near(length_mm);
}
inline constexpr const char* kLengthExpected = "a length from 1e-6 to 10000 mm";

/// "x = 12000 mm": the first coordinate that lies too far; empty where none does.
inline std::string farthest_words(const Vec3& point_mm) {
  constexpr const char* kNames = "xyz";
  for (const int axis : {0, 1, 2})
    if (!is_near(point_mm[axis]))
      return std::string(1, kNames[axis]) + " = " + shortest(point_mm[axis]) + " mm";
  return {};
}
inline std::string farthest_words(const Box3& box_mm) {
  return is_near(box_mm.low) ? farthest_words(box_mm.high) : farthest_words(box_mm.low);
}

}  // namespace limitgauge::model
