#pragma once

#include <optional>
#include <span>

#include "model/geometry/vec3.h"

namespace limitgauge::verifier {

/// All q with normal·q ≥ offset_mm; the normal is a unit vector.
struct HalfSpace {
  model::Vec3 normal;
  double offset_mm = 0;
};

/// The point nearest to `p` that lies in all of `spaces`, of which there are few; nothing where no
/// point does, or where that cannot be told for rounding.
std::optional<model::Vec3> nearest_in_all(std::span<const HalfSpace> spaces, const model::Vec3& p);

}  // namespace limitgauge::verifier
