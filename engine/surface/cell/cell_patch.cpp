#include "engine/surface/cell/cell_patch.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::engine::surface {

// For points that turn into Vec3.
using model::operator+;
using model::operator-;
using model::operator*;

namespace {

std::size_t net_size(int cells) {
  return static_cast<std::size_t>(cells + 3) * static_cast<std::size_t>(cells + 3);
}

Vec3 regular_vertex(const Vec3& v, const Vec3& edges, const Vec3& faces) {
  return v * (9.0 / 16) + edges * (3.0 / 32) + faces * (1.0 / 64);
}

Vec3 regular_edge(const Vec3& ends, const Vec3& wings) {
  return ends * 0.375 + wings * 0.0625;
}

}  // namespace

template <class Point>
BasicCellPatch<Point>::BasicCellPatch(const OuterMesh& mesh, Index face) : net_(net_size(1)) {
  const Index first = mesh.face_offsets[face];
  for (int c = 0; c < 4; ++c) {
    rings_.emplace_back(mesh, first + c);
    open_[c] = mesh.open(first + c);
    sharpness_[c] = mesh.edge_sharpness[mesh.edge[first + c]];
  }
  place_corners(net_, 1);
}

template <class Point>
Vec3 BasicCellPatch<Point>::from_corner(int c, int along, int inward) const {
  const PatchSide s = side(c, cells());
  return net_[s.base + along * s.along - inward * s.outward];
}

template <class Point>
CornerRing BasicCellPatch<Point>::ring_on_first_side(int c) const {
  const auto p = [&](int t, int w) { return from_corner(c, t, w); };
  const double s = sharpness_[c];
  if (open_[c])
    return CornerRing(
        {p(1, 0), {p(2, 0), p(1, 1), p(0, 0)}, {p(2, 1), p(0, 1)}, {s, 0, s}, false, 1});
  return CornerRing({p(1, 0),
                     {p(1, 1), p(0, 0), p(1, -1), p(2, 0)},
                     {p(0, 1), p(0, -1), p(2, -1), p(2, 1)},
                     {0, s, 0, s},
                     true,
                     0});
}

template <class Point>
CornerRing BasicCellPatch<Point>::ring_inside(int c) const {
  const auto p = [&](int t, int w) { return from_corner(c, t, w); };
  return CornerRing({p(1, 1),
                     {p(0, 1), p(1, 0), p(2, 1), p(1, 2)},
                     {p(0, 0), p(2, 0), p(2, 2), p(0, 2)},
                     {0, 0, 0, 0},
                     true,
                     0});
}

template <class Point>
CornerRing BasicCellPatch<Point>::ring_on_last_side(int c) const {
  const auto p = [&](int t, int w) { return from_corner(c, t, w); };
  const double s = sharpness_[(c + 3) % 4];
  if (open_[(c + 3) % 4])
    return CornerRing(
        {p(0, 1), {p(0, 0), p(1, 1), p(0, 2)}, {p(1, 0), p(1, 2)}, {s, 0, s}, false, 0});
  return CornerRing({p(0, 1),
                     {p(0, 0), p(1, 1), p(0, 2), p(-1, 1)},
                     {p(1, 0), p(1, 2), p(-1, 2), p(-1, 0)},
                     {s, 0, s, 0},
                     true,
                     0});
}

template <class Point>
BasicCellPatch<Point> BasicCellPatch<Point>::corner_cell(int c) const {
  BasicCellPatch cell;
  cell.net_.resize(net_size(1));
  cell.rings_ = {rings_[c], ring_on_first_side(c), ring_inside(c), ring_on_last_side(c)};
  cell.open_ = {open_[c], false, false, open_[(c + 3) % 4]};
  cell.sharpness_ = {sharpness_[c], 0, 0, sharpness_[(c + 3) % 4]};
  cell.place_corners(cell.net_, 1);
  return cell;
}

template <class Point>
PatchSide BasicCellPatch<Point>::side(int c, int cells) const {
  const int w = cells + 3;
  const int origin = w + 1;
  switch (c) {
    case 0:
      return {origin, 1, -w};
    case 1:
      return {origin + cells, w, 1};
    case 2:
      return {origin + cells * w + cells, -1, w};
    default:
      return {origin + cells * w, -w, -1};
  }
}

template <class Point>
int BasicCellPatch<Point>::smallest_limit_depth() const {
  double largest = 0;
  for (const CornerRing& ring : rings_)
    largest = std::max(largest, ring.largest_finite_sharpness());
  return depth_ + static_cast<int>(std::ceil(largest));
}

template <class Point>
void BasicCellPatch<Point>::place_corners(std::vector<Point>& net, int cells) const {
  for (int c = 0; c < 4; ++c) {
    const PatchSide s = side(c, cells);
    net[s.base] = rings_[c].centre();
    if (open_[c]) continue;
    net[s.base + s.outward] = rings_[c].edge_beyond(-1);
    net[s.base + cells * s.along + s.outward] = rings_[(c + 1) % 4].edge_beyond(2);
  }
}

template <class Point>
void BasicCellPatch<Point>::refine() {
  const int fine_cells = 2 * cells();
  std::vector<Point> fine(net_size(fine_cells));
  refine_interior(fine);
  for (int c = 0; c < 4; ++c) {
    refine_side(c, fine);
    if (!open_[c]) refine_strip(c, fine);
  }
  for (CornerRing& ring : rings_) ring.refine();
  for (double& s : sharpness_) s = child_sharpness(s);
  place_corners(fine, fine_cells);
  net_ = std::move(fine);
  ++depth_;
}

template <class Point>
void BasicCellPatch<Point>::refine_interior(std::vector<Point>& fine) const {
  const int m = cells(), w = width(), fine_w = 2 * m + 3;
  for (int fv = 1; fv < 2 * m; ++fv) {
    Point* row = &fine[(fv + 1) * fine_w + 1];
    const Point* p = &net_[at(0, fv / 2)];
    if (fv % 2 == 1) {
      for (int u = 0; u < m; ++u) {
        row[2 * u + 1] = (p[u] + p[u + 1] + p[u + w] + p[u + w + 1]) * 0.25;
        if (u == 0) continue;
        row[2 * u] =
            regular_edge(p[u] + p[u + w], p[u - 1] + p[u + 1] + p[u + w - 1] + p[u + w + 1]);
      }
    } else {
      for (int u = 0; u < m; ++u) {
        row[2 * u + 1] =
            regular_edge(p[u] + p[u + 1], p[u - w] + p[u + 1 - w] + p[u + w] + p[u + 1 + w]);
        if (u == 0) continue;
        row[2 * u] = regular_vertex(p[u], p[u - 1] + p[u + 1] + p[u - w] + p[u + w],
                                    p[u - w - 1] + p[u - w + 1] + p[u + w - 1] + p[u + w + 1]);
      }
    }
  }
}

template <class Point>
void BasicCellPatch<Point>::refine_side(int c, std::vector<Point>& fine) const {
  const int m = cells();
  const PatchSide from = side(c, m), to = side(c, 2 * m);
  const double s = sharpness_[c], blend = std::min(s, 1.0);
  for (int t = 1; t < 2 * m; ++t) {
    const Point* p = &net_[from.base + (t / 2) * from.along];
    const int a = from.along, o = from.outward;
    Vec3 sharp, smooth;
    if (t % 2 == 1) {
      sharp = (p[0] + p[a]) * 0.5;
      if (blend < 1) smooth = regular_edge(p[0] + p[a], p[o] + p[o + a] + p[-o] + p[a - o]);
    } else {
      sharp = p[0] * 0.75 + (p[a] + p[-a]) * 0.125;
      if (blend < 1)
        smooth = regular_vertex(p[0], p[a] + p[-a] + p[o] + p[-o],
                                p[o + a] + p[o - a] + p[a - o] + p[-a - o]);
    }
    fine[to.base + t * to.along] = blend < 1 ? lerp(smooth, sharp, blend) : sharp;
  }
}

template <class Point>
void BasicCellPatch<Point>::refine_strip(int c, std::vector<Point>& fine) const {
  const int m = cells();
  const PatchSide from = side(c, m), to = side(c, 2 * m);
  for (int t = 1; t < 2 * m; ++t) {
    const Point* p = &net_[from.base + (t / 2) * from.along];
    const int a = from.along, o = from.outward;
    fine[to.base + t * to.along + to.outward] =
        t % 2 == 1 ? (p[0] + p[a] + p[o] + p[a + o]) * 0.25
                   : regular_edge(p[0] + p[o], p[a] + p[-a] + p[o + a] + p[o - a]);
  }
}

template <class Point>
LimitPatch BasicCellPatch<Point>::limit() const {
  LimitPatch limit;
  limit.depth = depth_;
  const auto count = static_cast<std::size_t>(cells() + 1) * static_cast<std::size_t>(cells() + 1);
  limit.points.resize(count);
  limit.normals.resize(count);
  limit_interior(limit);
  for (int c = 0; c < 4; ++c) limit_side(c, limit);
  limit_corners(limit);
  return limit;
}

namespace {

/// Regular limit masks at `p`, neighbours by strides `a` (first direction) and `b` (second).
template <class Point>
void regular_limit(const Point* p, int a, int b, Vec3& point, Vec3& normal) {
  const Vec3 plus = p[a + b], minus = p[-a - b], left = p[b - a], right = p[a - b];
  point = (p[0] * 16.0 + (p[a] + p[-a] + p[b] + p[-b]) * 4.0 + plus + minus + left + right) / 36.0;
  const Vec3 along_a = (p[a] - p[-a]) * 4.0 + plus + right - left - minus;
  const Vec3 along_b = (p[b] - p[-b]) * 4.0 + plus + left - right - minus;
  normal = normalized(cross(along_a, along_b));
}

}  // namespace

template <class Point>
void BasicCellPatch<Point>::limit_interior(LimitPatch& limit) const {
  const int m = cells(), w = width();
  for (int v = 1; v < m; ++v)
    for (int u = 1; u < m; ++u) {
      const int i = limit.index(u, v);
      regular_limit(&net_[at(u, v)], 1, w, limit.points[i], limit.normals[i]);
    }
}

template <class Point>
void BasicCellPatch<Point>::limit_side(int c, LimitPatch& limit) const {
  const int m = cells();
  const PatchSide s = side(c, m);
  const int row = m + 1;
  const std::array<int, 4> corner = {0, m, m * row + m, m * row};
  const std::array<int, 4> step = {1, row, -1, -row};
  for (int t = 1; t < m; ++t) {
    const int i = corner[c] + t * step[c];
    const Point* p = &net_[s.base + t * s.along];
    const int a = s.along, in = -s.outward;
    if (!is_sharp(sharpness_[c])) {
      regular_limit(p, a, in, limit.points[i], limit.normals[i]);
      continue;
    }
    limit.points[i] = (p[0] * 4.0 + p[a] + p[-a]) / 6.0;
    const Vec3 inward = (p[in] - p[0]) * 4.0 + p[in + a] + p[in - a] - p[a] - p[-a];
    limit.normals[i] = normalized(cross(p[a] - p[-a], inward));
  }
}

template <class Point>
void BasicCellPatch<Point>::limit_corners(LimitPatch& limit) const {
  const int m = cells();
  const std::array<int, 4> corner = {limit.index(0, 0), limit.index(m, 0), limit.index(m, m),
                                     limit.index(0, m)};
  for (int c = 0; c < 4; ++c) {
    limit.points[corner[c]] = rings_[c].limit_point();
    limit.normals[corner[c]] = rings_[c].limit_normal();
  }
}

template <class Point>
std::size_t BasicCellPatch<Point>::memory_bytes_of(std::size_t point_bytes) const {
  std::size_t bytes = sizeof(*this) + net_.capacity() * point_bytes;
  for (const CornerRing& ring : rings_) bytes += ring.memory_bytes();
  return bytes;
}

std::size_t cell_bytes_counted(int depth, std::size_t point_bytes) {
  const std::size_t side = (std::size_t{1} << depth) + 1;
  return (side * side + 4 * side) * point_bytes;
}

std::size_t half_edge_bytes_counted(int depth, std::size_t point_bytes) {
  constexpr std::size_t kPointers = 22, kPointerBytes = 8;
  const std::size_t side = (std::size_t{1} << depth) + 1;
  return side * side * (point_bytes + kPointers * kPointerBytes);
}

template class BasicCellPatch<Vec3>;
template class BasicCellPatch<FloatPoint>;

}  // namespace limitgauge::engine::surface
