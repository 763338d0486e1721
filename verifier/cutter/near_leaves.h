#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "verifier/cutter/pass_bodies.h"

namespace limitgauge::verifier {

/// The leaves of one pass's tree that lie near a place: a search whose questions are close to each
/// other need not go down from the root for each. d changes by no more than the way gone, so that
/// what lies within a limit of a place lies within that limit and the way of another. Whoever
/// searches keeps it, for one pass and one thread; it changes no answer.
class NearLeaves {
 public:
  /// Leaves that hold all bodies with d(p) ≤ limit_mm, in the order of the tree; nothing where it
  /// is as well to begin at the root. Not for passes that turn their tool.
  const std::vector<std::uint32_t>* around(const PassBodies& bodies, const model::Vec3& p,
                                           double limit_mm);

 private:
  /// What lies within `limit_mm` of a place; how much further than asked that was looked for.
  struct Ring {
    double further_mm = 0;
    model::Vec3 at = {};
    double limit_mm = 0;
    std::vector<std::uint32_t> leaves = {};
    bool known = false, too_many = false;
    model::Vec3 missed_at = {};  ///< where it was asked in vain last
    bool missed = false;

    bool covers(const model::Vec3& p, double limit) const;
    bool is_crowded(const model::Vec3& p, double limit) const;
    bool pays(const model::Vec3& p);
  };

  bool fill(Ring& ring, const Ring* wider, const PassBodies& bodies, const model::Vec3& p,
            double limit_mm);

  /// The wider one first. A finish pass has some ten leaves within the narrow one.
  std::array<Ring, 2> rings_ = {Ring{0.25}, Ring{0.03}};
};

}  // namespace limitgauge::verifier
