#include "engine/surface/offset_model.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace limitgauge::engine::surface {
namespace {

std::size_t points_at(int depth) {
  const auto along = static_cast<std::size_t>(1 << depth) + 1;
  return along * along;
}

Vec3 moved_out(const LimitPatch& limit, int i, double offset_mm) {
  return limit.points[i] + limit.normals[i] * offset_mm;
}

Grid sampled_grid(const LimitPatch& limit, int depth, double offset_mm) {
  const int stride = limit.cells() >> depth, cells = 1 << depth;
  Grid grid{cells + 1, cells + 1, {}};
  grid.points.reserve(points_at(depth));
  for (int v = 0; v <= cells; ++v)
    for (int u = 0; u <= cells; ++u)
      grid.points.push_back(moved_out(limit, limit.index(u * stride, v * stride), offset_mm));
  return grid;
}

std::vector<Vec3> sampled_side(const LimitPatch& limit, int side, int depth, double offset_mm) {
  const int stride = limit.cells() >> depth, cells = 1 << depth;
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(cells) + 1);
  for (int t = 0; t <= cells; ++t)
    points.push_back(moved_out(limit, limit.side_index(side, t * stride), offset_mm));
  return points;
}

/// A value between its ends, so that a straight edge stays monotone under rounding.
double between(double a, double b, double t) {
  return std::clamp(a + (b - a) * t, std::min(a, b), std::max(a, b));
}

/// Lays the points of a finer side onto the chords of every `ratio`th, each onto the place nearest
/// to it, so that it moves across the chord only.
void straighten(std::vector<Vec3>& side, std::size_t ratio) {
  double share = 0;
  for (std::size_t t = 0; t < side.size(); ++t) {
    const std::size_t rest = t % ratio;
    if (rest == 0) {
      share = 0;
      continue;
    }
    const Vec3 a = side[t - rest], b = side[t - rest + ratio];
    Vec3& point = side[t];
    const double square = length_squared(b - a);
    if (square > 0) share = std::clamp(dot(point - a, b - a) / square, share, 1.0);
    point = {between(a.x, b.x, share), between(a.y, b.y, share), between(a.z, b.z, share)};
  }
}

/// How many depths a patch is finer than its neighbour beyond `side`; none where it ends there.
int finer_by(const PatchModel& model, const std::vector<int>& depths, int patch, int side) {
  const Index h = model.patches()[patch].first_half_edge + side;
  if (model.ends_at(h)) return 0;
  return std::max(0, depths[patch] - depths[model.patch_at(model.outer().twin[h])]);
}

}  // namespace

OffsetSampler::OffsetSampler(const PatchModel& model, double error_mm)
    : model_(&model), error_mm_(error_mm), sampling_(model.sampling_for(error_mm)) {}

std::vector<int> OffsetSampler::intervals() const {
  std::vector<int> found;
  for (int p = 0; p < patches(); ++p)
    found.push_back(1 << (model_->patches()[p].limit.depth - depths()[p]));
  return found;
}

double OffsetSampler::excess_mm(double offset_mm) const {
  return std::max(0.0, (offset_mm > 0 ? sampling_.offset_mm : sampling_.limit_mm) - error_mm_);
}

std::vector<Vec3> OffsetSampler::side(int patch, int side, double offset_mm) const {
  std::vector<Vec3> points =
      sampled_side(model_->patches()[patch].limit, side, depths()[patch], offset_mm);
  const int finer = finer_by(*model_, depths(), patch, side);
  if (finer > 0) straighten(points, std::size_t{1} << finer);
  return points;
}

Grid OffsetSampler::grid(int patch, double offset_mm) const {
  Grid made = sampled_grid(model_->patches()[patch].limit, depths()[patch], offset_mm);
  // Straightening leaves corners where they are, so sides do not depend on each other.
  for (int s = 0; s < 4; ++s) {
    if (finer_by(*model_, depths(), patch, s) == 0) continue;
    const std::vector<Vec3> laid = side(patch, s, offset_mm);
    for (int t = 0; t < made.columns; ++t)
      made.points[side_index(s, t, made.columns - 1)] = laid[t];
  }
  return made;
}

std::size_t OffsetSampler::grid_points(int patch) const {
  return points_at(depths()[patch]);
}

int OffsetSampler::corners(int patch, double offset_mm) const {
  const bool apart = offset_mm > 0 || sampling_.corners_apart[patch];
  return apart ? static_cast<int>(model_->patches()[patch].corners.size()) : 0;
}

Grid OffsetSampler::corner(int patch, int corner, double offset_mm) const {
  const LimitPatch& limit = model_->patches()[patch].corners[corner];
  return sampled_grid(limit, limit.depth, offset_mm);
}

std::size_t OffsetSampler::corner_points(int patch, int corner) const {
  return points_at(model_->patches()[patch].corners[corner].depth);
}

void for_each_piece(const OffsetSampler& sampler, double offset_mm,
                    const std::function<void(Grid)>& visit) {
  for (int p = 0; p < sampler.patches(); ++p) visit(sampler.grid(p, offset_mm));
  for (int p = 0; p < sampler.patches(); ++p)
    for (int c = 0; c < sampler.corners(p, offset_mm); ++c) visit(sampler.corner(p, c, offset_mm));
}

std::vector<Grid> pieces(const OffsetSampler& sampler, double offset_mm) {
  std::vector<Grid> all;
  for_each_piece(sampler, offset_mm, [&](Grid grid) { all.push_back(std::move(grid)); });
  return all;
}

OffsetModel sample_offset(const PatchModel& model, double offset_mm, double error_mm) {
  const OffsetSampler sampler(model, error_mm);
  OffsetModel sampled;
  sampled.grids = pieces(sampler, offset_mm);
  const auto corners = sampled.grids.begin() + sampler.patches();
  sampled.corners.assign(std::make_move_iterator(corners),
                         std::make_move_iterator(sampled.grids.end()));
  sampled.grids.erase(corners, sampled.grids.end());
  sampled.depths = sampler.depths();
  sampled.intervals = sampler.intervals();
  sampled.offset_mm = offset_mm;
  sampled.excess_mm = sampler.excess_mm(offset_mm);
  return sampled;
}

}  // namespace limitgauge::engine::surface
