#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/base/run_control.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/gate/deviation.h"
#include "verifier/surface/surface_features.h"

namespace limitgauge::verifier {

struct ClosestPoint {
  SurfacePlace place;
  model::Vec3 normal;      ///< unit normal of S there; at a crease, that of the patch named
  double distance_mm = 0;  ///< unsigned
  /// What S is like there, within 1e-9 mm.
  SurfaceFeature feature = SurfaceFeature::smooth;
  bool open = false;  ///< the place is on the boundary: S does not go all round it
  /// The connection to the query leaves S along `normal`. Otherwise it lies in the cone of normals
  /// of a boundary, a crease or a corner. Always true of smooth places, and of queries on S.
  bool perpendicular = false;
};

/// The point of the surface nearest to `p`, where it is nearer than `within_mm`. Where several are
/// equally near, one of them, always the same. For coordinates up to 10 m:
///  - the distance is proven to be the least over all of S, within 1e-9 mm;
///  - the place is on S within 1e-10 mm;
///  - it is the foot itself within 1e-9 mm, except where the distance does not tell its place: with
///    S curved about the query, or beside an irregular vertex by less than 1e-6 mm, where S is made
///    of pieces too small for their slopes to be known from their coordinates.
///
/// Proof. S is the union of the Bézier cells of a FootTree (and of vertices that stand for what
/// lies within 1e-10 mm of them), so the least over the cells is the least over S. With
/// f = |S(s, t) − p|²/2 and q the nearest point so far, a cell is left
///  - unvisited, where its box or its parent's is no nearer to p than q is: a cell lies in the hull
///    of its control points, and those lie in the box;
///  - after solving, where for a point x of it, by Taylor's theorem along the segment from x to y,
///        f(y) ≥ f(x) + g·(y − x) + (a·(y_s − x_s)² + b·(y_t − x_t)²)/2   for every y of the cell,
///    g being the gradient in x and diag(a, b) below the Hessian of f over all of the cell; and the
///    least of the right side over the rectangle, which is a closed form since it separates, is at
///    least |q − p|²/2 − |q − p|·1e-10 mm. Newton's method finds x and, where that is nearer, it
///    becomes q. Where a, b ≥ 0, f is convex and the foot is unique: then the right side at the
///    foot is f(x) itself, up to what is left of the gradient;
///  - else halved, when f is a polynomial of degree (6, 6) in Bernstein form, whose least
///    coefficient bounds it and whose second differences bound its Hessian, both ever closer with
///    the square of the size. The halving ends at the latest when the bounds are within the
///    tolerance. At a centre of curvature, where many feet are equally near, this decides; where a
///    whole curve of feet is, it takes up to a second.
/// a and b follow from the range of the Hessian (see FootCell), as |h_st·x·y| ≤
/// (|h_st|/√(h_ss·h_tt))·(h_ss·x² + h_tt·y²)/2. Rounding is not directed: f is computed to a few
/// times 1e-16 of |p − S|² and of the coordinates times |p − S|, a tenth of the tolerance at 10 m.
std::optional<ClosestPoint> closest_point(const SurfaceCells& cells, const model::Vec3& p,
                                          double within_mm);

/// The same for many queries: entry i is exactly what `closest_point` gives for points[i], for any
/// number of threads. Throws model::Interrupted when `control` asks to stop.
std::vector<std::optional<ClosestPoint>> closest_points(const SurfaceCells& cells,
                                                        std::span<const model::Vec3> points,
                                                        double within_mm,
                                                        const model::RunControl& control);

/// Distance of `p` from S, positive on the machining side; `closest` is what closest_point gave for
/// `p`. At creases and corners the side is that of the pseudo-normal, the mean of the normals of
/// the adjoining patches weighted by their angles (Bærentzen and Aanæs, Signed distance computation
/// using the angle weighted pseudonormal, 2005). Empty beyond an open boundary, where S has no
/// sides.
std::optional<double> signed_distance_mm(const SurfaceCells& cells, const model::Vec3& p,
                                         const ClosestPoint& closest);

}  // namespace limitgauge::verifier
