#include "engine/surface/patch_model.h"

#include <algorithm>
#include <limits>

namespace limitgauge::engine::surface {
namespace {

constexpr int kNoPatch = -1;
/// Share of the precision given to the meshes; the rest is for rims, reduction and rounding.
constexpr double kMeshShare = 0.25;
/// Depth from which bounds are looked at: fewer cells are all corners.
constexpr int kFirstDepth = 2;
/// Depth at which the cell at a corner is a quarter of the patch's side.
constexpr int kCornerDepth = 2;
/// Quarters of quarters taken at a corner: the last is 4^-8 of the patch's side.
constexpr int kMostQuarters = 8;
constexpr int kDeepestCorner = 7;

ChordBound no_bound() {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  return {kInfinity, kInfinity, {kInfinity, kInfinity, kInfinity, kInfinity}};
}

}  // namespace

PatchModel::PatchModel(const model::Cage& cage, const ModelRequest& request,
                       const model::RunControl& control)
    : outer_(make_outer_mesh(cage)) {
  if (!outer_.all_quads()) outer_ = refined(outer_);
  for (Index f = 0; f < outer_.face_count(); ++f) {
    patch_of_face_.push_back(outer_.hole[f] ? kNoPatch : static_cast<int>(patches_.size()));
    if (outer_.hole[f]) continue;
    patches_.emplace_back();
    patches_.back().first_half_edge = outer_.face_offsets[f];
  }
  model::parallel_for(patches_.size(), control.threads, [&](std::size_t p) {
    control.check();
    build_patch(p, request);
  });
  share_edges();
  for (const ModelPatch& patch : patches_)
    for (const Vec3& point : patch.limit.points) box_.add(point);
}

void PatchModel::build_patch(std::size_t p, const ModelRequest& request) {
  ModelPatch& patch = patches_[p];
  CellPatch cell(outer_, outer_.face_of[patch.first_half_edge]);
  const int first = std::max(kFirstDepth, cell.smallest_limit_depth());
  while (cell.depth() < first) {
    cell.refine();
    patch.bounds.push_back(no_bound());
  }
  const double wanted = kMeshShare * request.precision_mm;
  std::array<bool, 4> rim{};
  for (int side = 0; side < 4; ++side) {
    const Index h = patch.first_half_edge + side;
    rim[side] = ends_at(h) || creased_at(h);
  }
  std::vector<CellPatch> corners;
  for (;;) {
    if (corners.empty() && cell.depth() == kCornerDepth && !cell.tagged())
      for (int c = 0; c < 4; ++c) corners.push_back(cell.corner_cell(c));
    patch.limit = cell.limit();
    patch.bounds.push_back(chord_bound(cell, patch.limit, request.largest_offset_mm, rim));
    const ChordBound& bound = patch.bounds.back();
    const bool enough = std::max(bound.offset_mm, bound.limit_mm) <= wanted;
    if (enough || cell.depth() >= request.largest_depth) break;
    cell.refine();
  }
  for (std::size_t c = 0; c < corners.size(); ++c)
    if (patch.bounds.back().corner_offset_mm[c] > wanted)
      build_corner(patch, std::move(corners[c]), request);
}

void PatchModel::build_corner(ModelPatch& patch, CellPatch cell, const ModelRequest& request) {
  const double wanted = kMeshShare * request.precision_mm;
  for (int quarter = 0; quarter < kMostQuarters; ++quarter) {
    while (cell.depth() < kCornerDepth) cell.refine();
    CellPatch inner = cell.corner_cell(0);
    ChordBound bound;
    LimitPatch limit;
    for (;;) {
      limit = cell.limit();
      bound = chord_bound(cell, limit, request.largest_offset_mm, {});
      const auto& c = bound.corner_offset_mm;
      bound.offset_mm = std::max({bound.offset_mm, c[1], c[2], c[3]});
      if (bound.offset_mm <= wanted || cell.depth() >= kDeepestCorner) break;
      cell.refine();
    }
    patch.corners.push_back(std::move(limit));
    patch.corner_excess_mm = std::max(patch.corner_excess_mm, bound.offset_mm - wanted);
    if (bound.corner_offset_mm[0] <= wanted) return;
    cell = std::move(inner);
  }
  // What is left is a speck: a ball at the vertex covers it but for its own size.
}

void PatchModel::copy_edge(Index from, Index to) {
  const LimitPatch& source = patches_[patch_at(from)].limit;
  LimitPatch& target = patches_[patch_at(to)].limit;
  const int shared = std::min(source.cells(), target.cells());
  const bool smooth = !creased_at(from);
  for (int t = 1; t < shared; ++t) {
    const int s = side_index(side_at(from), t * (source.cells() / shared), source.cells());
    const int d = side_index(side_at(to), (shared - t) * (target.cells() / shared), target.cells());
    target.points[d] = source.points[s];
    if (smooth) target.normals[d] = source.normals[s];
  }
}

void PatchModel::share_edges() {
  for (Index h = 0; h < outer_.half_edge_count(); ++h) {
    if (!has_patch(h) || ends_at(h) || outer_.twin[h] < h) continue;
    copy_edge(h, outer_.twin[h]);
  }
}

int PatchModel::depth_for(int p, double error_mm) const {
  const std::vector<ChordBound>& bounds = patches_[p].bounds;
  for (std::size_t d = 0; d < bounds.size(); ++d)
    if (std::max(bounds[d].offset_mm, bounds[d].limit_mm) <= error_mm) return static_cast<int>(d);
  return patches_[p].limit.depth;
}

std::size_t PatchModel::memory_bytes() const {
  std::size_t sum = 0;
  for (const ModelPatch& patch : patches_) {
    sum += (patch.limit.points.capacity() + patch.limit.normals.capacity()) * sizeof(Vec3);
    for (const LimitPatch& corner : patch.corners)
      sum += (corner.points.capacity() + corner.normals.capacity()) * sizeof(Vec3);
  }
  return sum;
}

}  // namespace limitgauge::engine::surface
