#include "reports/picture/tool_side.h"

#include <cmath>

#include "reports/text/text.h"

namespace limitgauge::reports {

std::string tool_side_words(const model::Setup& setup) {
  const model::Vec3 axis = tool_axis(setup);
  constexpr const char* kNames[] = {"X", "Y", "Z"};
  for (int k = 0; k < 3; ++k)
    if (std::abs(axis[k]) == 1) return std::string(axis[k] > 0 ? "+" : "−") + kNames[k];
  return "(" + three_digits(axis.x) + ", " + three_digits(axis.y) + ", " + three_digits(axis.z) +
         ")";
}

}  // namespace limitgauge::reports
