#include "verifier/cutter/near_leaves.h"

#include <algorithm>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// More leaves than this are no shorter than the way down from the root.
constexpr std::size_t kMostLeaves = 96;
/// Subtrees that searches begin with have about as many leaves, and there are no more of them.
constexpr std::uint32_t kRootLeaves = 8;
constexpr std::size_t kMostRoots = 64;
/// Questions that a ring answers by its leaves, before its bodies are worked out.
constexpr int kAskedBefore = 1;

}  // namespace

bool NearLeaves::Ring::covers(const Vec3& p, double limit) const {
  return known && limit + distance(p, at) + kDistanceRounding_mm <= limit_mm;
}

/// Whether there are too many, for all that was seen.
bool NearLeaves::Ring::is_crowded(const Vec3& p, double limit) const {
  return too_many && distance(p, at) <= further_mm / 2 && limit >= limit_mm - 2 * further_mm;
}

/// Whether the last question was so near that the next one may be too.
bool NearLeaves::Ring::pays(const Vec3& p) {
  const bool near = missed && distance(p, missed_at) <= further_mm / 2;
  missed_at = p, missed = true;
  return near;
}

/// False where there are too many.
bool NearLeaves::fill(Ring& ring, const Ring* wider, const PassBodies& bodies, const Vec3& p,
                      double limit_mm) {
  ring.at = p, ring.limit_mm = limit_mm + ring.further_mm;
  ring.leaves.clear(), ring.bodies.clear(), ring.asked = 0;
  const auto near = [&](std::uint32_t node) {
    return bodies.bound(bodies.nodes()[node], p, ring.limit_mm) <= ring.limit_mm;
  };
  const auto add = [&](std::uint32_t leaf) {
    if (ring.leaves.size() < kMostLeaves) return ring.leaves.push_back(leaf);
    ring.too_many = true;
  };
  ring.too_many = false;
  if (wider) {
    for (const std::uint32_t leaf : wider->leaves)
      if (near(leaf)) add(leaf);
  } else {
    bodies.visit_leaves(roots_near(bodies, p, ring.limit_mm), near, [&](std::uint32_t leaf) {
      add(leaf);
      return !ring.too_many;
    });
  }
  ring.known = !ring.too_many;
  return ring.known;
}

void NearLeaves::fill_roots(const PassBodies& bodies, const Vec3& p, double limit_mm) {
  roots_.at = p, roots_.limit_mm = limit_mm + roots_.further_mm;
  roots_.leaves.clear(), roots_.too_many = false;
  bodies.visit_nodes(
      bodies.root(), kRootLeaves,
      [&](std::uint32_t node) {
        return bodies.bound(bodies.nodes()[node], p, roots_.limit_mm) <= roots_.limit_mm;
      },
      [&](std::uint32_t node) {
        roots_.too_many = roots_.leaves.size() == kMostRoots;
        if (!roots_.too_many) roots_.leaves.push_back(node);
        return !roots_.too_many;
      });
  roots_.known = !roots_.too_many;
}

std::span<const std::uint32_t> NearLeaves::roots_near(const PassBodies& bodies, const Vec3& p,
                                                      double limit_mm) {
  if (roots_.covers(p, limit_mm)) return roots_.leaves;
  if (!roots_.is_crowded(p, limit_mm) && roots_.pays(p)) {
    fill_roots(bodies, p, limit_mm);
    if (roots_.known) return roots_.leaves;
  }
  return bodies.root();
}

std::span<const NearLeaves::Body> NearLeaves::bodies_in(const Ring& ring,
                                                        const PassBodies& bodies) {
  Ring& narrow = rings_.back();
  if (&ring == &narrow && ++narrow.asked == kAskedBefore + 1) add_bodies(narrow, bodies);
  return ring.bodies;
}

void NearLeaves::add_bodies(Ring& ring, const PassBodies& bodies) {
  for (const std::uint32_t node : ring.leaves) {
    const model::BoxNode& leaf = bodies.nodes()[node];
    for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
      const double d = bodies.value_at(k, ring.at);
      if (d <= ring.limit_mm) ring.bodies.push_back({d, k});
    }
  }
  std::sort(ring.bodies.begin(), ring.bodies.end(), [](const Body& a, const Body& b) {
    return a.distance_mm != b.distance_mm ? a.distance_mm < b.distance_mm : a.place < b.place;
  });
}

const NearLeaves::Ring* NearLeaves::around(const PassBodies& bodies, const Vec3& p,
                                           double limit_mm) {
  const Ring* found = nullptr;
  if (rings_.back().covers(p, limit_mm)) return &rings_.back();
  for (Ring& ring : rings_) {
    if (!ring.covers(p, limit_mm)) {
      if (ring.is_crowded(p, limit_mm) || !ring.pays(p)) break;
      // A list of the wider one serves only where it holds all that the narrow one looks for.
      const Ring* wider = found && found->covers(p, limit_mm + ring.further_mm) ? found : nullptr;
      if (!fill(ring, wider, bodies, p, limit_mm)) break;
    }
    found = &ring;
  }
  return found;
}

}  // namespace limitgauge::verifier
