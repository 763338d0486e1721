#pragma once

#include <functional>
#include <span>
#include <vector>

#include "simulator/grid/stock_grid.h"
#include "simulator/process/near_material.h"
#include "simulator/stock/material.h"
#include "simulator/stock/stock_point.h"

namespace limitgauge::simulator {

/// Moves `start` onto the zero set of the exact material by Newton steps; where two or three makers
/// meet in an edge, onto the edge. The residual is the |φ| that is left. `hint` is where to look
/// first, and becomes the maker found; it only saves time.
StockPoint project_to_surface(const Material& material, const model::Vec3& start, double voxel_mm,
                              SurfaceMaker& hint);
StockPoint project_to_surface(const NearMaterial& material, const model::Vec3& start,
                              double voxel_mm, SurfaceMaker& hint);

/// The shortest step that brings the linearised values of one, two or three samples to zero; of the
/// first alone where their gradients are too nearly parallel to say more.
model::Vec3 step_onto(std::span<const MaterialSample> samples);

using PointVisitor = std::function<void(std::span<const StockPoint>)>;

/// Gives `visit` one projected point for each surface voxel of the grid's box whose centre lies in
/// `region`, in the order of GridLeaves, some at a time.
void visit_points(const Material& material, const StockGrid& grid, const model::Box3& region,
                  const PointVisitor& visit, const model::RunControl& control);

}  // namespace limitgauge::simulator
