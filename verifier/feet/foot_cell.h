#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "model/geometry/interval.h"
#include "verifier/surface/bezier.h"
#include "verifier/surface/surface_tree.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

/// A part of the limit surface with what a search for the nearest point needs to know beforehand.
/// Its ranges bound the Hessian of the squared distance over the whole cell (FEET.md, F4).
struct FootCell {
  using LocalBox = std::array<model::Interval, 3>;  ///< by axis of `frame`
  Bezier shape;
  BezierJet middle;  ///< at (1/2, 1/2)
  std::array<model::Vec3, 3> frame = {model::Vec3{1, 0, 0}, model::Vec3{0, 1, 0},
                                      model::Vec3{0, 0, 1}};
  LocalBox ss{}, st{}, tt{};               ///< second derivatives of S
  model::Interval own_ss, own_st, own_tt;  ///< those of |S − S(middle)|²/2
  int patch = 0;
  double u = 0, v = 0, size_u = 1, size_v = 1;
  model::Vec3 vertex_normal, vertex_u, vertex_v;  ///< of a cell that is one point
  bool is_point = false;
  /// Of the sides t = 0, s = 1, t = 1, s = 0: on a boundary or crease, where a foot may be held.
  std::array<SurfaceFeature, 4> sides{};

  double u_at(double s) const { return u + s * size_u; }
  double v_at(double t) const { return v + t * size_v; }
};

std::vector<FootCell> foot_cells(const SurfaceTree& tree);

/// The nearest point found so far.
struct Foot {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  double squared = std::numeric_limits<double>::infinity();
  std::uint32_t cell = kNone;
  double s = 0.5, t = 0.5;
  /// How far the connection runs aside of the normals in the place, less what a boundary or crease
  /// holds up: zero at a foot, and where a cell merely ends before the foot, how far before.
  double aside_mm = std::numeric_limits<double>::infinity();
  bool at_crease = false;  ///< a crease holds it up; the foot may lie beyond
};

void nearer_in(const FootCell& cell, std::uint32_t index, const model::Vec3& p, Foot& best);

/// Looks for a place that is more surely a foot, downhill from the point of the cell next to
/// `best`.
void settle_in(const FootCell& cell, std::uint32_t index, const model::Vec3& p,
               const model::Vec3& best_place, Foot& best);

}  // namespace limitgauge::verifier
