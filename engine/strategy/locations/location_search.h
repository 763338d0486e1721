#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "engine/strategy/locations/cutter_contact.h"
#include "engine/strategy/locations/location_question.h"
#include "engine/strategy/locations/location_tree.h"

namespace limitgauge::engine::strategy {

/// An end that no lift reaches.
inline constexpr double kNoEnd = std::numeric_limits<double>::infinity();

/// The greatest lift over all triangles of a tree, as a PlaceQuestion or MoveQuestion asks.
template <class Question>
class LocationSearch {
 public:
  LocationSearch(const LocationTree& tree, const Question& question, GreatestLift& greatest)
      : tree_(tree), question_(question), greatest_(greatest) {}

  /// Deepest first, the node of the greatest bound before its sisters; ends early once the lift
  /// exceeds `enough`.
  void run(double enough = kNoEnd) {
    push(0, 1);
    while (size_ > 0) {
      const Open open = stack_[--size_];
      if (open.bound <= greatest_.known) continue;
      const LocationNode& node = tree_.nodes()[open.node];
      if (node.children > 0) {
        push(node.first, node.children);
        continue;
      }
      ask_leaf(tree_.leaf(node));
      if (greatest_.value > enough) return;
    }
  }

 private:
  struct Open {
    double bound = 0;
    int node = 0;
  };
  /// Three sisters wait on every level of a tree of four; grids of 2^31 points have 32 levels.
  static constexpr int kStack = 256;

  void push(int first, int count) {
    const int begin = size_;
    for (int node = first; node < first + count; ++node) {
      const double bound = question_.bound(tree_.nodes()[node], greatest_.known);
      if (bound <= greatest_.known) continue;
      int at = size_++;
      for (; at > begin && stack_[at - 1].bound > bound; --at) stack_[at] = stack_[at - 1];
      stack_[at] = {bound, node};
    }
  }

  void ask_leaf(const LocationLeaf& cells) {
    const surface::Grid& grid = tree_.grid(cells.grid);
    for (int v = cells.v; v < cells.v_end; ++v)
      for (int u = cells.u; u < cells.u_end; ++u)
        ask_cell(grid.at(u, v), grid.at(u + 1, v), grid.at(u + 1, v + 1), grid.at(u, v + 1));
  }

  void ask_cell(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
    const TopBox box{std::min({p.x, q.x, r.x, s.x}), std::min({p.y, q.y, r.y, s.y}),
                     std::max({p.x, q.x, r.x, s.x}), std::max({p.y, q.y, r.y, s.y}),
                     std::max({p.z, q.z, r.z, s.z})};
    if (!question_.concerns(box, greatest_.known)) return;
    question_.ask({p, q, r}, greatest_);
    question_.ask({p, r, s}, greatest_);
  }

  const LocationTree& tree_;
  const Question& question_;
  GreatestLift& greatest_;
  std::array<Open, kStack> stack_;
  int size_ = 0;
};

}  // namespace limitgauge::engine::strategy
