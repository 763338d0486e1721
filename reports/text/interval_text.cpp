#include "reports/text/interval_text.h"

#include <algorithm>
#include <cmath>

#include "model/text/number_text.h"

namespace limitgauge::reports {
namespace {

using model::Rounding;
using model::without_dust;

/// What is printed in `unit`, held against a limit that is printed in it as well.
std::string end_text(double mm, const LengthUnit& unit, int decimals, Rounding rounding,
                     const std::optional<double>& limit_mm) {
  if (!limit_mm) return model::rounded_text(mm * unit.per_mm, decimals, rounding);
  const double limit = without_dust(*limit_mm * unit.per_mm);
  return model::rounded_text(mm == *limit_mm ? limit : mm * unit.per_mm, decimals, rounding, limit);
}

/// A tenth of a nanometre is the last that is shown, in either unit.
int usual_decimals(const verifier::Interval& interval_mm, const LengthUnit& unit) {
  const int most = unit.per_mm > 1 ? 4 : 7;
  const double width = interval_mm.width() * unit.per_mm;
  if (width > 0) return std::clamp(int(std::ceil(-std::log10(width / 5))), 0, most);
  return std::min(most, model::significant_decimals(interval_mm.high * unit.per_mm, 3));
}

}  // namespace

std::string interval_numbers(const verifier::Interval& interval_mm, const LengthUnit& unit,
                             const std::optional<double>& limit_mm) {
  if (interval_mm.low == 0 && interval_mm.high == 0) return "[0, 0]";
  const int decimals = usual_decimals(interval_mm, unit);
  return std::string("[")
      .append(end_text(interval_mm.low, unit, decimals, Rounding::down, limit_mm))
      .append(", ")
      .append(end_text(interval_mm.high, unit, decimals, Rounding::up, limit_mm))
      .append("]");
}

std::string stated_number(double mm, const LengthUnit& unit) {
  return model::without_trailing_zeros(fixed(without_dust(mm * unit.per_mm), 9));
}

std::string measured_number(double mm, const LengthUnit& unit,
                            const std::optional<double>& limit_mm) {
  constexpr double kNeedsExponent = 1e-4;
  const double shown = mm * unit.per_mm;
  if (!limit_mm || std::abs(shown) < kNeedsExponent) return three_digits(shown);
  return end_text(mm, unit, model::significant_decimals(shown, 3), Rounding::nearest, limit_mm);
}

std::string measured_beside(double mm, const std::optional<double>& limit_mm) {
  const LengthUnit unit = unit_for(mm);
  return measured_number(mm, unit, limit_mm) + " " + unit.symbol;
}

std::string percent_beside(double share, double least) {
  const double limit = without_dust(100 * least);
  return model::rounded_text(share == least ? limit : 100 * share, 2, Rounding::down, limit) + " %";
}

std::string stated_percent(double share) {
  const std::string all = model::shortest(without_dust(100 * share));
  const std::string two = fixed(100 * share, 2);
  return (all.size() > two.size() ? all : two) + " %";
}

}  // namespace limitgauge::reports
