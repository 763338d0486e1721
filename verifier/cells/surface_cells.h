#pragma once

#include <vector>

#include "model/geometry/box_tree.h"
#include "verifier/cells/ridge_cells.h"
#include "verifier/feet/foot_tree.h"
#include "verifier/gate/deviation.h"
#include "verifier/surface/surface_tree.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

/// A rectangle of a patch's parameters and the polynomial over it.
struct SurfaceCell {
  Bezier shape;
  int patch = 0;
  double u = 0, v = 0, size_u = 1, size_v = 1;

  /// Of a cell that is one point, an irregular vertex, or so near to one that its own slopes cannot
  /// be told from its coordinates: the one beside it.
  model::Vec3 vertex_normal = {};

  double u_at(double s) const { return u + s * size_u; }
  double v_at(double t) const { return v + t * size_v; }
};
/// The middle's place; `point` is where it lies.
inline SurfacePlace middle_place(const SurfaceCell& cell, const model::Vec3& point) {
  return {cell.patch, cell.u_at(0.5), cell.v_at(0.5), point};
}
/// Unit normal at the middle.
model::Vec3 middle_normal(const SurfaceCell& cell);
std::array<SurfaceCell, 2> split_u(const SurfaceCell& cell);
std::array<SurfaceCell, 2> split_v(const SurfaceCell& cell);
/// The halves of the longer way, by longer_in_u.
std::array<SurfaceCell, 2> halved(const SurfaceCell& cell);

/// A part of one of the cells that a surface is held in, by its parameters alone: a tenth of its
/// size.
struct CellPart {
  std::uint32_t whole = 0;  ///< index of the cell
  double u = 0, v = 0, size_u = 1, size_v = 1;
};

std::array<CellPart, 2> halved(const CellPart& part, bool in_u);

/// Where branch and bound over a surface starts: cells small enough that few moves matter to each,
/// and no more than a few hundred thousand on a large part.
double first_cell_radius_mm(const SurfaceTree& tree);

/// The limit surface as small cells under a tree of boxes, shared by every search over it. Pieces
/// that lie within kOmitted_mm of an irregular vertex are stood for by the vertex: a function that
/// changes by at most a millimetre a millimetre is wrong there by at most kOmitted_mm.
class SurfaceCells {
 public:
  /// Cells are split until their control points lie within `radius_mm` of their middle, those of
  /// facets also where their area is no more than its square.
  SurfaceCells(const SurfaceTree& tree, double radius_mm);

  /// The same cells, one by one, as another frame has them, for what is asked of cells and their
  /// boxes: closest points, which reach does not ask for, are not held.
  SurfaceCells turned(const model::Pose& pose) const;

  const std::vector<SurfaceCell>& cells() const { return cells_; }
  CellPart whole(std::uint32_t index) const;
  SurfaceCell cell_of(const CellPart& part) const;
  /// Sharp edges and vertices, with the normals between those of the cells beside them.
  const std::vector<RidgeCell>& ridges() const { return ridges_; }

  /// The tree over the control boxes of the cells, which lie in the order of its leaves.
  const std::vector<model::BoxNode>& nodes() const { return nodes_; }
  /// The same surface as closest-point searches see it: its own cells, whatever `radius_mm` is.
  const FootTree& feet() const { return feet_; }
  /// Whether S ends along a side of the cell, numbered as PatchFeatures has them.
  bool is_rim(const SurfaceCell& cell, int side) const;
  /// Whether the cell lies along an open boundary of S and is no wider than `width_mm` across it.
  bool is_rim_strip(const SurfaceCell& cell, double width_mm) const;
  const SurfaceFeatures& features() const { return features_; }

 private:
  SurfaceCells() = default;

  std::vector<SurfaceCell> cells_;
  std::vector<RidgeCell> ridges_;
  std::vector<model::BoxNode> nodes_;
  FootTree feet_;
  SurfaceFeatures features_;
};

}  // namespace limitgauge::verifier
