#pragma once

#include <cstddef>
#include <optional>

#include "model/base/run_control.h"
#include "model/geometry/vec3.h"

namespace limitgauge::simulator {

/// A place that a search found, in the solid's frame, and when.
struct TurnPlace {
  double t = 0;
  model::Vec3 point;
  double mm = 0;  ///< depth in the solid, or what is left between
};

struct TurnAnswer {
  std::optional<TurnPlace> place;
  std::size_t looks = 0;  ///< blocks that were looked at
  /// False: given up after most_looks. Then what was not found may be there.
  bool proven = true;
};

/// What a search of a turn has found so far, and how long it goes on.
class TurnEffort {
 public:
  /// `control` must outlive it.
  TurnEffort(std::size_t most_looks, const model::RunControl& control)
      : most_looks_(most_looks), control_(control) {}

  /// Before each look. Throws Interrupted.
  void look() {
    if (answer_.looks++ % kLooksBetweenStops == 0) control_.check();
  }
  void find(const TurnPlace& place) {
    if (!answer_.place) first_found_ = answer_.looks;
    answer_.place = place;
  }
  /// Whether enough was looked at: nothing is proven then where nothing was found.
  bool gives_up() {
    if (answer_.place) return answer_.looks - first_found_ > kMostFurtherLooks;
    answer_.proven = answer_.looks <= most_looks_;
    return !answer_.proven;
  }
  const TurnAnswer& answer() const { return answer_; }

 private:
  /// Narrowing down what is already proven stops here: a depth found is a lower bound, a distance
  /// an upper one.
  static constexpr std::size_t kMostFurtherLooks = 20'000;
  /// Looks between two questions whether to stop: some milliseconds.
  static constexpr std::size_t kLooksBetweenStops = 4096;

  std::size_t most_looks_;
  const model::RunControl& control_;
  TurnAnswer answer_;
  std::size_t first_found_ = 0;  ///< looks when something was
};

}  // namespace limitgauge::simulator
