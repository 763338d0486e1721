#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

#include "model/base/run_control.h"
#include "verifier/cells/cell_bounds.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/certificate/run_bounds.h"
#include "verifier/gate/deviation.h"
#include "verifier/reach/reach_query.h"

namespace limitgauge::verifier {

/// What is asked of a certificate.
struct CertificateRequest {
  double allowance_mm = 0;
  /// Limits of the gate: a figure proven to be beyond its limit is not narrowed down further than
  /// to a twentieth of itself, for its verdict is settled.
  double gouge_limit_mm = std::numeric_limits<double>::infinity();
  double uncut_limit_mm = std::numeric_limits<double>::infinity();
  /// Widest interval wanted. Where a limit lies within an interval of that width, it is narrowed
  /// further, down to a hundredth of it, until the verdict is settled.
  double resolution_mm = 0;
  std::size_t largest_cell_count = 0;  ///< where refinement ends all the same
  /// Only whether the figure is within its limit is wanted: `low` is 0 but for a run beyond the
  /// limit, and `high` is no more than the limit or infinite. No width is looked for.
  bool decides_only = false;
};

/// A point of S that shows that an interval's low end is truly reached.
struct Witness {
  SurfacePlace place;
  double depth_mm = 0;
  BodyRef body;  ///< that a gouge was swept by, or that is nearest to a leftover's place
  model::Vec3 normal;
  double shift_x = 0, shift_y = 0;  ///< of a space that sways: share of its draws' shift
};

/// What the search of one cell, or of many, has found.
struct CellOutcome {
  double low = 0, high = 0;  ///< a run that is reached; what none exceeds, mm
  std::optional<Witness> witness;
  std::size_t cells = 0;

  void see(const Witness& found) {
    if (found.depth_mm > low) low = found.depth_mm, witness = found;
  }
  void cover(double bound_mm) { high = std::max(high, bound_mm); }
  void merge(const CellOutcome& other) {
    if (other.low > low) low = other.low, witness = other.witness;
    high = std::max(high, other.high);
    cells += other.cells;
  }
};

/// What one figure is certified of.
struct CertificateTask {
  const SurfaceCells& cells;
  const RemovedSpace& space;
  Side side;
  const ReachQuery* reach;
  const CertificateRequest& request;
  double errors_mm = 0;
  const Draws* draws = nullptr;  ///< of a space that sways

  double limit_mm() const {
    return side == Side::uncut ? request.uncut_limit_mm : request.gouge_limit_mm;
  }
  bool settled(double low_mm) const { return low_mm > limit_mm() + errors_mm; }
  /// What is proven to stay within this is within the limit, for a search that only decides.
  double deciding_mm() const { return std::max(0.0, limit_mm() - errors_mm); }
  /// Up to where a bound need not be improved, by what is known to be reached.
  double goal(double low_mm) const;
  /// Of a place whose normal is `n`, on the cell or on a sharp edge.
  bool counts(const SurfaceCell&, const SurfacePlace& place, const model::Vec3& n) const {
    return side != Side::uncut || reach->can_be_touched(place, n);
  }
  bool counts(const RidgeCell&, const SurfacePlace& place, const model::Vec3& n) const {
    return reach->ridge_can_be_touched(place.point, n);
  }
  /// Number of cells: those of S, then sharp edges where their normals count.
  std::size_t size() const {
    return cells.cells().size() + (side == Side::uncut ? cells.ridges().size() : 0);
  }
  template <class See>
  auto with_cell(std::size_t i, See&& see) const {
    const std::size_t faces = cells.cells().size();
    return i < faces ? see(cells.cells()[i]) : see(cells.ridges()[i - faces]);
  }
};

/// A cell of a face and one of a sharp edge answer the same questions.
inline OffsetCell offset_of(const SurfaceCell& cell) {
  return offset_cell(cell.shape, cell.vertex_normal);
}
inline OffsetCell offset_of(const RidgeCell& cell) {
  return cell.offset();
}
inline SurfacePlace place_of(const SurfaceCell& cell, const model::Vec3& point) {
  return middle_place(cell, point);
}
inline SurfacePlace place_of(const RidgeCell& cell, const model::Vec3&) {
  return cell.place();
}
/// Where a cell is looked at first.
struct CellMiddle {
  model::Vec3 point, normal;
};
inline CellMiddle middle_of(const SurfaceCell& cell) {
  return {middle(cell.shape), middle_normal(cell)};
}
inline CellMiddle middle_of(const RidgeCell& cell) {
  const OffsetCell o = cell.offset();
  return {o.middle, o.normal};
}

/// Depth-first refinement of cell `index` of the task, from what the batches `before` it have
/// found. `far` is kept from one neighbouring cell to the next: which bodies that are not near a
/// proof looks at all the same may hang on it, and so how many cells it takes.
CellOutcome search_cell(const CertificateTask& task, std::size_t index, const CellOutcome& before,
                        const model::RunControl& control, const std::shared_ptr<FarPasses>& far);

}  // namespace limitgauge::verifier
