#include "model/gcode/cycles/cutter_compensation_plane.h"

#include <array>
#include <charconv>
#include <numbers>

namespace limitgauge::model::gcode {

double sweep_of(PlaneVector from, PlaneVector to, PlaneVector centre, double turns) {
  const PlaneVector start = from - centre, end = to - centre;
  const double full = 2 * std::numbers::pi;
  double sweep = std::atan2(end.b, end.a) - std::atan2(start.b, start.a);
  if (turns > 0) return (sweep <= 0 ? sweep + full : sweep) + (turns - 1) * full;
  if (sweep >= 0) sweep -= full;
  return sweep + (turns + 1) * full;
}

std::string readable(double value) {
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::general, 6);
  return std::string(digits.data(), end.ptr);
}

}  // namespace limitgauge::model::gcode
