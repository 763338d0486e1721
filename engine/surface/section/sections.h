#pragma once

#include <span>
#include <vector>

#include "engine/surface/offset_model.h"
#include "engine/surface/patch_model.h"
#include "engine/surface/section/grid_section.h"
#include "engine/surface/section/section_merge.h"
#include "model/base/run_control.h"

namespace limitgauge::engine::surface {

/// Quadtrees over the patches of a sampled model along one axis: built once for any number of
/// planes.
std::vector<GridSection> section_trees(const OffsetModel& sampled, int axis,
                                       const model::RunControl& control);

/// The sections of a sampled model by the planes perpendicular to `axis` at `values` (ascending,
/// mm): paper section 5, one pass over each patch for the whole family, planes in parallel. Curves
/// of the patches are joined across edges, where they meet to 1e-12 of the model's size; they end
/// at open boundaries and borders of holes only, and across creases of a non-zero offset, where
/// the surface itself is open. Finer pieces over corners (OffsetModel::corners) are left out.
std::vector<std::vector<SectionCurve>> sections(const PatchModel& model, const OffsetModel& sampled,
                                                int axis, std::span<const double> values,
                                                const model::RunControl& control);
/// The same with trees of `sampled` that stand already.
std::vector<std::vector<SectionCurve>> sections(const PatchModel& model, const OffsetModel& sampled,
                                                std::span<const GridSection> trees,
                                                std::span<const double> values,
                                                const model::RunControl& control);
/// The section by one plane.
std::vector<SectionCurve> section(const PatchModel& model, const OffsetModel& sampled,
                                  const AxisPlane& plane);

}  // namespace limitgauge::engine::surface
