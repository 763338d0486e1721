#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "verifier/surface/bezier.h"
#include "verifier/surface/surface_tree.h"

namespace limitgauge::verifier {

/// A part of the limit surface with what a search for the nearest point needs to know beforehand.
/// Its ranges bound the Hessian of the squared distance over the whole cell (FEET.md, F4).
struct FootCell {
  struct Range {
    double low = 0, high = 0;
  };
  using LocalBox = std::array<Range, 3>;  ///< by axis of `frame`
  Bezier shape;
  BezierJet middle;  ///< at (1/2, 1/2)
  std::array<model::Vec3, 3> frame = {model::Vec3{1, 0, 0}, model::Vec3{0, 1, 0},
                                      model::Vec3{0, 0, 1}};
  LocalBox ss{}, st{}, tt{};     ///< second derivatives of S
  Range own_ss, own_st, own_tt;  ///< those of |S − S(middle)|²/2
  int patch = 0;
  double u = 0, v = 0, size_u = 1, size_v = 1;
  model::Vec3 vertex_normal, vertex_u, vertex_v;  ///< of a cell that is one point
  bool is_point = false;
  /// Of the sides t = 0, s = 1, t = 1, s = 0: on a boundary or crease, where a foot may be held.
  std::array<SurfaceFeature, 4> sides{};

  double u_at(double s) const { return u + s * size_u; }
  double v_at(double t) const { return v + t * size_v; }
};

/// The limit surface in cells over which the metric is even enough for Newton's method. What lies
/// within kOmitted_mm of an irregular vertex is stood for by the vertex.
inline constexpr double kFootOmitted_mm = 1e-10;
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

/// Takes over into `best` the nearest point of cell number `index` if it is nearer than `best`, or
/// as near but for rounding and more surely a foot: distances are level about a foot, so that they
/// tell its place to 1e-8 only. Proven: no point of the cell is nearer than the `best` left behind
/// by more than kFootTolerance_mm (see closest_point.h).
inline constexpr double kFootTolerance_mm = 1e-10;
void nearer_in(const FootCell& cell, std::uint32_t index, const model::Vec3& p, Foot& best);

/// Looks for a place that is more surely a foot, downhill from the point of the cell next to
/// `best`.
void settle_in(const FootCell& cell, std::uint32_t index, const model::Vec3& p,
               const model::Vec3& best_place, Foot& best);
/// A foot that is no more than this aside needs no settling.
inline constexpr double kSettled_mm = 1e-11;

}  // namespace limitgauge::verifier
