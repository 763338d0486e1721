#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/base/run_control.h"
#include "model/geometry/vec3.h"
#include "simulator/stock/stock_model.h"

namespace limitgauge::benchmarks {

/// Middles of voxels in mm, coordinate by coordinate.
struct Places {
  std::vector<float> x, y, z;
  std::size_t size() const { return x.size(); }
};

/// The voxels whose value `after` is another one than `before`, and that lie in the narrow band of
/// one of the two. What turned from all inside to all outside by whole blocks is not among them.
Places changed_places(const simulator::StockModel& before, const simulator::StockModel& after);

/// What a cut must do at the very least: the distance to one ball move, in closed form and in
/// double precision, at each of these places, written to `out`. In as wide registers as the
/// kernel's, on all threads. The move leads 2 mm on from `middle_mm` and rises.
void write_distances(const Places& places, const model::Vec3& middle_mm, double radius_mm,
                     const model::RunControl& control, std::span<float> out);

}  // namespace limitgauge::benchmarks
