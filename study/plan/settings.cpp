#include "study/plan/settings.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include "model/text/number_text.h"
#include "study/tolerance.h"

namespace limitgauge::study {
namespace {

Setting step_of(const Range& range, std::size_t index) {
  const auto last = static_cast<double>(range.steps - 1);
  const auto share = [&](std::size_t i) { return static_cast<double>(i) / last; };
  if (index == 0) return number_setting(range.low);
  if (index + 1 == range.steps) return number_setting(range.high);
  const double value = at(range, share(index));
  const double gap = std::min(value - at(range, share(index - 1)),  //
                              at(range, share(index + 1)) - value);
  return number_setting(rounded(value, kStepRounding * gap));
}

}  // namespace

Setting number_setting(double value) {
  return {model::shortest(value), value == 0 ? 0.0 : value};
}

double rounded(double value, double resolution) {
  if (!(resolution > 0) || !std::isfinite(value)) return value;
  const int place = static_cast<int>(std::floor(std::log10(resolution)));
  if (place > 0) {
    const double unit = std::pow(10.0, place);
    return std::round(value / unit) * unit;
  }
  char text[700];
  const std::to_chars_result end =
      std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, -place);
  if (end.ec != std::errc()) return value;
  return model::parse_number({text, static_cast<std::size_t>(end.ptr - text)}).value_or(value);
}

double at(const Range& range, double share) {
  if (share <= 0) return range.low;
  if (share >= 1) return range.high;
  if (!range.logarithmic) return range.low + (range.high - range.low) * share;
  const double low = std::log(range.low);
  return std::clamp(std::exp(low + (std::log(range.high) - low) * share), range.low, range.high);
}

double share_of(const Range& range, double value) {
  if (!range.logarithmic) return (value - range.low) / (range.high - range.low);
  const double low = std::log(range.low);
  return (std::log(value) - low) / (std::log(range.high) - low);
}

bool is_counted(const Variable& variable) {
  return !variable.range || variable.range->steps > 0;
}

std::size_t setting_count(const Variable& variable) {
  return variable.range ? variable.range->steps : variable.values.size();
}

std::vector<Setting> settings_of(const Variable& variable) {
  if (!variable.range) return variable.values;
  if (variable.range->steps < 2) throw std::invalid_argument("a range of fewer than two steps");
  std::vector<Setting> all;
  for (std::size_t i = 0; i < variable.range->steps; ++i)
    all.push_back(step_of(*variable.range, i));
  return all;
}

double drawn(const Range& range, double from, double to, double share, double parts) {
  const double value = at(range, from + (to - from) * share);
  const double low = at(range, from), high = at(range, to);
  // Where the logarithm is what is spread evenly, small numbers stand closer together.
  const double stretch =
      range.logarithmic ? value * std::log(range.high / range.low) * (to - from) : high - low;
  const double resolution = std::min(stretch, high - low) / parts;
  const double unit = std::pow(10.0, std::floor(std::log10(resolution)));
  const double near = rounded(value, resolution);
  if (near < low) return std::min(rounded(value + unit, resolution), high);
  if (near >= high) return std::max(rounded(value - unit, resolution), low);
  return near;
}

}  // namespace limitgauge::study
