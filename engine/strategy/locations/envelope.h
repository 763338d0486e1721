#pragma once

#include <span>
#include <vector>

namespace limitgauge::engine::strategy {

/// A point of a drive plane: distance along it and height, mm.
struct PlanePoint {
  double s = 0, z = 0;
  friend bool operator==(const PlanePoint&, const PlanePoint&) = default;
};

/// The upper envelope of curves in a drive plane (design: it is the gouge-free path of the cutter's
/// centre): runs of ascending s, each a polyline; steps between curves are vertical pieces.
/// Between runs there is nothing.
struct Envelope {
  std::vector<std::vector<PlanePoint>> runs;
};

/// The envelope of polylines, which may turn back and cross each other and themselves. Exact but
/// for stretches of up to `slit_mm`, which are bridged: rounding opens slits between curves that
/// meet. Time grows with the points times the curves over one place.
Envelope upper_envelope(std::span<const std::vector<PlanePoint>> curves, double slit_mm);

}  // namespace limitgauge::engine::strategy
