#include "engine/surface/patch_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limitgauge::engine::surface {
namespace {

constexpr int kNoPatch = -1;
/// Share of the precision given to the meshes; the rest is for rims, reduction and rounding.
constexpr double kMeshShare = 0.25;
/// Depth to which control nets are looked at for bounds: cells are flat enough there for their
/// hulls to be tight.
constexpr int kAnalysedDepth = 5;
/// Quarters of quarters taken at a corner: control nets shrink by 0.654 a level at worst, two
/// levels a quarter, so the last is a ten-thousandth of the first.
constexpr int kMostQuarters = 12;
constexpr int kAnalysedCorner = 5;
constexpr int kDeepestCorner = 7;
/// Depth at which the cell at a corner is a quarter of the side.
constexpr int kQuarter = 2;

}  // namespace

PatchModel::PatchModel(const model::Cage& cage, const ModelRequest& asked,
                       const model::RunControl& control)
    : outer_(make_outer_mesh(cage)) {
  // The pieces at extraordinary corners are bounded as offsets are; one as small as the precision
  // costs nothing.
  ModelRequest request = asked;
  request.largest_offset_mm = std::max(asked.largest_offset_mm, asked.precision_mm);
  if (!outer_.all_quads()) outer_ = refined(outer_);
  for (Index f = 0; f < outer_.face_count(); ++f) {
    patch_of_face_.push_back(outer_.hole[f] ? kNoPatch : static_cast<int>(patches_.size()));
    if (outer_.hole[f]) continue;
    patches_.emplace_back();
    patches_.back().first_half_edge = outer_.face_offsets[f];
  }
  find_touching();
  model::parallel_for(patches_.size(), control.threads, [&](std::size_t p) {
    control.check();
    patches_[p].bounds = chord_bounds(cell_of(p), bound_request(p, request));
  });
  const std::vector<int> depths = affordable_depths(kMeshShare * request.precision_mm, [&](int p) {
    control.check();
    return bound_next(static_cast<std::size_t>(p), request);
  });
  model::parallel_for(patches_.size(), control.threads, [&](std::size_t p) {
    control.check();
    build_patch(p, depths[p], request);
  });
  share_edges();
  for (const ModelPatch& patch : patches_)
    for (const Vec3& point : patch.limit.points) box_.add(point);
}

CellPatch PatchModel::cell_of(std::size_t p) const {
  return {outer_, outer_.face_of[patches_[p].first_half_edge]};
}

BoundRequest PatchModel::bound_request(std::size_t p, const ModelRequest& request) const {
  std::array<bool, 4> rim{};
  for (int side = 0; side < 4; ++side) {
    const Index h = patches_[p].first_half_edge + side;
    rim[side] = ends_at(h) || creased_at(h);
  }
  const int largest = std::max(request.largest_depth, cell_of(p).smallest_limit_depth());
  return {request.largest_offset_mm,        kAnalysedDepth, largest, true, rim,
          kMeshShare * request.precision_mm};
}

bool PatchModel::bound_next(std::size_t p, const ModelRequest& request) {
  const BoundRequest asked = bound_request(p, request);
  ChordBounds& bounds = patches_[p].bounds;
  if (static_cast<int>(bounds.at.size()) > asked.largest_depth) return false;
  add_next_depth(bounds, cell_of(p), asked);
  return true;
}

namespace {

/// Twice what the mesh of every second node lacks at the others, moved out by `offset_mm`.
double sampled_error(const LimitPatch& limit, double offset_mm) {
  double largest = 0;
  const auto at = [&](int u, int v) {
    const int i = limit.index(u, v);
    return limit.points[i] + limit.normals[i] * offset_mm;
  };
  for (int v = 0; v <= limit.cells(); ++v)
    for (int u = 1; u < limit.cells(); u += 2) {
      largest = std::max(largest, distance(at(u, v), (at(u - 1, v) + at(u + 1, v)) * 0.5));
      largest = std::max(largest, distance(at(v, u), (at(v, u - 1) + at(v, u + 1)) * 0.5));
    }
  return 2 * largest;
}

/// Largest distance of the surface over all of `cell` from its first corner.
double speck_radius(const CellPatch& cell) {
  std::vector<Vec3> hull;
  for (int c = 0; c < 4; ++c) cell.ring(c).add_points(hull);
  const Vec3 vertex = cell.ring(0).limit_point();
  double radius = 0;
  for (const Vec3& p : hull) radius = std::max(radius, distance(p, vertex));
  return radius;
}

}  // namespace

void PatchModel::build_patch(std::size_t p, int depth, const ModelRequest& request) {
  ModelPatch& patch = patches_[p];
  CellPatch cell = cell_of(p);
  while (cell.depth() < depth) {
    if (cell.depth() == patch.bounds.corner_depth)
      for (int c = 0; c < 4; ++c)
        if (patch.bounds.extraordinary[c]) build_corner(patch, cell.corner_cell(c), request);
    cell.refine();
  }
  patch.limit = cell.limit();
  patch.cell_bytes = cell.memory_bytes_of(sizeof(FloatPoint));
  patch.bounds.at.resize(static_cast<std::size_t>(depth) + 1);
  patch.bounds.at.shrink_to_fit();
  for (const auto& [error, offset] :
       {std::pair{&patch.bounds.at.back().limit, 0.0},
        std::pair{&patch.bounds.at.back().offset, request.largest_offset_mm}})
    for (double* mm : {&error->own_mm, &error->corner_mm})
      if (!std::isfinite(*mm)) {
        *mm = sampled_error(patch.limit, offset);
        patch.proven = false;
      }
}

void PatchModel::build_corner(ModelPatch& patch, CellPatch cell, const ModelRequest& request) {
  const double wanted = kMeshShare * request.precision_mm;
  constexpr int kLeast = kQuarter + 1;
  const BoundRequest asked{
      request.largest_offset_mm, kAnalysedCorner, kDeepestCorner, false, {}, wanted, kLeast};
  for (int quarter = 0; quarter < kMostQuarters && speck_radius(cell) > wanted; ++quarter) {
    const ChordBounds bounds = chord_bounds(cell, asked);
    int depth = kLeast;
    while (depth < kDeepestCorner && bounds.at[depth].offset.own_mm > wanted) ++depth;
    while (cell.depth() < kQuarter) cell.refine();
    CellPatch inner = cell.corner_cell(0);
    while (cell.depth() < depth) cell.refine();
    patch.corners.push_back(cell.limit());
    double bound = bounds.at[depth].offset.own_mm;
    if (!std::isfinite(bound)) {
      bound = sampled_error(patch.corners.back(), request.largest_offset_mm);
      patch.proven = false;
    }
    patch.corner_bound_mm = std::max(patch.corner_bound_mm, bound);
    cell = std::move(inner);
  }
  patch.corner_bound_mm = std::max(patch.corner_bound_mm, speck_radius(cell));
  patch.specks.push_back(cell.ring(0).limit_point());
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
  for (const Index first : outer_.first_out)
    if (first >= 0) share_vertex(walk_ring(outer_, outer_.origin[first]));
}

void PatchModel::share_vertex(RingWalk ring) {
  // Rings refined to different depths end a rounding apart.
  const auto creased = [&](Index h) { return creased_at(h); };
  const auto creases = std::count_if(ring.out.begin(), ring.out.end(), creased);
  const bool cone = ring.closed && creases <= 1 &&
                    is_infinite(outer_.vertex_sharpness[outer_.origin[ring.out.front()]]);
  // A closed ring starts where one of its smooth sectors does.
  if (ring.closed && creases > 0)
    std::rotate(ring.out.begin(), std::find_if(ring.out.begin(), ring.out.end(), creased),
                ring.out.end());
  const Vec3 *point = nullptr, *normal = nullptr;
  for (const Index h : ring.out) {
    if (cone || creased_at(h)) normal = nullptr;
    if (!has_patch(h)) continue;
    LimitPatch& limit = patches_[patch_at(h)].limit;
    const int i = limit.side_index(side_at(h), 0);
    if (point) limit.points[i] = *point;
    if (normal) limit.normals[i] = *normal;
    point = &limit.points[i];
    normal = &limit.normals[i];
  }
}

int PatchModel::depth_for(int p, double error_mm) const {
  const std::vector<ChordBound>& bounds = patches_[p].bounds.at;
  for (std::size_t d = 0; d < bounds.size(); ++d)
    if (bounds[d].largest_mm() <= error_mm) return static_cast<int>(d);
  return static_cast<int>(bounds.size()) - 1;
}

void PatchModel::find_touching() {
  std::vector<std::vector<int>> at_vertex(outer_.points.size());
  for (std::size_t p = 0; p < patches_.size(); ++p)
    for (Index side = 0; side < 4; ++side)
      at_vertex[outer_.origin[patches_[p].first_half_edge + side]].push_back(static_cast<int>(p));
  touching_.resize(patches_.size());
  for (std::size_t p = 0; p < patches_.size(); ++p) {
    for (Index side = 0; side < 4; ++side) {
      const auto& at = at_vertex[outer_.origin[patches_[p].first_half_edge + side]];
      touching_[p].insert(touching_[p].end(), at.begin(), at.end());
    }
    std::sort(touching_[p].begin(), touching_[p].end());
    touching_[p].erase(std::unique(touching_[p].begin(), touching_[p].end()), touching_[p].end());
  }
}

double PatchModel::error_mm(int p, const std::vector<int>& depths,
                            MeshError ChordBound::*of) const {
  const ModelPatch& patch = patches_[p];
  const MeshError& own = patch.bounds.at[depths[p]].*of;
  // A mesh that goes on beyond a side leans from this one's direction by the slopes of both, and
  // by its own again, since both are measured from the normals at the side.
  Meeting others;
  for (const int q : touching_[p])
    others = worse(others, (patches_[q].bounds.at[depths[q]].*of).meeting);
  constexpr double kRightAngle = std::numbers::pi / 2;
  const double lean = std::atan(own.meeting.slope) + 2 * std::atan(others.slope);
  const double slope = lean < kRightAngle ? std::min(1.0, std::tan(lean)) : 1.0;
  const auto beyond = [&](double mm) { return mm < others.width_mm ? mm * slope : mm; };
  double laid = 0;
  for (int side = 0; side < 4; ++side) {
    const Index h = patch.first_half_edge + side;
    if (ends_at(h)) continue;
    const int other = depths[patch_at(outer_.twin[h])];
    if (other >= depths[p]) continue;
    const SplitBound& moved = (patch.bounds.at[other].*of).sides[side];
    if (std::isfinite(moved.along + moved.across))
      laid = std::max(laid, moved.along + beyond(moved.across));
  }
  const double bulge = own.meeting.bulge_mm;
  return own.own_mm + laid + (bulge > 0 ? beyond(2 * bulge) : 0.0);
}

double PatchModel::corner_mm(int p, const std::vector<int>& depths) const {
  const ModelPatch& patch = patches_[p];
  double laid = 0;
  for (int side = 0; side < 4; ++side) {
    const Index h = patch.first_half_edge + side;
    if (ends_at(h)) continue;
    const int other = depths[patch_at(outer_.twin[h])];
    // Only coarser neighbours move a corner; a finer one's depth may have no bound here.
    if (other >= depths[p]) continue;
    const double moved = patch.bounds.at[other].limit.corner_side_mm;
    if (std::isfinite(moved)) laid = std::max(laid, moved);
  }
  return patch.bounds.at[depths[p]].limit.corner_mm + laid;
}

double PatchModel::worst_mm(int p, const std::vector<int>& depths) const {
  return std::max(error_mm(p, depths, &ChordBound::limit),
                  error_mm(p, depths, &ChordBound::offset));
}

std::vector<int> PatchModel::depths_within(double error_mm, const Deepen& deepen) const {
  std::vector<int> depths;
  const int count = static_cast<int>(patches_.size());
  for (int p = 0; p < count; ++p) depths.push_back(depth_for(p, error_mm));
  const auto go_deeper = [&](int p) {
    const bool more = depths[p] + 1 < static_cast<int>(patches_[p].bounds.at.size()) || deepen(p);
    depths[p] += more;
    return more;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (int p = 0; p < count; ++p) {
      if (worst_mm(p, depths) <= error_mm) continue;
      // Coarser neighbours first: they cost least.
      bool deeper = false;
      for (int side = 0; side < 4; ++side) {
        const Index h = patches_[p].first_half_edge + side;
        if (ends_at(h)) continue;
        const int other = patch_at(outer_.twin[h]);
        if (depths[other] < depths[p] - (patches_[p].bounds.at[depths[p]].largest_mm() > error_mm))
          deeper |= go_deeper(other);
      }
      changed |= deeper || go_deeper(p);
    }
  }
  return depths;
}

std::vector<int> PatchModel::affordable_depths(double error_mm, const Deepen& deepen) const {
  // 48 bytes each: two gigabytes.
  constexpr double kMostPoints = 40e6;
  std::vector<int> depths = depths_within(error_mm, deepen);
  const auto points = [&] {
    double sum = 0;
    for (const int depth : depths) sum += std::ldexp(1.0, 2 * depth);
    return sum;
  };
  while (points() > kMostPoints && *std::max_element(depths.begin(), depths.end()) > kQuarter)
    depths = depths_within(error_mm *= 2, deepen);
  return depths;
}

Sampling PatchModel::sampling_for(double error_mm) const {
  Sampling sampling{depths_within(error_mm, [](int) { return false; }), {}, 0, 0};
  for (int p = 0; p < static_cast<int>(patches_.size()); ++p) {
    const double corner = corner_mm(p, sampling.depths);
    sampling.corners_apart.push_back(corner > error_mm);
    sampling.limit_mm =
        std::max({sampling.limit_mm, this->error_mm(p, sampling.depths, &ChordBound::limit),
                  corner > error_mm ? patches_[p].corner_bound_mm : corner});
    sampling.offset_mm =
        std::max({sampling.offset_mm, this->error_mm(p, sampling.depths, &ChordBound::offset),
                  patches_[p].corner_bound_mm});
  }
  return sampling;
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
