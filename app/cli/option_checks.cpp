#include "app/cli/option_checks.h"

#include <cmath>
#include <optional>

#include "app/tolerance.h"
#include "model/base/coordinate_limit.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::app {

CLI::Validator not_empty() {
  return CLI::Validator(
      [](const std::string& text) { return text.empty() ? "is empty; expected a name" : ""; }, "");
}

CLI::Validator number_above_zero(bool or_zero) {
  return CLI::Validator(
      [or_zero](const std::string& text) -> std::string {
        const std::optional<double> value = model::parse_number(text);
        if (value && (*value > 0 || (or_zero && *value == 0))) return "";
        return model::in_quotes(text) +
               (or_zero ? " is no number from zero up" : " is no number above zero");
      },
      "");
}

CLI::Validator length(bool or_zero) {
  return CLI::Validator(
      [or_zero](const std::string& text) -> std::string {
        const std::optional<double> value_mm = model::parse_number(text);
        if (value_mm && (model::is_length(*value_mm) || (or_zero && *value_mm == 0))) return "";
        return model::in_quotes(text) + " is no length; expected " + (or_zero ? "0, or " : "") +
               model::kLengthExpected;
      },
      "");
}

CLI::Validator angle() {
  return CLI::Validator(
      [](const std::string& text) -> std::string {
        const std::optional<double> value_deg = model::parse_number(text);
        if (value_deg && std::abs(*value_deg) <= kLargestAngle_deg) return "";
        return model::in_quotes(text) + " is no angle; expected " + kAngleExpected;
      },
      "");
}

CLI::Validator share() {
  return CLI::Validator(
      [](const std::string& text) {
        const std::optional<double> value = model::parse_number(text);
        return value && *value >= 0 && *value <= 1
                   ? ""
                   : model::in_quotes(text) + " is no share from 0 to 1";
      },
      "");
}

CLI::Validator whole_number(int low, int high) {
  return CLI::Validator(
      [low, high](const std::string& text) -> std::string {
        const std::optional<int> value = model::parse_whole<int>(text);
        if (value && *value >= low && *value <= high) return "";
        return model::in_quotes(text) + " is no whole number from " + std::to_string(low) + " to " +
               std::to_string(high);
      },
      "");
}

}  // namespace limitgauge::app
