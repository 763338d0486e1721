#include "engine/surface/offset_model.h"

#include <algorithm>

namespace limitgauge::engine::surface {
namespace {

Grid sampled_grid(const LimitPatch& limit, int depth, double offset_mm) {
  const int stride = limit.cells() >> depth, cells = 1 << depth;
  Grid grid{cells + 1, cells + 1, {}};
  grid.points.reserve(static_cast<std::size_t>(cells + 1) * static_cast<std::size_t>(cells + 1));
  for (int v = 0; v <= cells; ++v)
    for (int u = 0; u <= cells; ++u) {
      const int i = limit.index(u * stride, v * stride);
      grid.points.push_back(limit.points[i] + limit.normals[i] * offset_mm);
    }
  return grid;
}

/// A value between its ends, so that a straight edge stays monotone under rounding.
double between(double a, double b, double t) {
  return std::clamp(a + (b - a) * t, std::min(a, b), std::max(a, b));
}

/// Lays the finer points of `side` onto the chords of every `ratio`th, each onto the place nearest
/// to it, so that it moves across the chord only.
void straighten(Grid& grid, int side, int ratio) {
  const int cells = grid.columns - 1;
  double share = 0;
  for (int t = 0; t < cells; ++t) {
    const int rest = t % ratio;
    if (rest == 0) {
      share = 0;
      continue;
    }
    const Vec3 a = grid.points[side_index(side, t - rest, cells)];
    const Vec3 b = grid.points[side_index(side, t - rest + ratio, cells)];
    Vec3& point = grid.points[side_index(side, t, cells)];
    const double square = length_squared(b - a);
    if (square > 0) share = std::clamp(dot(point - a, b - a) / square, share, 1.0);
    point = {between(a.x, b.x, share), between(a.y, b.y, share), between(a.z, b.z, share)};
  }
}

}  // namespace

OffsetModel sample_offset(const PatchModel& model, double offset_mm, double error_mm) {
  OffsetModel sampled;
  sampled.offset_mm = offset_mm;
  const int patches = static_cast<int>(model.patches().size());
  const Sampling sampling = model.sampling_for(error_mm);
  sampled.depths = sampling.depths;
  sampled.excess_mm =
      std::max(0.0, (offset_mm > 0 ? sampling.offset_mm : sampling.limit_mm) - error_mm);
  const std::vector<LimitPatch> none;
  for (int p = 0; p < patches; ++p) {
    const LimitPatch& limit = model.patches()[p].limit;
    sampled.grids.push_back(sampled_grid(limit, sampled.depths[p], offset_mm));
    const bool apart = offset_mm > 0 || sampling.corners_apart[p];
    for (const LimitPatch& corner : apart ? model.patches()[p].corners : none)
      sampled.corners.push_back(sampled_grid(corner, corner.depth, offset_mm));
    sampled.intervals.push_back(1 << (limit.depth - sampled.depths[p]));
  }
  for (int p = 0; p < patches; ++p)
    for (int side = 0; side < 4; ++side) {
      const Index h = model.patches()[p].first_half_edge + side;
      if (model.ends_at(h)) continue;
      const int other = model.patch_at(model.outer().twin[h]);
      const int finer_by = sampled.depths[p] - sampled.depths[other];
      if (finer_by > 0) straighten(sampled.grids[p], side, 1 << finer_by);
    }
  return sampled;
}

std::vector<Grid> pieces(const OffsetModel& sampled) {
  std::vector<Grid> all = sampled.grids;
  all.insert(all.end(), sampled.corners.begin(), sampled.corners.end());
  return all;
}

}  // namespace limitgauge::engine::surface
