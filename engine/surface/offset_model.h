#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "engine/surface/patch_model.h"
#include "engine/surface/section/section_chain.h"

namespace limitgauge::engine::surface {

/// How the patches of a model are sampled for one stage, and the grid of any one of them when it is
/// asked for: multi-resolution sampling (equation 10) takes each patch at the least depth that
/// keeps `error_mm`, moved out along its normals by an offset (equation 6; zero gives the limit
/// mesh). Where neighbours differ in depth the finer one follows the coarser one's edge, so that
/// smooth edges have no cracks; that takes the neighbours' depths and no grid of theirs.
///
/// Holds a few bytes a patch. A grid is the same to the last bit whenever it is made; queries may
/// run in parallel.
class OffsetSampler {
 public:
  /// `model` must outlive this.
  OffsetSampler(const PatchModel& model, double error_mm);

  const PatchModel& model() const { return *model_; }
  int patches() const { return static_cast<int>(depths().size()); }
  const std::vector<int>& depths() const { return sampling_.depths; }  ///< one a patch
  /// One a patch; equation 10: 2^(depth of the model - sampled depth).
  std::vector<int> intervals() const;
  /// By how much the worst patch's bound exceeds the error asked for.
  double excess_mm(double offset_mm) const;

  Grid grid(int patch, double offset_mm) const;
  std::size_t grid_points(int patch) const;  ///< of grid()
  /// The points of one side of grid(), counter-clockwise.
  std::vector<Vec3> side(int patch, int side, double offset_mm) const;
  /// Finer pieces over the extraordinary corners of the patch's grid.
  int corners(int patch, double offset_mm) const;
  Grid corner(int patch, int corner, double offset_mm) const;
  std::size_t corner_points(int patch, int corner) const;  ///< of corner()

 private:
  const PatchModel* model_;
  double error_mm_;
  Sampling sampling_;
};

/// Grids and then corners, one by one: what a cutter must keep clear of.
void for_each_piece(const OffsetSampler& sampler, double offset_mm,
                    const std::function<void(Grid)>& visit);
/// All of them together.
std::vector<Grid> pieces(const OffsetSampler& sampler, double offset_mm);

/// All patches of a model as an OffsetSampler samples them, at once.
struct OffsetModel {
  std::vector<Grid> grids;  ///< one a patch
  std::vector<int> depths;  ///< one a patch
  std::vector<Grid> corners;
  std::vector<int> intervals;
  double offset_mm = 0;
  double excess_mm = 0;
};
OffsetModel sample_offset(const PatchModel& model, double offset_mm, double error_mm);

}  // namespace limitgauge::engine::surface
