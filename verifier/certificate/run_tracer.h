#pragma once

#include <array>
#include <memory>
#include <optional>

#include "verifier/cells/surface_cells.h"
#include "verifier/cutter/removed_space.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

/// What is looked for along the normals of S.
enum class Side { gouge, uncut, missing_stock };

/// A run along a ray, as far as it was proven: every point of it is what the run says.
struct TracedRun {
  double length_mm = 0;
  std::optional<BodyRef>
      body;  ///< of material: what ends it; of removed space: what reaches furthest
  bool meets_surface = false;       ///< ended by a crossing of S
  double shift_x = 0, shift_y = 0;  ///< of a space that sways: share of its draws' shift
};

/// Follows rays through what was removed and through what stands (definition 2). A run through
/// material goes on by the least of the zeros of the supporting planes of all bodies near enough,
/// each of which lies below its body's distance; one through removed space from body to body, which
/// overlap on the ray. Both end at the next crossing of S.
class RunTracer {
 public:
  /// What is learnt of far passes is shared with other searches of the same thread.
  RunTracer(const SurfaceCells& cells, const RemovedSpace& space, std::shared_ptr<FarPasses> far)
      : cells_(cells), space_(space), far_(std::move(far)) {}

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
  bool stands_up_to(double limit_mm, const model::Vec3& from, const model::Vec3& n,
                    TracedRun& run) const;
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
  std::shared_ptr<FarPasses> far_;
};

}  // namespace limitgauge::verifier
