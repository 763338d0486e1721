#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "model/geometry/vec3.h"
#include "tests/e2e/program.h"

namespace limitgauge::e2e {

/// A block whose top is at zero with a pocket (floor at −3, walls at x = 4 and 46, y = 4 and 36)
/// cut by a flat cutter, T1, and a groove along X in its floor (axis at y = 20, z = −2, radius 3)
/// cut by a ball, T2.
void cut_part(const Scratch& scratch, const std::string& output);

/// A place on the finished part by its closed form, with the normal there, out of the material.
struct SurfacePoint {
  model::Vec3 at, normal;
};
std::vector<SurfacePoint> floor_points(std::size_t count);
/// Of floor, all four walls and the groove.
std::vector<SurfacePoint> part_points(std::size_t count);

/// What a measuring machine makes of them: shifted, with normally distributed errors of `u_mm`
/// along the normals (0: none), as a table with or without that column; fixed seed.
std::string measured_table(const std::vector<SurfacePoint>& points, const model::Vec3& shift_mm,
                           double u_mm, bool with_u = true);

/// Runs `probe RESULT POINTS -o OUTPUT` and more.
Outcome probe(const Scratch& scratch, const std::string& result, const std::string& output,
              const std::vector<std::string>& more = {});
nlohmann::json probe_json(const Scratch& scratch, const std::string& output);

}  // namespace limitgauge::e2e
