#include "app/cli/option_checks.h"

#include <optional>

#include "model/base/number_text.h"

namespace limitgauge::app {

CLI::Validator number_above_zero(bool or_zero) {
  return CLI::Validator(
      [or_zero](const std::string& text) {
        const std::optional<double> value = model::parse_number(text);
        if (value && (*value > 0 || (or_zero && *value == 0))) return "";
        return or_zero ? "is no number from zero up" : "is no number above zero";
      },
      "");
}

CLI::Validator finite_number() {
  return CLI::Validator(
      [](const std::string& text) { return model::parse_number(text) ? "" : "is no number"; }, "");
}

CLI::Validator share() {
  return CLI::Validator(
      [](const std::string& text) {
        const std::optional<double> value = model::parse_number(text);
        return value && *value >= 0 && *value <= 1 ? "" : "is no share from 0 to 1";
      },
      "");
}

CLI::Validator whole_number(int low, int high) {
  // The range is the validator's own text for errors, and no part of the help.
  return CLI::Validator(CLI::Range(low, high)).description("");
}

}  // namespace limitgauge::app
