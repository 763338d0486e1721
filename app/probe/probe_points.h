#pragma once

#include <functional>
#include <string>

#include "app/probe/result_stock.h"
#include "model/part/measured_points.h"

namespace limitgauge::app {

/// How the work is watched; `phase` is told of what begins.
struct ProbeWatch {
  model::RunControl control;
  std::function<void(const std::string& what)> phase;
};

/// Residuals, the zero shift and what made the surface nearest to each point, into a result that
/// has no name of files yet. The same for any number of threads. Throws Interrupted.
reports::probe::ProbeResult probe_points(const ResultStock& stock,
                                         const model::MeasuredPoints& measured,
                                         const ProbeWatch& watch);

}  // namespace limitgauge::app
