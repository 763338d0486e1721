#pragma once

#include <array>
#include <vector>

#include "verifier/cells/offset_cell.h"
#include "verifier/gate/deviation.h"
#include "verifier/surface/surface_tree.h"

namespace limitgauge::verifier {

/// A piece of a sharp edge of S, or a sharp vertex, with a part of the normals that lie between
/// those of the faces which meet there: at every point, all positive combinations of two (on an
/// edge) or three (at a vertex) vectors, each a polynomial of degree 5 along the edge.
struct RidgeCell {
  Bezier shape;  ///< the edge along u, the same for every v; of a vertex one point
  std::array<std::array<model::Vec3, 6>, 3> normals{};
  int count = 2;  ///< of `normals`
  int patch = 0;
  double u0 = 0, v0 = 0, u1 = 0, v1 = 0;  ///< parameters of the edge's ends in a patch beside it

  SurfacePlace place() const;
  OffsetCell offset() const;
  /// Halves along the edge, or of the normals: by which of the two the places `t_mm` away from the
  /// cell spread more.
  std::array<RidgeCell, 2> halved(double t_mm) const;
  /// Halves of the normals, between the two at the middle that are the furthest apart.
  std::array<RidgeCell, 2> halved_fan() const;
  /// No two of its normals at any one point of the edge are further apart, rad.
  double fan_rad() const;
  /// The same piece with nothing but the middle normal at every point of it.
  RidgeCell without_fan() const;
  /// So small that its middle may stand for it.
  bool is_tiny() const;
};

/// The edge as another frame has it.
RidgeCell turned(RidgeCell cell, const model::Pose& pose);

/// All sharp edges and vertices of S but those where S is proven to be concave, and those without a
/// jump of the normal. Edges are cut to `radius_mm`.
std::vector<RidgeCell> ridge_cells(const SurfaceTree& tree, double radius_mm);

}  // namespace limitgauge::verifier
