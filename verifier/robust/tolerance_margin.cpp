#include "verifier/robust/tolerance_margin.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::verifier {
namespace {

/// How near proven and refuted factors are to come to each other, as a share of them.
constexpr double kFineness = 1e-3;
constexpr int kMostTries = 24;
/// A factor that is guessed is tried a little beside, so that the limit soon lies between two.
constexpr double kBeside = 0.4 * kFineness;

/// A box that was tried.
struct Tried {
  double factor = 0, middle_mm = 0;
};

/// Narrows down where a growing figure crosses its limit.
class MarginSearch {
 public:
  MarginSearch(double limit_mm, const std::function<std::optional<Interval>(double)>& figure)
      : limit_mm_(limit_mm), figure_(figure) {}

  void see(double factor, const Interval& figure) {
    const Tried tried{factor, (figure.low + figure.high) / 2};
    if (figure.high <= limit_mm_) {
      if (!passes_ || factor > passes_->factor) passes_ = tried;
    } else if (figure.low > limit_mm_) {
      if (!fails_ || factor < fails_->factor) fails_ = tried;
    } else {
      undecided_.add(factor);
    }
  }

  ToleranceMargin run() {
    for (int k = 0; k < kMostTries && passes_; ++k) {
      const std::optional<double> next = next_factor();
      if (!next) break;
      const std::optional<Interval> figure = figure_(*next);
      if (!figure) {
        largest_ = *next;
        continue;
      }
      see(*next, *figure);
    }
    ToleranceMargin out;
    if (passes_) out.proven = passes_->factor;
    if (fails_) out.refuted = fails_->factor;
    return out;
  }

 private:
  /// The next to try; none where nothing is left to be learnt.
  std::optional<double> next_factor() const {
    const double from = passes_->factor;
    if (!fails_ && undecided_.empty()) return beyond(from);
    const double to = std::min(fails_ ? fails_->factor : largest_,
                               undecided_.empty() ? largest_ : undecided_.low);
    if (is_apart(from, to)) return undecided_.empty() ? between() : (from + to) / 2;
    if (undecided_.empty()) return std::nullopt;
    const double end = fails_ ? fails_->factor : std::min(2 * undecided_.high, largest_);
    if (is_apart(undecided_.high, end)) return (undecided_.high + end) / 2;
    return std::nullopt;
  }
  static bool is_apart(double low, double high) { return high - low > kFineness * high; }

  /// Nothing that was tried fails yet: where the limit would be on the line through the last two.
  std::optional<double> beyond(double from) const {
    if (!is_apart(from, largest_)) return std::nullopt;
    const double rise = passes_->middle_mm - first_mm();
    const double step = rise > 0 ? from * (limit_mm_ - passes_->middle_mm) / rise : largest_;
    const double next = from > 0 ? from + std::max(step * (1 + kBeside), 0.5 * from) : 1;
    return std::min(next, (from + largest_) / (largest_ < kLargestFactor ? 2 : 1));
  }
  double first_mm() const { return at_none_mm; }
  /// On the line between what passes and what fails, a little to the side where the limit is
  /// likelier to be left of.
  double between() const {
    const double width = fails_->factor - passes_->factor;
    const double rise = fails_->middle_mm - passes_->middle_mm;
    const double share = rise > 0 ? (limit_mm_ - passes_->middle_mm) / rise : 0.5;
    const double guess = passes_->factor + std::clamp(share, 0.0, 1.0) * width;
    const double inner = width * 0.02, step = std::max(kBeside * guess, 0.0);
    const double next = share > 0.5 ? guess - step : guess + step;
    return std::clamp(next, passes_->factor + inner, fails_->factor - inner);
  }

  double limit_mm_;
  const std::function<std::optional<Interval>(double)>& figure_;
  std::optional<Tried> passes_, fails_;
  Interval undecided_ = Interval::none();
  double largest_ = kLargestFactor;

 public:
  double at_none_mm = 0;
};

}  // namespace

ToleranceMargin find_margin(const Interval& at_none, const Interval& at_whole, double limit_mm,
                            const std::function<std::optional<Interval>(double)>& figure) {
  MarginSearch search(limit_mm, figure);
  search.at_none_mm = (at_none.low + at_none.high) / 2;
  search.see(0, at_none);
  search.see(1, at_whole);
  return search.run();
}

}  // namespace limitgauge::verifier
