#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "verifier/cutter/turning_body.h"

// What TurningBody looks for the least along a move with; private to it.

namespace limitgauge::verifier {

/// The profile as it stands at t: its distance to a place, and how fast that grows with t.
struct TurningBody::Look {
  double t = 0;
  BodyDistance here;
  double slope = 0;
  double over_core_mm = 0;  ///< how far up the axis the place is from the core
};

/// Between two looks, with the least that may be in it.
struct TurningBody::Stretch {
  /// Where it has its least near one end, how far from there it is cut.
  static constexpr double kNearEnd = 0.25;

  Look a, b;
  double bound = 0;
};

/// Stretches, the lowest first; of one search at a time in a thread.
class TurningBody::StretchHeap {
 public:
  StretchHeap() { heap().clear(); }
  double lowest() const {
    return heap().empty() ? std::numeric_limits<double>::infinity() : heap().front().bound;
  }
  void push(const Stretch& stretch) {
    heap().push_back(stretch);
    std::push_heap(heap().begin(), heap().end(), higher);
  }
  Stretch pop() {
    std::pop_heap(heap().begin(), heap().end(), higher);
    const Stretch lowest = heap().back();
    heap().pop_back();
    return lowest;
  }

 private:
  static bool higher(const Stretch& x, const Stretch& y) { return x.bound > y.bound; }
  static std::vector<Stretch>& heap() {
    thread_local std::vector<Stretch> kept;
    return kept;
  }
};

}  // namespace limitgauge::verifier
