#pragma once

#include <cstddef>

#include "reports/probe/probe_result.h"

namespace limitgauge::reports {

/// Points on three faces in turn, which face X, Y and Z, shifted by 3, −4 and 0 µm, each with an
/// uncertainty of 0.3 µm and as much scatter; every eleventh lies on the raw stock.
probe::ProbeResult sample_probe(std::size_t points);
/// Points of a floor alone, 2 µm too high, without uncertainty.
probe::ProbeResult floor_probe(std::size_t points);
/// Points of a wall that faces between X and Y.
probe::ProbeResult slanted_probe(std::size_t points);
/// Markup in every text, and a point of which nothing was proven to stand nearby.
probe::ProbeResult hostile_probe();

}  // namespace limitgauge::reports
