#pragma once

#include <memory>
#include <optional>

#include "verifier/cells/cell_bounds.h"
#include "verifier/certificate/run_tracer.h"

namespace limitgauge::verifier {

/// The tips' way off their path that counts most at a witness with that normal: against it for
/// gouges, along it for what is left.
inline model::Vec3 off_path(Side side, const model::Vec3& normal, double path_mm) {
  return normal * (side == Side::uncut ? path_mm : -path_mm);
}

/// Where witnesses are looked for of a space that sways: the space at one corner of what is not
/// known besides, the rectangle of shifts of all that was swept, and how far each move may lie off
/// its path.
struct Draws {
  const RemovedSpace& space;
  model::Vec3 middle_mm, half_mm;  ///< of the shifts; half widths in plan
  double path_mm = 0;
  /// By how much what is proven of errors that each move has for itself exceeds what one shift of
  /// all moves shows: no interval is narrower.
  double gap_mm = 0;
  double stock_mm = 0;  ///< how much further the raw stock may stand out than here

  /// What errors that each move has for itself, or the raw stock, take from every bound, about.
  double own_errors_mm() const { return path_mm + gap_mm + stock_mm; }
  /// The middle of the shifts moved by a share of their half widths, −1 to 1 along each axis.
  model::Vec3 shift(double x, double y) const {
    return middle_mm + model::Vec3{x * half_mm.x, y * half_mm.y, 0};
  }
};

/// Proofs that no run of one kind, on any point of a cell, is longer than a length, and runs at
/// single points (CERTIFICATE.md, sections 3 and 3b). `allowance_mm` is 0 for missing stock.
class RunBounds {
 public:
  /// Runs at single points are those in `draws` where it is given, the longest over the corners and
  /// the middle of its shifts. `far` is what other searches of the same space, thread and
  /// neighbourhood have kept.
  RunBounds(const SurfaceCells& cells, const RemovedSpace& space, Side side, double allowance_mm,
            const Draws* draws = nullptr, std::shared_ptr<FarPasses> far = nullptr);

  /// Longer than any run can be: no gate allows it.
  double longest_mm() const { return longest_mm_; }
  /// Whether the middle's run is no longer, by one query; of a space that sways but for its bend.
  bool ends_within(const OffsetCell& cell, double length_mm);
  /// Proof that no run of the cell is longer than `length_mm`. False means "not proven".
  bool surely_within(const OffsetCell& cell, double length_mm);
  /// The same at a place along the middle's normal that its run points to, for a cell whose
  /// middle's run ends before `length_mm`: where what is removed is thin, or beside it.
  bool surely_within_thin(const OffsetCell& cell, const TracedRun& run, double length_mm);
  /// The run at a point of S with one of its normals, as far as it is proven; `least_mm` as in
  /// RunTracer. None for a normal of no length, in the middle of normals that cancel.
  TracedRun run(const model::Vec3& s, const model::Vec3& n, double least_mm = 0);
  /// The same at one shift of the draws.
  TracedRun run_shifted(const model::Vec3& s, const model::Vec3& n, double x, double y,
                        double least_mm) const;
  /// A lower bound of that run by one query.
  double quick_run(const model::Vec3& s, const model::Vec3& n, std::optional<BodyRef>& hint);
  /// The body nearest to s.
  BodyRef nearest_body(const model::Vec3& s) { return space_.nearest(s, {}, far_.get()).body; }
  Nearest nearest(const model::Vec3& p, std::optional<BodyRef> hint = {}) {
    return space_.nearest(p, hint, far_.get());
  }
  /// How δ changes at the middle of the cell, moved to where its runs would end.
  model::Vec3 gradient_at(const OffsetCell& cell, double length_mm);

 private:
  TracedRun run_in(const RunTracer& tracer, const model::Vec3& s, const model::Vec3& n,
                   double least_mm) const;
  TracedRun drawn_run(const model::Vec3& s, const model::Vec3& n, double least_mm) const;
  double margin_mm(const OffsetCell& cell, double t_mm) const;
  bool is_beside(const OffsetCell& cell, const Nearest& at) const;
  bool is_wedge_beside(const OffsetCell& cell, double length_mm);
  bool is_round(BodyRef body) const;
  double gain_beside_mm(const OffsetCell& cell, const Nearest& at, double radius_mm) const;
  bool stands_beside(const OffsetCell& cell, double t_mm, double along);
  bool is_deep(const Bezier& cell, BodyRef body) const;
  Nearest lowest_corner(const Bezier& cell, BodyRef hint);
  bool surely_crosses(const OffsetCell& cell, double length_mm) const;
  bool is_gone(const OffsetCell& cell, double t_mm);
  bool is_gone(const OffsetCell& cell, double t_mm, const Nearest& at);
  bool is_gone_deepest(const OffsetCell& cell, BodyRef body, double from_t_mm, double to_t_mm);
  bool stands(const OffsetCell& cell, double t_mm);
  bool surely_unswept(const OffsetCell& cell, double length_mm);
  const Nearest& look(const model::Vec3& p);

  const SurfaceCells& cells_;
  const RemovedSpace& space_;
  const Draws* draws_;
  std::shared_ptr<FarPasses> far_;  ///< of this search's own thread
  RunTracer tracer_;
  CellBounder bounder_;
  Side side_;
  double allowance_mm_, longest_mm_;
  std::optional<std::pair<model::Vec3, Nearest>> looked_;
};

}  // namespace limitgauge::verifier
