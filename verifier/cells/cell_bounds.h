#pragma once

#include <array>
#include <memory>
#include <vector>

#include "verifier/cutter/removed_space.h"

namespace limitgauge::verifier {

/// What is known of δ on one cell.
struct CellBounds {
  model::Vec3 middle;  ///< a point of the surface
  Nearest nearest;     ///< δ there
  double lower = 0, upper = 0;
};

/// Values at the control points of a cell; of a space that sways, at each of them once for every
/// corner of its sway.
struct CellValues {
  std::array<double, 64> at;  ///< the first `count` of them
  std::size_t count = 0;

  double* begin() { return at.data(); }
  double* end() { return at.data() + count; }
  const double* begin() const { return at.data(); }
  const double* end() const { return at.data() + count; }
};

/// Bounds of δ = min over i of d_i on a Bézier cell with control points P_k and middle m, for every
/// shift of what was swept that the space may sway by, and for bodies that are each grown or shrunk
/// by as much as their error.
/// Formulas and proofs: CERTIFICATE.md, sections 3 and 10. A body whose term exceeds the upper
/// bound is nearest nowhere in the cell and is dropped, for this cell and all its parts. The
/// outside of a mesh has bounds of its own (MeshOutside).
class CellBounder {
 public:
  /// What is learnt of far passes may be shared with other searches of the same thread.
  explicit CellBounder(const RemovedSpace& space, std::shared_ptr<FarPasses> far = nullptr);

  /// The bodies that can be nearest somewhere in `cell`, and no further than `limit_mm` there,
  /// found through the tree; `hint` as in RemovedSpace::nearest. None only where there are none so
  /// near. Of a space that does not sway.
  void find_candidates(const Bezier& cell, std::vector<BodyRef>& candidates,
                       std::optional<BodyRef> hint = {},
                       double limit_mm = std::numeric_limits<double>::infinity());
  /// `candidates` must hold every body that can be nearest somewhere in the cell; those that cannot
  /// are removed. The upper bound is not improved any further once it is below `low_enough`, nor
  /// the lower bound once it is above `high_enough`. Of a space that does not sway.
  CellBounds bound(const Bezier& cell, std::vector<BodyRef>& candidates, double low_enough,
                   double high_enough = -std::numeric_limits<double>::infinity());
  /// Proof that δ ≥ `margin_mm` on all of the cell. False means "not proven". `first`, the
  /// likeliest to be in the way, is looked at before the others.
  bool surely_outside(const Bezier& cell, double margin_mm, std::optional<BodyRef> first = {});
  /// By how much the body in the way of the last such proof misses the margin, where it is smooth
  /// over the cell: a cell moved by clearly less stays unproven. Nothing of one with a sharp edge.
  double missed_by_mm() const { return missed_by_mm_; }
  /// That body, of a proof that failed.
  BodyRef in_the_way() const { return in_the_way_; }
  /// Proof that what swept comes no nearer than `margin_mm`, and `margin_per_mm` more for each mm
  /// along it, to what lies between the cell and the cell moved by `prism`. Raw stock does not
  /// count.
  bool surely_unswept(const Bezier& cell, const model::Vec3& prism, double margin_mm,
                      double margin_per_mm);
  /// Proof that δ ≤ −`margin_mm` on all of the cell, by `first`, a body that is low at its middle,
  /// or by means of those nearly as low.
  bool surely_inside(const Bezier& cell, double margin_mm, BodyRef first);

 private:
  struct Scored {
    BodyRef body;
    double value = 0, lower = 0, upper = 0;
  };

  Scored score(const Bezier& cell, const model::Vec3& middle, BodyRef body, BodyDistance& distance,
               double enough_mm = std::numeric_limits<double>::infinity()) const;
  bool piece_unswept(const Bezier& cell, const model::Vec3& prism, double margin_mm);
  bool turning_unswept(const Bezier& cell, const model::Vec3& prism, double margin_mm,
                       BodyRef body) const;
  CellValues values_of(const Bezier& cell, BodyRef body) const;
  CellValues shrunk_values_of(const Bezier& cell, BodyRef body) const;
  double lowered(BodyRef body, double lower, const model::Vec3& gradient) const;
  double corner_lower(const Bezier& cell, const model::Vec3& middle, BodyRef body,
                      const model::Vec3& gradient) const;
  double upper_of(const Bezier& cell, const model::Vec3& middle, BodyRef body);
  double improve_upper(const Bezier& cell, double upper, double low_enough);
  double mixed_lower(const Bezier& cell, const model::Vec3& middle, BodyRef body) const;
  /// Whether that improves the lower bound: a sharp edge in a cell of that size.
  bool sharp(BodyRef body, double radius_mm) const;

  const RemovedSpace& space_;
  std::shared_ptr<FarPasses> far_;
  /// By which what was swept may be shifted, most of all: the corners of the sway, one where there
  /// is none; how far they lie from its middle.
  std::vector<model::Vec3> corners_;
  double sway_mm_ = 0;
  double missed_by_mm_ = 0;
  BodyRef in_the_way_;
  std::vector<BodyRef> near_;
  std::vector<Scored> scored_;
  std::vector<CellValues> values_;
};

}  // namespace limitgauge::verifier
