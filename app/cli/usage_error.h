#pragma once

#include <stdexcept>
#include <string>

#include "model/text/clean_text.h"

namespace limitgauge::app {

/// A command line that cannot be obeyed. Exit code 3.
/// On one line and without control characters, as model::InputError.
class UsageError : public std::runtime_error {
 public:
  explicit UsageError(const std::string& what) : std::runtime_error(model::one_line(what)) {}
};

}  // namespace limitgauge::app
