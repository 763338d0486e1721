#pragma once

#include <optional>

#include "model/geometry/interval.h"
#include "verifier/cells/surface_cells.h"

namespace limitgauge::verifier {

/// Boxes that hold the derivatives of S over a cell, first and second, by its patch's parameters or
/// by others, in mm per unit of them.
struct DerivativeHull {
  model::Box3 u, v, uu, uv, vv;
};
/// By the patch's parameters: the hull of the Bézier coefficients of each.
DerivativeHull derivative_hull(const SurfaceCell& cell);

/// Parameters (x, y) in which S is nearly a plane in square millimetres about a cell's middle,
/// where bounds on products of derivatives are tightest: u = x·u_x + y·u_y, v = y·v_y.
struct PlaneParameters {
  double u_x = 1, u_y = 0, v_y = 1;
  double along_u_mm = 0, along_v_mm = 0;  ///< lengths of S_u and S_v in the middle
  model::Vec3 t, b;                       ///< unit vectors along S_x and S_y in the middle

  /// None where S has no plane.
  static std::optional<PlaneParameters> of(const SurfaceCell& cell);
  /// What a hull by u and v is by x and y.
  DerivativeHull taken(const DerivativeHull& by_uv) const;
};

/// Holds d·x for every x of the box.
model::Interval along(const model::Box3& box, const model::Vec3& d);
/// No x of the box is longer.
double longest(const model::Box3& box);

}  // namespace limitgauge::verifier
