#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "model/geometry/vec3.h"

namespace limitgauge::model {

/// A number in fixed decimals without trailing zeros, and what a reader will make of it.
struct FixedNumber {
  std::array<char, 32> digits{};
  std::size_t length = 0;
  double value = 0;

  std::string_view text() const { return {digits.data(), length}; }
};

/// `value`, at most 1e18 in size, with up to `decimals` decimals (0 to 9); with `point`, its
/// decimal point stays where no decimals do.
FixedNumber fixed(double value, int decimals, bool point = false);

/// `point` as it will be read after it was written with `decimals` decimals.
Vec3 rounded(const Vec3& point, int decimals);

/// A feed rate in fixed notation that reads back as the same float.
std::string feed_text(float feed_mm_min);

}  // namespace limitgauge::model
