#pragma once

#include <vector>

#include "tests/simulator/paths.h"

namespace limitgauge::simulator::test {

inline model::Cutter pointed(model::CutterType type, double diameter, double flutes, double corner,
                             double tip_angle, double lean) {
  model::Cutter c = cutter(type, diameter, flutes, corner, lean);
  c.tip_angle_deg = tip_angle;
  return c;
}

/// One of each kind, and APT cutters of every build: leaning outwards and inwards, with and without
/// a corner, with one that reaches beyond the axis.
inline std::vector<model::Cutter> every_cutter() {
  using model::CutterType;
  return {cutter(CutterType::flat, 4, 6),
          cutter(CutterType::ball, 5, 6),
          cutter(CutterType::bull, 5, 6, 1),
          cutter(CutterType::taper, 2, 6, 0.5, 12),
          cutter(CutterType::taper, 3, 6, 0, 20),
          pointed(CutterType::drill, 4, 6, 0, 31, 0),
          pointed(CutterType::apt, 5, 6, 0.8, 10, 8),
          pointed(CutterType::apt, 6, 5, 0.7, 5, -15),
          pointed(CutterType::apt, 6, 4, 0, 0, -20),
          pointed(CutterType::apt, 4, 6, 2.2, 20, 0)};
}

}  // namespace limitgauge::simulator::test
