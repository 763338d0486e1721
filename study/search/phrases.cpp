#include "study/search/phrases.h"

#include <cmath>
#include <cstdio>

#include "model/text/number_text.h"

namespace limitgauge::study {
namespace {

std::string printed(const char* format, double value) {
  char text[400];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Significant digits, without the zeros at the end.
std::string digits(double value, int count) {
  const std::string text = printed(("%." + std::to_string(count) + "g").c_str(), value);
  return model::shortest(model::parse_number(text).value_or(value));
}

}  // namespace

std::string quantity(double value, const std::string& unit) {
  const bool small_length = unit == "mm" && value != 0 && std::abs(value) < 0.1;
  const double shown = small_length ? value * 1000 : value;
  const std::string number = std::abs(shown) >= 1000 ? printed("%.0f", shown) : digits(shown, 4);
  const std::string symbol = small_length ? "µm" : unit;
  return symbol.empty() ? number : number + " " + symbol;
}

std::string percent(double share) {
  const double value = 100 * share;
  if (std::abs(value) < 0.1) return value == 0 ? "0 %" : "less than 0.1 %";
  return (std::abs(value) >= 10 ? printed("%.0f", value) : digits(value, 2)) + " %";
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace limitgauge::study
