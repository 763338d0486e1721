#pragma once

#include "engine/model/cage.h"

namespace limitgauge::tests {

/// One uniform Catmull-Clark step of a whole smooth cage, open or closed, written from the masks
/// and sharing nothing with the libraries. Child faces stand in the order of the corners of the
/// faces, each beginning with the corner that it keeps. Corners of one face stay put under
/// edge_and_corner.
model::Cage refine_uniformly(const model::Cage& cage);

/// The limit positions of all vertices by the limit masks (interior and boundary).
std::vector<model::Vec3> limit_positions(const model::Cage& cage);

}  // namespace limitgauge::tests
