#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

namespace limitgauge::reports::study_report {

/// A figure that is not finite is a bug of whoever measured it, and no JSON. Throws
/// std::domain_error that names it.
inline double finite(const std::string& name, double value) {
  if (!std::isfinite(value)) throw std::domain_error("study: " + name + " is not a finite number");
  return value;
}

}  // namespace limitgauge::reports::study_report
