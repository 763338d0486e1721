#pragma once

#include <stdexcept>

namespace limitgauge::app {

/// A command line that cannot be obeyed. Exit code 3.
class UsageError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace limitgauge::app
