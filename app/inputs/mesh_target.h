#pragma once

#include "app/inputs/run_inputs.h"

namespace limitgauge::app {

/// The design of a job whose design is a mesh: its facets, placed. Throws as load_surface does.
JobSurface load_mesh_target(const Job& job, const model::RunControl& control);

/// Share of triangles among a cage's faces from which it is likely to be a mesh of a shape, taken
/// for a cage: its limit surface would be another, smoother and smaller one.
inline constexpr double kMeshLikeShare = 0.9;
/// What is to be said of a cage that looks like a mesh; empty of one that does not.
std::string mesh_like_warning(const model::CageSummary& cage);

}  // namespace limitgauge::app
