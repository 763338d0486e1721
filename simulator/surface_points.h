#pragma once

#include <vector>

#include "simulator/material.h"
#include "simulator/stock_grid.h"

namespace limitgauge::simulator {

/// Moves `start` onto the zero set of the exact material by Newton steps; where two or three makers
/// meet in an edge, onto the edge. The residual is the |φ| that is left. `hint` is where to look
/// first, and becomes the maker found; it only saves time.
StockPoint project_to_surface(const Material& material, const model::Vec3& start, double voxel_mm,
                              SurfaceMaker& hint);

/// One projected point for each surface voxel of the grid whose centre lies in `region`, in its
/// order.
std::vector<StockPoint> project_surface(const Material& material, const StockGrid& grid,
                                        const model::Box3& region,
                                        const model::RunControl& control);

}  // namespace limitgauge::simulator
