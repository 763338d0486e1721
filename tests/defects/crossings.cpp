#include "tests/defects/crossings.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;

constexpr double kItself_mm = 1e-5;
/// Residuals that are a meeting for sure, and that may be one.
constexpr double kMeets_mm = 1e-9, kMayMeet_mm = 1e-5;
/// Cosine from which two sheets in one place lie back to back.
constexpr double kBackToBack = -1 + 1e-9;
/// |n·d| from which S is passed and not grazed.
constexpr double kPasses = 1e-4;

bool hits(const model::Box3& box, const Vec3& from, const Vec3& along, double least, double limit) {
  for (int axis = 0; axis < 3; ++axis) {
    if (along[axis] == 0) {
      if (from[axis] < box.low[axis] || from[axis] > box.high[axis]) return false;
      continue;
    }
    double a = (box.low[axis] - from[axis]) / along[axis],
           b = (box.high[axis] - from[axis]) / along[axis];
    if (a > b) std::swap(a, b);
    least = std::max(least, a), limit = std::min(limit, b);
    if (least > limit) return false;
  }
  return true;
}

}  // namespace

Crossings::Crossings(const SampledSurface& surface) : surface_(surface) {
  for (const SampledSurface::Grid& grid : surface.grids()) add_cells(grid);
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(cells_.size()));
}

void Crossings::add_cells(const SampledSurface::Grid& grid) {
  const auto& nodes = surface_.nodes();
  const int n = grid.steps;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const std::size_t k = grid.first + static_cast<std::size_t>(j) * (n + 1) + i;
      Cell cell{grid.patch, nodes[k].place.u, nodes[k].place.v, 1.0 / n, {}};
      for (const std::size_t corner : {k, k + 1, k + n + 1, k + n + 2})
        cell.box.add(nodes[corner].point);
      // Cells bulge out of the box of their corners by a small part of their size.
      cell.box = cell.box.grown(0.1 * length(cell.box.size()) + kMayMeet_mm);
      cells_.push_back(cell);
    }
}

void Crossings::build(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  constexpr std::uint32_t kLeaf = 4;
  model::Box3 box, middles;
  for (std::uint32_t k = first; k < first + count; ++k)
    box.add(cells_[k].box), middles.add(cells_[k].box.centre());
  nodes_[node] = {box, first, count};
  if (count <= kLeaf) return;
  const Vec3 size = middles.size();
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto begin = cells_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](const Cell& a, const Cell& b) {
    return a.box.centre()[axis] < b.box.centre()[axis];
  });
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node] = {box, child, 0};
  nodes_.resize(nodes_.size() + 2);
  build(child, first, count / 2);
  build(child + 1, first + count / 2, count - count / 2);
}

Crossings::First Crossings::first(const Vec3& from, const Vec3& along, double least, double limit,
                                  const Vec3& except, const Vec3& facing) const {
  First out{limit, limit};
  std::vector<std::uint32_t> stack = {0};
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    if (!hits(node.box, from, along, least, out.sure)) continue;
    if (node.count == 0) {
      stack.push_back(node.first), stack.push_back(node.first + 1);
      continue;
    }
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      if (hits(cells_[k].box, from, along, least, out.sure))
        meet(cells_[k], from, along, least, except, facing, out);
  }
  return out;
}

/// Gauss-Newton for the nearest approach of ray and cell, from the cell's middle.
void Crossings::meet(const Cell& cell, const Vec3& from, const Vec3& along, double least,
                     const Vec3& except, const Vec3& facing, First& out) const {
  constexpr int kMostSteps = 30;
  const double u0 = std::max(0.0, cell.u - cell.size / 2),
               u1 = std::min(1.0, cell.u + 1.5 * cell.size),
               v0 = std::max(0.0, cell.v - cell.size / 2),
               v1 = std::min(1.0, cell.v + 1.5 * cell.size);
  Place at{cell.patch, cell.u + cell.size / 2, cell.v + cell.size / 2};
  double t = 0;
  Vec3 apart;
  verifier::SurfaceSample s;
  for (int step = 0; step < kMostSteps; ++step) {
    s = surface_.at(at);
    t = dot(s.position - from, along);
    apart = s.position - from - along * t;
    // Derivatives across the ray.
    const Vec3 a = s.du - along * dot(s.du, along), b = s.dv - along * dot(s.dv, along);
    const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), ra = dot(a, apart),
                 rb = dot(b, apart), det = aa * bb - ab * ab;
    if (det <= 1e-14 * (aa + bb) * (aa + bb)) {
      if (aa + bb == 0) break;
      const double along_a = aa >= bb ? -ra / aa : 0, along_b = aa >= bb ? 0 : -rb / bb;
      at.u = std::clamp(at.u + along_a / 2, u0, u1), at.v = std::clamp(at.v + along_b / 2, v0, v1);
      continue;
    }
    const double u = std::clamp(at.u + (-ra * bb + rb * ab) / det, u0, u1),
                 v = std::clamp(at.v + (-rb * aa + ra * ab) / det, v0, v1);
    const bool still = std::abs(u - at.u) + std::abs(v - at.v) < 1e-15;
    at.u = u, at.v = v;
    if (still) break;
  }
  const double miss = length(apart);
  if (miss > kMayMeet_mm) return;
  if (distance(s.position, except) <= kItself_mm) {
    // The back of another sheet, on s itself.
    if (dot(s.normal, facing) < kBackToBack) out.possible = 0;
    return;
  }
  if (t <= least) return;
  out.possible = std::min(out.possible, t);
  if (miss <= kMeets_mm && std::abs(dot(s.normal, along)) > kPasses)
    out.sure = std::min(out.sure, t);
}

}  // namespace limitgauge::tests::defects
