#pragma once

#include <array>

#include "model/mesh/mesh_soup.h"
#include "simulator/grid/lattice.h"

namespace limitgauge::simulator {

// A field within one cell of a lattice, linear in each of the six tetrahedra about the cell's main
// diagonal. Corner k of the cell is at (k>>2 & 1, k>>1 & 1, k & 1) from its lowest one.

/// Share of a unit cube where the field is negative. Exact for a linear field, of second order in
/// the cube's edge for a smooth one.
double negative_share(const std::array<double, 8>& corner_values);

/// Adds the surface on which the field is zero: that which bounds what negative_share() measures.
/// The cell is that at `low`; negative or zero is inside (faces of a block lie on lattice points,
/// where the field is zero on all corners of a tetrahedron along an edge). Cells side by side give
/// the same points bit by bit, so that the surface of a whole lattice is closed once equal points
/// are joined.
void add_zero_surface(const std::array<double, 8>& corner_values, const Index3& low,
                      const Lattice& lattice, model::TriangleSoup& soup);

}  // namespace limitgauge::simulator
