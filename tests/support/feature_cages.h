#pragma once

#include <vector>

#include "model/part/cage.h"

namespace limitgauge::tests {

/// The star of `valence` faces (see star_cage) with sharpness on some of the edges at its centre,
/// by number, and on the centre itself.
model::Cage sharp_star(int valence, double edge_sharpness, const std::vector<int>& edges,
                       double vertex_sharpness = 0);
/// `faces` quads side by side around a vertex (number 0) on the boundary, in a half turn.
model::Cage boundary_fan(int faces, model::BoundaryRule rule);
/// A closed prism over a polygon of `sides`, its vertices moved a little off symmetry.
model::Cage prism(int sides);

/// Small cages that between them hold every rule and every kind of vertex; `name` says which.
std::vector<model::Cage> feature_cages();

}  // namespace limitgauge::tests
