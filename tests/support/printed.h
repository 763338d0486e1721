#pragma once

#include <cstdio>
#include <string>

namespace limitgauge::tests {

/// Values by a pattern of printf: whole numbers and decimals as programs, jobs and tables have
/// them, at most 299 characters.
template <class... Values>
std::string printed(const char* pattern, Values... values) {
  char text[300];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

}  // namespace limitgauge::tests
