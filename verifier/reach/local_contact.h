#pragma once

#include <memory>
#include <variant>

#include "verifier/cells/cell_halves.h"
#include "verifier/cells/derivative_hull.h"
#include "verifier/cells/patch_charts.h"
#include "verifier/reach/cell_contact.h"
#include "verifier/reach/graph_region.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

/// The part of S round a cell that a cutter touching the cell is proven not to cut into, as a
/// rectangle of the chart of the cell's patch.
struct ClearedRect {
  int patch = 0;
  ParameterRect rect;
};

/// The same as what lies near enough to the middle of the contact, among cells that S goes on in.
struct ClearedDisc {
  std::vector<std::uint32_t> cells;  ///< sorted
  model::Vec3 centre;
  double radius_mm = 0;

  /// Whether a part of cell `whole` does, with all its control points round its middle.
  bool holds(std::uint32_t whole, const model::Vec3& middle, double part_radius_mm) const;
};
using Cleared = std::variant<ClearedRect, std::shared_ptr<const ClearedDisc>>;

/// Proof by curvature that a cutter which touches a cell does not cut into S close by, where the
/// distance itself tends to zero and no bound on it can help: between S and the cutter's section
/// along and across its meridian (CERTIFICATE.md, section 4).
class LocalContact {
 public:
  /// Of cells that outlive this.
  LocalContact(const std::vector<SurfaceCell>& cells, double allowance_mm, double contact_mm);
  LocalContact(const LocalContact&) = delete;
  LocalContact& operator=(const LocalContact&) = delete;

  /// The largest of a few rectangles, or else discs, for which the proof goes through, if any.
  /// `cell` is a part of cell `whole`.
  std::optional<Cleared> clear(const SurfaceCell& cell, const CellContact& contact,
                               std::uint32_t whole) const;
  /// Of all cells, by index.
  const std::vector<model::Vec3>& middles() const { return regions_.middles(); }
  /// Whether all of a part of cell `whole` lies in `cleared`.
  bool holds(const Cleared& cleared, std::uint32_t whole, const CellHalves::Part& part) const;

 private:
  struct Spans;
  struct Frame;

  std::optional<ClearedRect> clear_rect(const SurfaceCell& cell, const CellContact& contact) const;
  /// What may be cut into so far away, less what the turn of a normal on a wall takes.
  double slack_mm(double far_mm) const { return contact_mm_ - kContactTurn_rad * far_mm; }
  std::shared_ptr<const ClearedDisc> clear_disc(const CellContact& contact,
                                                std::uint32_t whole) const;
  ParameterRect clipped(int patch, const ParameterRect& own, ParameterRect wanted) const;
  void add_spans(Spans& spans, int patch, const ParameterRect& rect,
                 const std::optional<ParameterRect>& inner, const Frame& frame) const;
  bool proven(const ParameterRect& area, const ParameterRect& own, const CellContact& contact,
              const Frame& frame, const Spans& spans) const;

  ParameterIndex index_;
  PatchCharts charts_;
  GraphRegions regions_;
  std::vector<DerivativeHull> hulls_;
  double allowance_mm_, contact_mm_;
};

}  // namespace limitgauge::verifier
