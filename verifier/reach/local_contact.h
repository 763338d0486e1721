#pragma once

#include "verifier/cells/patch_charts.h"
#include "verifier/reach/cell_contact.h"

namespace limitgauge::verifier {

/// The part of S round a cell that a cutter touching the cell is proven not to cut into, as a
/// rectangle of the chart of the cell's patch.
struct ClearedRect {
  int patch = 0;
  ParameterRect rect;
};

/// Proof by curvature that a cutter which touches a cell does not cut into S close by, where the
/// distance itself tends to zero and no bound on it can help: between S and the cutter's section
/// along and across its meridian (CERTIFICATE.md, section 4).
class LocalContact {
 public:
  LocalContact(const std::vector<SurfaceCell>& cells, double allowance_mm, double contact_mm);

  /// The largest of a few rectangles for which the proof goes through, if any.
  std::optional<ClearedRect> clear(const SurfaceCell& cell, const CellContact& contact) const;
  /// Whether all of `cell` lies in `cleared`.
  bool holds(const ClearedRect& cleared, const SurfaceCell& cell) const;

 private:
  /// Boxes of the derivatives over a cell, in mm per unit of its patch's parameters.
  struct DerivativeHull {
    model::Box3 u, v, uu, uv, vv;
  };
  struct Spans;
  struct Frame;

  static DerivativeHull hull_of(const SurfaceCell& cell);
  ParameterRect clipped(int patch, const ParameterRect& own, ParameterRect wanted) const;
  void add_spans(Spans& spans, int patch, const ParameterRect& rect,
                 const std::optional<ParameterRect>& inner, const Frame& frame) const;
  bool proven(const ParameterRect& area, const ParameterRect& own, const CellContact& contact,
              const Frame& frame, const Spans& spans) const;

  ParameterIndex index_;
  PatchCharts charts_;
  std::vector<DerivativeHull> hulls_;
  double allowance_mm_, contact_mm_;
  double usual_radius_mm_ = 0;
};

}  // namespace limitgauge::verifier
