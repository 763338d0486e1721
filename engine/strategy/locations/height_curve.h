#pragma once

#include <vector>

#include "engine/strategy/levels/waterline.h"
#include "engine/strategy/locations/cutter_locations.h"
#include "engine/strategy/raster/isoline.h"
#include "engine/strategy/raster/tip_raster.h"

namespace limitgauge::engine::strategy {

/// The curves on which the tip height passes `height_mm`: what is higher is forbidden. Points lie
/// on the free side, within `tolerance_mm / 100` of the curve; the forbidden side is on the right.
class HeightCurves {
 public:
  HeightCurves(const CutterLocations& locations, const TipRaster& tips, double height_mm,
               double tolerance_mm)
      : locations_(locations), tips_(tips), height_(height_mm), tolerance_(tolerance_mm) {}

  /// Passes of the tip beside the curves: proven clear, within the tolerance of them, no denser
  /// than that asks for. A curve whose chords cannot be proven clear is left open there.
  std::vector<Waterline> passes() const;

 private:
  /// Tip height at a place less that of the curve; minus infinity where nothing is under the
  /// cutter.
  double above(const FlatPoint& p) const;
  bool held_at(const FlatPoint& p) const { return above(p) > 0; }
  /// The curve between a free and a forbidden place, from the free side.
  FlatPoint crossing(FlatPoint free, FlatPoint held) const;
  FlatPoint exact(const FlatPoint& edge_middle) const;
  std::vector<FlatPoint> exact_points(const Isoline& line) const;
  std::vector<FlatPoint> densified(const std::vector<FlatPoint>& points) const;
  void densify(const FlatPoint& a, const FlatPoint& b, std::vector<FlatPoint>& dense) const;
  bool find_beside(const FlatPoint& a, const FlatPoint& b, FlatPoint& found) const;
  std::vector<FlatPoint> pushed(const std::vector<FlatPoint>& curve, bool closed) const;
  void add_passes(const std::vector<FlatPoint>& curve, bool closed,
                  std::vector<Waterline>& made) const;

  const CutterLocations& locations_;
  const TipRaster& tips_;
  double height_, tolerance_;
};

}  // namespace limitgauge::engine::strategy
