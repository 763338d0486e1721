#pragma once

#include <array>

#include "model/mesh/mesh_soup.h"
#include "simulator/grid/lattice.h"

namespace limitgauge::simulator {

/// Adds the surface on which a field is zero within one cell of the lattice, the field being linear
/// in each of the six tetrahedra about the cell's main diagonal: the surface that bounds what
/// negative_share() (tetra_volume.h) measures. Corner k of the cell is at `low` + (k>>2 & 1,
/// k>>1 & 1, k & 1); negative or zero is inside (faces of a block lie on
/// lattice points, where the field is zero on all corners of a tetrahedron along an edge). Cells
/// side by side give the same points bit by bit, so that the surface of a whole lattice is closed
/// once equal points are joined.
void add_zero_surface(const std::array<double, 8>& corner_values, const Index3& low,
                      const Lattice& lattice, model::TriangleSoup& soup);

}  // namespace limitgauge::simulator
