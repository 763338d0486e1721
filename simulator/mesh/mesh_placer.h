#pragma once

#include <atomic>

#include "simulator/mesh/surface_net.h"
#include "simulator/stock/material.h"

namespace limitgauge::simulator {

/// Puts a net's vertices onto the exact material: into the corner or onto the edge in which the
/// surfaces at a cell's crossings meet, where that lies in the cell, otherwise onto the nearest of
/// them. A vertex for which no place is found within a voxel stays in the middle of its crossings
/// and is counted in `unmoved`.
MakePlacer exact_placers(const Material& material, const Lattice& lattice,
                         std::atomic<std::size_t>& unmoved);

/// Leaves them in the middle of their crossings.
MakePlacer middle_placers();

}  // namespace limitgauge::simulator
