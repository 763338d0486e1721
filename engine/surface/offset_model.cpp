#include "engine/surface/offset_model.h"

#include <algorithm>
#include <utility>

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

/// Lays the finer points of `side` onto the chords of every `ratio`th.
void straighten(Grid& grid, int side, int ratio) {
  const int cells = grid.columns - 1;
  for (int t = 0; t < cells; ++t) {
    const int rest = t % ratio;
    if (rest == 0) continue;
    const Vec3 a = grid.points[side_index(side, t - rest, cells)];
    const Vec3 b = grid.points[side_index(side, t - rest + ratio, cells)];
    const double share = static_cast<double>(rest) / ratio;
    grid.points[side_index(side, t, cells)] = {between(a.x, b.x, share), between(a.y, b.y, share),
                                               between(a.z, b.z, share)};
  }
}

}  // namespace

OffsetModel sample_offset(const PatchModel& model, double offset_mm, double error_mm) {
  OffsetModel sampled;
  sampled.offset_mm = offset_mm;
  const int patches = static_cast<int>(model.patches().size());
  for (int p = 0; p < patches; ++p) {
    const LimitPatch& limit = model.patches()[p].limit;
    sampled.depths.push_back(model.depth_for(p, error_mm));
    sampled.grids.push_back(sampled_grid(limit, sampled.depths.back(), offset_mm));
    const ModelPatch& patch = model.patches()[p];
    const ChordBound& bound = patch.bounds[sampled.depths.back()];
    sampled.excess_mm = std::max(
        {sampled.excess_mm, bound.limit_mm - error_mm,
         offset_mm > 0 ? std::max(bound.offset_mm - error_mm, patch.corner_excess_mm) : 0});
    if (offset_mm > 0)
      for (const LimitPatch& corner : patch.corners)
        sampled.corners.push_back(sampled_grid(corner, corner.depth, offset_mm));
    const int interval = 1 << (limit.depth - sampled.depths.back());
    sampled.intervals.push_back(interval);
    sampled.interval_min = p == 0 ? interval : std::min(sampled.interval_min, interval);
    sampled.interval_max = std::max(sampled.interval_max, interval);
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

}  // namespace limitgauge::engine::surface
