#pragma once

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "verifier/probe/probe_residual.h"

namespace limitgauge::verifier {

/// Stocks whose surface has a closed form: a block below z = 0 with its side faces at x = 0 and 40,
/// y = −10 and 10, and what rows along X leave of it.
struct RowStock {
  /// Rows of one cutter, each from x = −10 to 50, at the stated y and height of the tip.
  RowStock(const std::string& cutter, const std::vector<std::pair<double, double>>& y_and_z,
           double chord_error_mm = 0) {
    auto path = std::make_shared<model::Toolpath>();
    path->start = {-10, y_and_z.front().first, 30};
    path->chord_error_mm = chord_error_mm;
    std::uint32_t line = 1;
    for (const auto& [y, z] : y_and_z) {
      path->moves.push_back({{-10, y, 30}, 0, line++, model::MoveKind::rapid});
      path->moves.push_back({{-10, y, z}, 500, line++, model::MoveKind::feed});
      path->moves.push_back({{50, y, z}, 500, line++, model::MoveKind::feed});
      path->moves.push_back({{50, y, 30}, 0, line++, model::MoveKind::rapid});
    }
    passes.push_back({model::parse_cutter(cutter), path});
  }

  RemovedSpace removed() const { return {block, passes}; }

  model::BoxStock block{{0, -10, -10}, {40, 20, 10}};
  std::vector<Pass> passes;
};

/// What a point on the surface was found by: the way from material to air, halved.
inline model::Vec3 on_surface(const RemovedSpace& removed, model::Vec3 inside,
                              model::Vec3 outside) {
  for (int halving = 0; halving < 70; ++halving) {
    const model::Vec3 middle = (inside + outside) * 0.5;
    (removed.nearest(middle).distance.value > 0 ? inside : outside) = middle;
  }
  return (inside + outside) * 0.5;
}

}  // namespace limitgauge::verifier
