#include "verifier/robust/tolerance_margin.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::verifier {
namespace {

using Is = BoxTrial::Is;

/// How near proven and refuted factors are to come to each other, as a share of them.
constexpr double kFineness = 1e-3;
/// How near to where a witness reaches the limit its factor is taken, as a share of it.
constexpr double kWitnessFineness = 1e-5;
/// Sizes tried at most: three where the first witness is the worst, else some ten.
constexpr int kMostTries = 24;
/// A box of this many times the size that passes is tried next at most.
constexpr double kSteepest = 8;
/// Share of what is open by which is stepped back from where the second witness ends.
constexpr double kFirstShare = 0.125;

/// Closes in on the size at which a figure reaches its limit: each witness beyond the limit tells
/// the smallest size at which it is one, and a size a little below that is tried next.
class MarginSearch {
 public:
  MarginSearch(double limit_mm, const TryBox& try_box) : limit_mm_(limit_mm), try_box_(try_box) {}

  /// The stated box passes, with a middle of `at_whole_mm`; without one it is `at_none_mm`.
  void grow(double at_none_mm, double at_whole_mm) {
    proven_ = 1;
    const double rise = at_whole_mm - at_none_mm;
    double factor = rise > 0 ? 1 + (limit_mm_ - at_whole_mm) / rise : kLargestFactor;
    while (tries_left() && !is_ended_ && is_apart(proven_, largest_)) {
      factor = std::clamp(factor * (1 + kFineness), 1.1 * proven_, kSteepest * proven_);
      if (factor >= largest_) factor = has_cutter_ ? largest_ : (proven_ + largest_) / 2;
      if (see(factor) == Is::within) factor *= 2;
    }
  }
  void see_beyond(double factor) { see(factor); }

  ToleranceMargin run() {
    double share = 0;
    while (is_ended_ && is_apart(proven_, end_) && tries_left()) {
      const double back = std::max(kFineness / 2 * end_, share * (end_ - proven_));
      // The first witness beyond the limit need not be the worst: where a size just below where it
      // ends does not pass either, the next is nearer and nearer to halfway.
      if (see(end_ - back) != Is::within) share = std::clamp(2 * share, kFirstShare, 0.5);
    }
    if (is_ended_ && !refuted_) seek_refuted();
    return {proven_, refuted_};
  }

 private:
  /// Beyond what is decided neither way.
  void seek_refuted() {
    const double undecided = end_;
    for (const double share : {1.1, 1.5, 2.5, 5.0})
      if (!refuted_ && undecided * share < largest_) see(undecided * share);
  }
  bool tries_left() { return tries_++ < kMostTries; }
  static bool is_apart(double low, double high) { return high - low > kFineness * high; }

  std::optional<Is> see(double factor) {
    const std::optional<BoxTrial> trial = try_box_(factor);
    if (!trial) {
      largest_ = factor, has_cutter_ = false;
      return std::nullopt;
    }
    if (trial->is == Is::within) proven_ = factor;
    if (trial->is == Is::beyond) refuted_ = end_ = where_reached(*trial, factor);
    if (trial->is == Is::undecided) end_ = factor;
    if (trial->is != Is::within) is_ended_ = true;
    return trial->is;
  }

  /// The smallest factor, but for the fineness, at which the witness of `factor` exceeds the limit.
  double where_reached(const BoxTrial& trial, double factor) const {
    double low = proven_, high = factor;
    double above_low = trial.witness_run_mm(low) - limit_mm_;
    double above_high = trial.witness_run_mm(high) - limit_mm_;
    // The proof stands, but not with the box's own values: nothing can be told of smaller ones.
    if (!(above_high > 0)) return factor;
    for (int k = 0; k < 40 && high - low > kWitnessFineness * high; ++k) {
      // A little above and below where the line through both ends has it, so that it soon lies
      // between the two; every third time halfway, should the line be bad.
      const double line = low - above_low / (above_high - above_low) * (high - low);
      const double beside = (k % 3 == 0 ? 0.4 : -0.4) * kWitnessFineness * high;
      const double middle = k % 3 == 2 || !(line + beside > low && line + beside < high)
                                ? (low + high) / 2
                                : line + beside;
      const double above = trial.witness_run_mm(middle) - limit_mm_;
      (above > 0 ? high : low) = middle;
      (above > 0 ? above_high : above_low) = above;
    }
    return high;
  }

  double limit_mm_;
  const TryBox& try_box_;
  double proven_ = 0;  ///< largest that passes
  std::optional<double> refuted_;
  double end_ = kLargestFactor;  ///< smallest that is tried and does not pass
  bool is_ended_ = false;        ///< whether any is
  double largest_ = kLargestFactor;
  bool has_cutter_ = true;  ///< in the largest
  int tries_ = 0;
};

}  // namespace

ToleranceMargin find_margin(const Interval& at_none, const Interval& at_whole, double limit_mm,
                            const TryBox& try_box) {
  if (at_none.low > limit_mm) return {std::nullopt, 0};
  if (at_none.high > limit_mm) return {std::nullopt, std::nullopt};
  MarginSearch search(limit_mm, try_box);
  if (at_whole.high <= limit_mm)
    search.grow((at_none.low + at_none.high) / 2, (at_whole.low + at_whole.high) / 2);
  else
    search.see_beyond(1);
  return search.run();
}

}  // namespace limitgauge::verifier
