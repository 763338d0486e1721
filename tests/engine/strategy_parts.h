#pragma once
// Parts, requests and lines that the tests of strategies share.

#include <string>
#include <vector>

#include "engine/strategy/linking/linking.h"
#include "engine/strategy/locations/limit_locations.h"
#include "engine/surface/patch_model.h"
#include "tests/engine/shape_cages.h"

namespace limitgauge::test {

using model::Vec3;

inline model::Cage part_named(const std::string& name) {
  if (name == "plane") return bilinear_cage(2, 10, 0.2, -0.1, 0);
  if (name == "dome") return paraboloid_cage(4, 5, -0.03);
  if (name == "tight bowl") return paraboloid_cage(4, 4, 0.25);
  if (name == "cube") return cube_cage(8);
  if (name == "torus") return torus_cage(8, 6, 7, 4);
  if (name == "ridge") return ridge_cage(4, 3, 1.2);
  return block_cage(6, 4, 1.5);
}

/// A finish of `part` by `cutter`: step 0.5 mm, tolerance 0.02 mm.
inline engine::strategy::StageRequest finish_request(const model::Box3& part,
                                                     const std::string& cutter) {
  engine::strategy::StageRequest r;
  r.cutter = model::parse_cutter(cutter);
  r.cut.step_mm = 0.5;
  r.cut.tolerance_mm = 0.02;
  r.cut.feed_mm_min = 1000;
  r.cut.plunge_feed_mm_min = 300;
  r.cut.link_feed_mm_min = 1000;
  r.clearance_mm = 5;
  r.floor_z_mm = part.low.z - r.cutter.radius_mm();
  r.stock = model::BoxStock{part.low - Vec3{2, 2, 5}, part.size() + Vec3{4, 4, 6}};
  return r;
}

/// A part with its model and cutter locations.
struct Setup {
  model::Cage cage;
  engine::surface::FinishModel finish;
  engine::strategy::StageRequest request;
  engine::strategy::LimitLocations limit;

  Setup(const std::string& part, const std::string& cutter)
      : cage(part_named(part)),
        finish(cage, {0.005, 0, 10}, {}),
        request(finish_request(finish.patches().bounding_box(), cutter)),
        limit(engine::strategy::limit_locations(finish.patches(), request)) {}
};

inline std::vector<std::vector<Vec3>> lines_of(
    const std::vector<engine::strategy::CutPass>& passes) {
  std::vector<std::vector<Vec3>> lines;
  for (const auto& pass : passes) {
    lines.push_back(pass.tips);
    if (pass.closed) lines.back().push_back(pass.tips.front());
  }
  return lines;
}

inline double length_of(const std::vector<std::vector<Vec3>>& lines) {
  double sum = 0;
  for (const auto& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

}  // namespace limitgauge::test
