#include "verifier/surface_cells.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace limitgauge::verifier {

using model::Box3;
using model::Vec3;

namespace {

constexpr std::uint32_t kLeafCells = 2;

SurfaceCell part(const SurfaceCell& cell, const Bezier& shape, bool in_u, int half) {
  SurfaceCell out = cell;
  out.shape = shape;
  double& size = in_u ? out.size_u : out.size_v;
  size /= 2;
  (in_u ? out.u : out.v) += half * size;
  return out;
}

double extent_u(const Bezier& b) {
  double longest = 0;
  for (int j = 0; j < 4; ++j)
    longest = std::max(longest, distance(b.control(4 * j), b.control(4 * j + 3)));
  return longest;
}
double extent_v(const Bezier& b) {
  double longest = 0;
  for (int i = 0; i < 4; ++i)
    longest = std::max(longest, distance(b.control(i), b.control(12 + i)));
  return longest;
}

void split_until(const SurfaceCell& cell, double radius_mm, std::vector<SurfaceCell>& out) {
  if (control_radius(cell.shape, middle(cell.shape)) <= radius_mm) {
    out.push_back(cell);
    return;
  }
  for (const SurfaceCell& half :
       extent_u(cell.shape) >= extent_v(cell.shape) ? split_u(cell) : split_v(cell))
    split_until(half, radius_mm, out);
}

}  // namespace

Vec3 middle_normal(const SurfaceCell& cell) {
  const BezierJet j = jet(cell.shape, 0.5, 0.5);
  const Vec3 normal = cross(j.du, j.dv);
  return length_squared(normal) > 0 ? normalized(normal) : cell.vertex_normal;
}

std::array<SurfaceCell, 2> split_u(const SurfaceCell& cell) {
  const auto [a, b] = split_u(cell.shape);
  return {part(cell, a, true, 0), part(cell, b, true, 1)};
}
std::array<SurfaceCell, 2> split_v(const SurfaceCell& cell) {
  const auto [a, b] = split_v(cell.shape);
  return {part(cell, a, false, 0), part(cell, b, false, 1)};
}
std::array<SurfaceCell, 2> halved(const SurfaceCell& cell) {
  return longer_in_u(cell.shape) ? split_u(cell) : split_v(cell);
}

SurfaceCells::SurfaceCells(const SurfaceTree& tree, double radius_mm)
    : feet_(tree), features_(tree.features()) {
  std::map<int, std::vector<Vec3>> specks;
  for (const Speck& s : tree.specks()) {
    specks[s.square.patch].push_back(s.position);
    SurfaceCell cell{{}, s.square.patch, s.square.u, s.square.v, s.square.size, s.square.size};
    for (int k = 0; k < 16; ++k) cell.shape.set(k, s.position);
    cell.vertex_normal = s.normal;
    cells_.push_back(cell);
  }
  for (const Piece& piece : tree.pieces()) {
    const ParameterSquare& q = piece.square;
    const auto near = specks.find(q.patch);
    if (near != specks.end() &&
        std::any_of(near->second.begin(), near->second.end(),
                    [&](const Vec3& p) { return control_radius(piece.shape, p) < kOmitted_mm; }))
      continue;
    split_until({piece.shape, q.patch, q.u, q.v, q.size, q.size}, radius_mm, cells_);
  }
  if (cells_.empty()) return;
  std::vector<Box3> boxes;
  for (const SurfaceCell& cell : cells_) boxes.push_back(control_box(cell.shape));
  std::vector<std::uint32_t> order(cells_.size());
  std::iota(order.begin(), order.end(), 0U);
  build(order, boxes, 0, static_cast<std::uint32_t>(order.size()));
  std::vector<SurfaceCell> sorted;
  sorted.reserve(cells_.size());
  for (const std::uint32_t i : order) sorted.push_back(cells_[i]);
  cells_ = std::move(sorted);
}

std::uint32_t SurfaceCells::build(std::vector<std::uint32_t>& order, const std::vector<Box3>& boxes,
                                  std::uint32_t first, std::uint32_t count) {
  const auto here = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box3 box, centres;
  for (std::uint32_t k = first; k < first + count; ++k) {
    box.add(boxes[order[k]]);
    centres.add(boxes[order[k]].centre());
  }
  nodes_[here].box = box;
  if (count <= kLeafCells) {
    nodes_[here].first = first, nodes_[here].count = count;
    return here;
  }
  const Vec3 size = centres.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::uint32_t half = count / 2;
  const auto begin = order.begin() + first;
  std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
    const double ca = boxes[a].centre()[axis], cb = boxes[b].centre()[axis];
    return ca != cb ? ca < cb : a < b;
  });
  build(order, boxes, first, half);
  const std::uint32_t right = build(order, boxes, first + half, count - half);
  nodes_[here].right = right;
  return here;
}

}  // namespace limitgauge::verifier
