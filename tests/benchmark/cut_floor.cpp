#include "tests/benchmark/cut_floor.h"

#include <cmath>

#include "model/base/chunks.h"
#include "simulator/grid/stock_grid.h"
#include "simulator/sweep/vector_loops.h"

namespace limitgauge::benchmarks {
namespace {

/// A sloped move of the ball's centre from the origin, 2 mm along x and y.
struct CentreWay {
  double along_x = 0.6, along_y = 0.8, run = 2, rise = 0.1;
  double inverse_run = 1 / run, inverse_length2 = 1 / (run * run + rise * rise);
};

LIMITGAUGE_WIDE
void write_some(const CentreWay& m, const model::Vec3& from, double radius,
                const float* __restrict x, const float* __restrict y, const float* __restrict z,
                std::size_t count, float* __restrict out) {
  LIMITGAUGE_EACH
  for (std::size_t k = 0; k < count; ++k) {
    const double qx = x[k] - from.x, qy = y[k] - from.y, qz = z[k] - from.z;
    const double along = qx * m.along_x + qy * m.along_y, across = qy * m.along_x - qx * m.along_y;
    const double t_level = simulator::unit_clamp(along * m.inverse_run);
    const double t_line = simulator::unit_clamp((along * m.run + qz * m.rise) * m.inverse_length2);
    const bool above = qz >= m.rise * t_level;
    const double t = above ? t_level : t_line;
    const double ea = along - t * m.run, below = qz - t * m.rise;
    const double ez = above ? 0.0 : below;
    out[k] = static_cast<float>(std::sqrt(ea * ea + across * across + ez * ez) - radius);
  }
}

}  // namespace

Places changed_places(const simulator::StockModel& before, const simulator::StockModel& after) {
  const simulator::Lattice& lattice = after.grid().lattice();
  Places places;
  for (const simulator::Index3& at : after.grid().changed_voxels(before.grid())) {
    places.x.push_back(static_cast<float>(lattice.origin_mm.x + at[0] * lattice.voxel_mm));
    places.y.push_back(static_cast<float>(lattice.origin_mm.y + at[1] * lattice.voxel_mm));
    places.z.push_back(static_cast<float>(lattice.origin_mm.z + at[2] * lattice.voxel_mm));
  }
  return places;
}

void write_distances(const Places& places, const model::Vec3& middle_mm, double radius_mm,
                     const model::RunControl& control, std::span<float> out) {
  constexpr std::size_t kChunk = 1 << 16;
  const CentreWay move;
  model::parallel_chunks(out.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    write_some(move, middle_mm, radius_mm, places.x.data() + begin, places.y.data() + begin,
               places.z.data() + begin, end - begin, out.data() + begin);
  });
}

}  // namespace limitgauge::benchmarks
