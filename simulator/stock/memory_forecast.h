#pragma once

#include <cstddef>
#include <vector>

#include "model/base/run_control.h"
#include "simulator/grid/index_box.h"
#include "simulator/stock/material.h"

namespace limitgauge::simulator {

/// What a level set would take, from a fixed sample of its blocks built and cut.
struct GridForecast {
  std::vector<Index3> blocks;  ///< those that the surface may pass through, in a fixed order
  double bytes = 0;            ///< of the grid
  double bytes_a_block = 0;
  double cut_seconds = 0;  ///< for the last pass, on the control's threads
  double all_seconds = 0;  ///< for the raw stock and all passes
};

/// Figures of the grid of `material` on `lattice`, before it is built. The memory is the same for
/// any number of threads; the time is measured.
GridForecast forecast_grid(const Material& material, const Lattice& lattice,
                           const model::RunControl& control);

/// Bytes of the passes' moves and their trees.
double pass_bytes(const Material& material);

/// Rounded up to two digits: a figure one can type.
double two_digits_up(double x);

}  // namespace limitgauge::simulator
