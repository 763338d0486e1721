#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "verifier/cutter/swept_body.h"

// What TurningBody looks for the least along a move with.

namespace limitgauge::verifier {

/// The profile as it stands at t: its distance to a place, and how fast that grows with t.
struct TurnLook {
  double t = 0;
  BodyDistance here;
  double slope = 0;
  double over_core_mm = 0;  ///< how far up the axis the place is from the core
};

/// Between two looks, with the least that may be in it.
struct TurnStretch {
  /// Where it has its least near one end, how far from there it is cut.
  static constexpr double kNearEnd = 0.25;

  TurnLook a, b;
  double bound = 0;
};

/// Stretches, the lowest first; of one search at a time in a thread.
class TurnStretches {
 public:
  TurnStretches() { heap().clear(); }
  double lowest() const {
    return heap().empty() ? std::numeric_limits<double>::infinity() : heap().front().bound;
  }
  void push(const TurnStretch& stretch) {
    heap().push_back(stretch);
    std::push_heap(heap().begin(), heap().end(), higher);
  }
  TurnStretch pop() {
    std::pop_heap(heap().begin(), heap().end(), higher);
    const TurnStretch lowest = heap().back();
    heap().pop_back();
    return lowest;
  }

 private:
  static bool higher(const TurnStretch& x, const TurnStretch& y) { return x.bound > y.bound; }
  static std::vector<TurnStretch>& heap() {
    thread_local std::vector<TurnStretch> kept;
    return kept;
  }
};

}  // namespace limitgauge::verifier
