#pragma once

#include <array>
#include <vector>

#include "verifier/cell_bounds.h"

namespace limitgauge::verifier {

/// How deep S lies in all that was removed. δ, the least of the bodies' signed distances, is the
/// depth into one of them; their union can be deeper, as where two bodies end in one another. The
/// distance from a point s to anything left standing is above its depth:
///   δ(s + t·v) ≥ 0 for some unit vector v  ⇒  depth(s) ≤ t,
/// and depth changes by no more than the way gone. For a cell of S, the supporting planes of
/// CellBounder on the cell moved by t·v show δ ≥ 0 for all of its points at once.
class UnionDepth {
 public:
  /// Ways longer than `longest_mm` are not tried.
  UnionDepth(const RemovedSpace& space, double longest_mm)
      : space_(space), bounder_(space), longest_mm_(longest_mm) {}

  /// Proof that every point of the cell lies no deeper than `depth_mm`, for what `bounds` tells of
  /// its middle. False means "not proven".
  bool surely_within(const Bezier& cell, const CellBounds& bounds, double depth_mm);
  /// The same by ways along one unit vector.
  bool surely_within(const Bezier& cell, const model::Vec3& direction, double depth_mm);

  /// A way out of all that was removed.
  struct Exit {
    model::Vec3 direction;
    double length_mm = 0;
  };
  /// A short one from the middle of the cell: its depth is no more. Ends with the first that is no
  /// longer than `enough_mm`; where none is found it has the longest length tried.
  Exit exit(const Bezier& cell, const CellBounds& bounds, double enough_mm);

 private:
  std::array<model::Vec3, 3> likely_directions(const Bezier& cell, const CellBounds& bounds) const;
  /// The way out along `direction`; `shorter_than` where it is not shorter.
  double way_out(const model::Vec3& p, const model::Vec3& direction, double shorter_than) const;

  const RemovedSpace& space_;
  CellBounder bounder_;
  double longest_mm_ = 0;
};

}  // namespace limitgauge::verifier
