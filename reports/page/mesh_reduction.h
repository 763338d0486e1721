#pragma once

#include <cstddef>

#include "model/base/run_control.h"
#include "model/mesh/triangle_mesh.h"

namespace limitgauge::reports::page {

/// `mesh` with fewer triangles, for a picture: vertices are drawn into their neighbours where the
/// planes of all triangles that they stood for stay near, flat parts first, until at most
/// `most_triangles` are left; flat parts are thinned out in any case. Every vertex that is left is
/// one of `mesh`. A mesh of far more triangles is first gathered cell by cell. Promises no distance
/// to `mesh`: that is to be measured. The same mesh gives the same picture. Throws Interrupted.
model::TriangleMesh reduced(const model::TriangleMesh& mesh, std::size_t most_triangles,
                            const model::RunControl& control = {});

}  // namespace limitgauge::reports::page
