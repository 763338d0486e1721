#pragma once

#include <optional>

#include "simulator/sweep/depth_bound.h"

namespace limitgauge::simulator {

/// Where a body stands in the material, and how far from the material's surface that place is.
struct Contact {
  model::Vec3 point;
  double depth_mm = 0;
};

struct ContactAnswer {
  std::optional<Contact> contact;
  /// False: given up after `most_looks`. Then what was not found may be there.
  bool proven = true;
};

/// A search that takes more is given up, after some seconds. What clears its surroundings, or only
/// slides along them, takes some hundreds.
inline constexpr std::size_t kMostContactLooks = 4'000'000;

/// The deepest place of `body`, swept along `move`, in the material; none if it is nowhere deeper
/// than `tolerance_mm`. Branch and bound: the depth is 1-Lipschitz and, but for a raw stock that is
/// not convex, lies below paraboloids; the body is convex, so that a body which only slides along a
/// surface is cleared in a few steps. A contact deeper than 1.5 tolerances is never missed. The
/// depth found is a lower bound, as a rule within a tolerance of the deepest.
ContactAnswer deepest_contact(const MaterialAtMove& material, const CutterProfile& body,
                              const SweptMove& move, double tolerance_mm,
                              std::size_t most_looks = kMostContactLooks);

}  // namespace limitgauge::simulator
