#pragma once

#include <array>
#include <optional>

#include "verifier/cells/surface_cells.h"
#include "verifier/cutter/removed_space.h"

namespace limitgauge::verifier {

/// What is looked for along the normals of S.
enum class Side { gouge, uncut, missing_stock };

/// Skins of material, and slits in it, thinner than a nanometre do not count as either: passes that
/// meet face to face leave no film between them, and a block flush with S is not missing there.
inline constexpr double kSkin_mm = 1e-6;
/// By how much a run looks past such a skin or slit.
inline constexpr double kStepOver_mm = 4 * kSkin_mm;

/// What lies this near beside a normal, behind a face that runs along it, counts as met by it: a
/// wall cut flush with an edge of S, or half a micrometre off, is no gouge as deep as the wall is
/// high, nor is a film of that width beside an upright wall a leftover of its height. Fins and
/// holes from a micrometre on are seen. Half of the last digit of programs in micrometres.
inline constexpr double kBeside_mm = 5e-4;
/// Depths at which what stands by so much beside a normal, in whatever direction, counts as met by
/// it: a sharp edge of the material ends the runs beside it, and the side of a block those at the
/// rim of S. The second is for edges and sides that lean by no more than 11 degrees.
inline constexpr std::array<double, 2> kWedge_mm = {8e-4, 1e-4};
/// Sine of the angle up to which a face is taken to run along a normal.
inline constexpr double kAlong = 0.1;

/// A run along a ray, as far as it was proven: every point of it is what the run says.
struct TracedRun {
  double length_mm = 0;
  std::optional<BodyRef>
      body;  ///< of material: what ends it; of removed space: what reaches furthest
  bool meets_surface = false;  ///< ended by a crossing of S
};

/// Follows rays through what was removed and through what stands (definition 2). A run through
/// material goes on by the least of the zeros of the supporting planes of all bodies near enough,
/// each of which lies below its body's distance; one through removed space from body to body, which
/// overlap on the ray. Both end at the next crossing of S.
class RunTracer {
 public:
  RunTracer(const SurfaceCells& cells, const RemovedSpace& space) : cells_(cells), space_(space) {}

  /// From s + a·n outwards through material; none, where none stands there, has length 0. Runs no
  /// longer than `least_mm` are not held against crossings of S: they may be shorter.
  TracedRun material(const model::Vec3& s, const model::Vec3& n, double allowance_mm,
                     double limit_mm, double least_mm = 0) const;
  /// From s + a·n inwards through what does not stand, to the last place that a body swept; where
  /// `stock_counts`, to the last that lies outside the raw stock.
  TracedRun removed(const model::Vec3& s, const model::Vec3& n, double allowance_mm,
                    double limit_mm, double least_mm = 0, bool stock_counts = false) const;
  /// How far from p along a unit vector nothing stands, whatever is to blame; no more than the
  /// limit.
  double free_length_mm(const model::Vec3& p, const model::Vec3& along, double limit_mm) const;

 private:
  double free_beside(const Nearest& at, const model::Vec3& p, const model::Vec3& along, double t,
                     double limit_mm) const;
  bool is_wedge(const model::Vec3& p, const model::Vec3& along) const;
  double exit_of(BodyRef body, const model::Vec3& p, const model::Vec3& along, double t,
                 double limit_mm) const;
  template <class Visit>
  double walk_removed(const model::Vec3& p, const model::Vec3& along, double limit_mm,
                      Visit&& visit) const;
  template <class Visit>
  void visit_swept(const model::Vec3& p, const model::Vec3& along, double from, double to,
                   Visit&& visit) const;

  const SurfaceCells& cells_;
  const RemovedSpace& space_;
};

}  // namespace limitgauge::verifier
