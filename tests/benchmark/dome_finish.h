#pragma once
// The stage that the benchmarks share: a ball R3 in rows 0.1 mm apart over the dome
// z = −0.005·(x² + y²), 80 × 65 mm, moves of 0.25 mm, in a block of 90 × 80 × 30 mm.

#include <memory>

#include "model/part/cutter.h"
#include "model/part/stock.h"
#include "model/part/toolpath.h"

namespace limitgauge::benchmarks {

inline constexpr double kBend = 0.005, kRadius_mm = 3;
inline const model::Stock kBlock = model::BoxStock{{-45, -40, -20}, {90, 80, 30}};

inline model::Cutter ball() {
  return {"ball", model::CutterType::ball, 2 * kRadius_mm, kRadius_mm, 0, 25, {}, {}};
}

/// The tip of a ball that touches the dome in its point over (x, y).
inline model::Vec3 tip(double x, double y) {
  const model::Vec3 normal = normalized(model::Vec3{2 * kBend * x, 2 * kBend * y, 1});
  return model::Vec3{x, y, -kBend * (x * x + y * y)} + normal * kRadius_mm -
         model::Vec3{0, 0, kRadius_mm};
}

inline std::shared_ptr<const model::Toolpath> dome_finish(double row_mm = 0.1,
                                                          double along_mm = 0.25) {
  auto path = std::make_shared<model::Toolpath>();
  path->start = tip(-40, -32.5) + model::Vec3{0, 0, 30};
  double side = -1;
  for (double y = -32.5; y <= 32.5; y += row_mm, side = -side)
    for (double x = -40; x <= 40; x += along_mm)
      path->moves.push_back({tip(-side * x, y), 1000,
                             static_cast<std::uint32_t>(path->moves.size() + 1),
                             model::MoveKind::feed});
  return path;
}

}  // namespace limitgauge::benchmarks
