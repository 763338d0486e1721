#include "tests/benchmark/cut_floor.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/base/chunks.h"
#include "simulator/grid/stock_grid.h"
#include "simulator/sweep/swept_distance.h"
#include "simulator/sweep/vector_loops.h"

namespace limitgauge::benchmarks {
namespace {

constexpr std::size_t kColumn = 8;

/// A sloped move of the ball's centre from the origin, 2 mm along x and y.
struct CentreWay {
  double along_x = 0.6, along_y = 0.8, run = 2, rise = 0.1;
  double inverse_run = 1 / run, inverse_length2 = 1 / (run * run + rise * rise);
};

LIMITGAUGE_WIDE
void write_columns(const CentreWay& m, double radius, double voxel, std::size_t first,
                   std::size_t columns, float* __restrict out) {
  for (std::size_t c = 0; c < columns; ++c) {
    const double qx = static_cast<double>((first + c) % 1024) * voxel;
    const double qy = static_cast<double>((first + c) / 1024 % 1024) * voxel;
    const double along = qx * m.along_x + qy * m.along_y, across = qy * m.along_x - qx * m.along_y;
    const double t_level = simulator::unit_clamp(along * m.inverse_run);
    for (std::size_t k = 0; k < kColumn; ++k) {
      const double qz = static_cast<double>(k) * voxel - radius;
      const double t_line =
          simulator::unit_clamp((along * m.run + qz * m.rise) * m.inverse_length2);
      const bool above = qz >= m.rise * t_level;
      const double t = above ? t_level : t_line;
      const double ea = along - t * m.run, below = qz - t * m.rise;
      const double ez = above ? 0.0 : below;
      out[c * kColumn + k] =
          static_cast<float>(std::sqrt(ea * ea + across * across + ez * ez) - radius);
    }
  }
}

}  // namespace

std::size_t band_voxels(const simulator::StockModel& stock) {
  return stock.grid().band_voxels();
}

void write_distances(double radius_mm, double voxel_mm, const model::RunControl& control,
                     std::span<float> out) {
  constexpr std::size_t kChunkColumns = 1 << 13;
  const CentreWay move;
  model::parallel_chunks(
      out.size() / kColumn, kChunkColumns, control, [&](std::size_t begin, std::size_t end) {
        write_columns(move, radius_mm, voxel_mm, begin, end - begin, out.data() + begin * kColumn);
      });
}

void write_swept_distances(const simulator::Pass& pass, double voxel_mm,
                           const model::RunControl& control, std::span<float> out) {
  constexpr std::size_t kChunk = 1 << 16, kOfMove = 64;
  const simulator::CutterProfile profile(pass.cutter);
  const std::vector<model::Move>& moves = pass.path->moves;
  model::parallel_chunks(out.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    simulator::SweptMove move;
    for (std::size_t n = begin; n < end; ++n) {
      const std::size_t i = n / kOfMove % moves.size();
      const auto k = static_cast<int>(n % kOfMove);
      if (n == begin || k == 0)
        move = {move_from(*pass.path, i), moves[i].to, static_cast<std::uint32_t>(i)};
      const model::Vec3 beside = model::Vec3(k / 16, k / 4 % 4, k % 4) * voxel_mm;
      out[n] = static_cast<float>(swept_distance(profile, move, move.start + beside).distance);
    }
  });
}

}  // namespace limitgauge::benchmarks
