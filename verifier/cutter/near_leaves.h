#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "verifier/cutter/pass_bodies.h"

namespace limitgauge::verifier {

/// What of one pass lies near a place: a search whose questions are close to each other need not go
/// down from the root of the tree for each. d changes by no more than the way gone, so that what
/// lies within a limit of a place lies within that limit and the way of another. Whoever searches
/// keeps it, for one pass and one thread; it changes no answer.
class NearLeaves {
 public:
  struct Body {
    double distance_mm = 0;  ///< from the ring's middle
    std::uint32_t place = 0;
  };
  /// All bodies within `limit_mm` of a place.
  struct Ring {
    double further_mm = 0;  ///< how much further than asked was looked
    model::Vec3 at = {};
    double limit_mm = 0;
    std::vector<std::uint32_t> leaves = {};  ///< that hold them, in the order of the tree
    std::vector<Body> bodies = {};           ///< the nearest first, once they are known
    int asked = 0;                           ///< for its bodies, since it was filled
    bool known = false, too_many = false;
    model::Vec3 missed_at = {};  ///< where it was asked in vain last
    bool missed = false;

    bool covers(const model::Vec3& p, double limit) const;
    bool is_crowded(const model::Vec3& p, double limit) const;
    bool pays(const model::Vec3& p);
  };

  /// Nodes beneath which all bodies with d(p) ≤ limit_mm lie, in the order of the tree: the root,
  /// or what a search begins with that need not go down from there. Not for passes that turn.
  std::span<const std::uint32_t> roots_near(const PassBodies& bodies, const model::Vec3& p,
                                            double limit_mm);
  /// A ring that holds all bodies with d(p) ≤ limit_mm; nothing where it is as well to begin at the
  /// root. Not for passes that turn their tool.
  const Ring* around(const PassBodies& bodies, const model::Vec3& p, double limit_mm);
  /// Bodies of the ring that `around` gave; none where they are not worth working out: of the wide
  /// one, or when they are asked for the first time.
  std::span<const Body> bodies_in(const Ring& ring, const PassBodies& bodies);

 private:
  bool fill(Ring& ring, const Ring* wider, const PassBodies& bodies, const model::Vec3& p,
            double limit_mm);
  void fill_roots(const PassBodies& bodies, const model::Vec3& p, double limit_mm);
  static void add_bodies(Ring& ring, const PassBodies& bodies);

  Ring roots_{1.0};  ///< as wide as all of them: subtrees in place of leaves
  /// The wider one first.
  std::array<Ring, 2> rings_ = {Ring{0.25}, Ring{0.05}};
};

}  // namespace limitgauge::verifier
