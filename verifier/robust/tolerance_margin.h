#pragma once

#include <functional>

#include "verifier/gate/deviation.h"

namespace limitgauge::verifier {

/// No box is tried that is larger than the stated one by more.
inline constexpr double kLargestFactor = 100;

/// What was found of one size of the box.
struct BoxTrial {
  enum class Is { within, beyond, undecided };
  Is is = Is::undecided;
  /// Of what is beyond: the run, less its errors (mm), that its witness has with the values at the
  /// same places of the box grown by another factor. That it exceeds the limit there is a proof.
  std::function<double(double factor)> witness_run_mm;
};

/// Tries the box grown by a factor; none for one that no cutter has.
using TryBox = std::function<std::optional<BoxTrial>(double factor)>;

/// Finds by what factor a box may grow until a figure, which grows with it, exceeds its limit: it
/// is `at_none` without a box and `at_whole` in the whole one. `proven` and `refuted` differ by
/// a thousandth, unless what lies between is decided neither way, has no cutter, or is as large as
/// `kLargestFactor`.
ToleranceMargin find_margin(const Interval& at_none, const Interval& at_whole, double limit_mm,
                            const TryBox& try_box);

}  // namespace limitgauge::verifier
