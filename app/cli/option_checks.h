#pragma once

#include <CLI/CLI.hpp>

namespace limitgauge::app {

/// What the value of an option must be; errors say it, help does not.
CLI::Validator not_empty();  ///< as of a variable of a script that is not set
CLI::Validator number_above_zero(bool or_zero);
CLI::Validator length(bool or_zero);  ///< mm, as model::is_length() has it
CLI::Validator angle();
CLI::Validator share();  ///< from 0 to 1
CLI::Validator whole_number(int low, int high);

}  // namespace limitgauge::app
