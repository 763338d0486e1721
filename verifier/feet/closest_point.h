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
/// Proof: verifier/feet/FEET.md.
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
