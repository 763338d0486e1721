#pragma once

#include <vector>

#include "engine/surface/patch_model.h"
#include "engine/surface/section/section_chain.h"

namespace limitgauge::engine::surface {

/// The patches of a model as sampled for one stage: multi-resolution sampling (equation 10) takes
/// each patch at the least depth that keeps `error_mm`, moved out along its normals by `offset_mm`
/// (equation 6; zero gives the limit mesh). Where neighbours differ in depth the finer one follows
/// the coarser one's edge, so that smooth edges have no cracks.
struct OffsetModel {
  std::vector<Grid> grids;  ///< one a patch
  std::vector<int> depths;  ///< one a patch
  /// Finer pieces over the extraordinary corners of the grids.
  std::vector<Grid> corners;
  std::vector<int> intervals;  ///< one a patch; equation 10: 2^(depth of the model - sampled depth)
  double offset_mm = 0;
  double excess_mm = 0;  ///< by how much the worst patch's bound exceeds the error asked for
};
OffsetModel sample_offset(const PatchModel& model, double offset_mm, double error_mm);
/// Grids and corners together: what a cutter must keep clear of.
std::vector<Grid> pieces(const OffsetModel& sampled);

}  // namespace limitgauge::engine::surface
