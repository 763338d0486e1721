#include "verifier/cells/surface_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace limitgauge::verifier {

using model::Vec3;

namespace {

constexpr std::uint32_t kLeafCells = 2;

/// The first or the second half of a cell's parameters.
template <class Cell>
Cell half_of(Cell cell, bool in_u, int half) {
  double& size = in_u ? cell.size_u : cell.size_v;
  size /= 2;
  (in_u ? cell.u : cell.v) += half * size;
  return cell;
}

SurfaceCell part(const SurfaceCell& cell, const Bezier& shape, bool in_u, int half) {
  SurfaceCell out = half_of(cell, in_u, half);
  out.shape = shape;
  return out;
}

/// Where splitting ends: cells whose control points lie within `radius_mm` of their middle, or that
/// are smaller than `area_mm2`.
struct FirstCells {
  double radius_mm = 0, area_mm2 = 0;

  bool ends_at(const SurfaceCell& cell) const {
    if (control_radius(cell.shape, middle(cell.shape)) <= radius_mm) return true;
    return area_mm2 > 0 && corner_area_mm2(cell.shape) <= area_mm2;
  }
  static double corner_area_mm2(const Bezier& b) {
    return length(cross(b.control(15) - b.control(0), b.control(12) - b.control(3))) / 2;
  }
};

void split_until(const SurfaceCell& cell, const FirstCells& first, std::vector<SurfaceCell>& out) {
  if (first.ends_at(cell)) {
    out.push_back(cell);
    return;
  }
  for (const SurfaceCell& half :
       extent_u(cell.shape) >= extent_v(cell.shape) ? split_u(cell) : split_v(cell))
    split_until(half, first, out);
}

/// The normal of the piece of its patch that lies nearest to a speck, but beyond the pieces that
/// lose theirs in rounding. At a vertex where the tangent plane turns with the way that leads
/// there, or tends to its limit more slowly than any scale that can be cut, this is what can be
/// measured.
Vec3 normal_beside(const Speck& speck, std::span<const Piece> pieces) {
  double least = std::numeric_limits<double>::infinity();
  Vec3 normal = speck.normal;
  for (const Piece& piece : pieces) {
    const double radius = control_radius(piece.shape, speck.position);
    if (radius <= kVertexNormal_mm || radius >= least) continue;
    const BezierJet j = jet(piece.shape, 0.5, 0.5);
    const Vec3 n = cross(j.du, j.dv);
    if (length_squared(n) > 0) least = radius, normal = normalized(n);
  }
  return normal;
}

}  // namespace

Vec3 middle_normal(const SurfaceCell& cell) {
  if (length_squared(cell.vertex_normal) > 0) return cell.vertex_normal;
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

std::array<CellPart, 2> halved(const CellPart& part, bool in_u) {
  return {half_of(part, in_u, 0), half_of(part, in_u, 1)};
}

double first_cell_radius_mm(const SurfaceTree& tree) {
  constexpr double kSmall_mm = 0.3, kCells = 200'000;
  return std::max(kSmall_mm, std::sqrt(tree.area_mm2() / kCells));
}

SurfaceCells::SurfaceCells(const SurfaceTree& tree, double radius_mm)
    : ridges_(ridge_cells(tree, radius_mm)), feet_(tree), features_(tree.features()) {
  // A facet that is long and thin has both its parameters along its length: as small as others, its
  // cells would be as many as the square of how many times they go into that.
  const FirstCells first{radius_mm, tree.is_faceted() ? radius_mm * radius_mm : 0};
  for (const Speck& s : tree.specks()) {
    SurfaceCell cell{{}, s.square.patch, s.square.u, s.square.v, s.square.size, s.square.size};
    for (int k = 0; k < 16; ++k) cell.shape.set(k, s.position);
    cells_.push_back(cell);
  }
  std::size_t first_speck = 0;
  for (int patch = 0; patch < tree.patch_count(); ++patch) {
    const std::vector<Piece> pieces = tree.pieces_beyond(patch, kOmitted_mm);
    const std::span<const Speck> specks = tree.specks_of(patch);
    for (std::size_t i = 0; i < specks.size(); ++i)
      cells_[first_speck + i].vertex_normal = normal_beside(specks[i], pieces);
    for (const Piece& piece : pieces) {
      const ParameterSquare& q = piece.square;
      SurfaceCell cell{piece.shape, q.patch, q.u, q.v, q.size, q.size};
      for (std::size_t i = 0; i < specks.size(); ++i)
        if (control_radius(piece.shape, specks[i].position) <= kVertexNormal_mm)
          cell.vertex_normal = cells_[first_speck + i].vertex_normal;
      split_until(cell, first, cells_);
    }
    first_speck += specks.size();
  }
  std::vector<model::Box3> boxes;
  boxes.reserve(cells_.size());
  for (const SurfaceCell& cell : cells_) boxes.push_back(control_box(cell.shape));
  model::BoxTree tree_of_cells = model::box_tree(boxes, kLeafCells);
  std::vector<SurfaceCell> sorted;
  sorted.reserve(cells_.size());
  for (const std::uint32_t i : tree_of_cells.order) sorted.push_back(cells_[i]);
  cells_ = std::move(sorted);
  nodes_ = std::move(tree_of_cells.nodes);
}

SurfaceCells SurfaceCells::turned(const model::Pose& pose) const {
  SurfaceCells out;
  out.features_ = features_;
  out.cells_ = cells_;
  for (SurfaceCell& cell : out.cells_) {
    cell.shape = verifier::turned(cell.shape, pose);
    cell.vertex_normal = pose.direction(cell.vertex_normal);
  }
  for (const RidgeCell& ridge : ridges_) out.ridges_.push_back(verifier::turned(ridge, pose));
  out.nodes_ = nodes_;
  // Children lie behind their parents: from the back, both are there before they are needed.
  for (std::size_t n = out.nodes_.size(); n-- > 0;) {
    model::BoxNode& node = out.nodes_[n];
    node.box = {};
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      node.box.add(control_box(out.cells_[k].shape));
    if (node.count == 0)
      node.box.add(out.nodes_[n + 1].box), node.box.add(out.nodes_[node.right].box);
  }
  return out;
}

CellPart SurfaceCells::whole(std::uint32_t index) const {
  const SurfaceCell& cell = cells_[index];
  return {index, cell.u, cell.v, cell.size_u, cell.size_v};
}

SurfaceCell SurfaceCells::cell_of(const CellPart& part) const {
  SurfaceCell cell = cells_[part.whole];
  if (part.size_u == cell.size_u && part.size_v == cell.size_v) return cell;
  // Halves of halves: exact in binary.
  const double s = (part.u - cell.u) / cell.size_u, t = (part.v - cell.v) / cell.size_v;
  cell.shape =
      restrict(cell.shape, s, s + part.size_u / cell.size_u, t, t + part.size_v / cell.size_v);
  cell.u = part.u, cell.v = part.v, cell.size_u = part.size_u, cell.size_v = part.size_v;
  return cell;
}

bool SurfaceCells::is_rim(const SurfaceCell& cell, int side) const {
  const bool on_side[] = {cell.v <= 0, cell.u_at(1) >= 1, cell.v_at(1) >= 1, cell.u <= 0};
  return on_side[side] && features_.of(cell.patch).sides[side] == SurfaceFeature::boundary;
}

bool SurfaceCells::is_rim_strip(const SurfaceCell& cell, double width_mm) const {
  for (int side = 0; side < 4; ++side)
    if (is_rim(cell, side) &&
        (side % 2 == 0 ? extent_v(cell.shape) : extent_u(cell.shape)) <= width_mm)
      return true;
  return false;
}

}  // namespace limitgauge::verifier
