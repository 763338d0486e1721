#pragma once

#include <stdexcept>

namespace limitgauge::witness {

/// OpenSubdiv does not take a cage, a vertex of more edges than it can count for one.
class CageRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace limitgauge::witness
