#include "tests/simulator/paths.h"

namespace limitgauge::simulator::test {

model::Cutter cutter(model::CutterType type, double diameter, double flutes, double corner,
                     double angle) {
  model::Cutter c;
  c.type = type, c.diameter_mm = diameter, c.flute_length_mm = flutes;
  c.corner_radius_mm = type == model::CutterType::ball ? diameter / 2 : corner;
  c.taper_angle_deg = angle;
  return c;
}

}  // namespace limitgauge::simulator::test
