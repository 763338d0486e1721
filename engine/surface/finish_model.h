#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "engine/surface/model_request.h"
#include "model/base/run_control.h"
#include "model/part/cage.h"

namespace limitgauge::engine::surface {

class PatchModel;  // CELL patches with their limit meshes; see patch_model.h

/// Table 1 of the paper, for result.json.
struct ModelFigures {
  int patches = 0;
  int depth_min = 0, depth_max = 0;
  std::vector<int> depths;  ///< one a patch
  double seconds = 0;
  std::size_t memory_bytes = 0;  ///< of the limit meshes with their normals, corners included
  /// Of CELL's control points at the patches' depths in single precision, as the paper counts them
  /// (section 8.1), and as FloatCellPatch allocates them, rings included. The model keeps the limit
  /// meshes only.
  std::size_t cell_bytes_counted = 0, cell_bytes_allocated = 0;
};

/// The engine's view of the design surface: an immutable value, cheap to copy.
class FinishModel {
 public:
  /// Refines every patch of `cage` to the depth its bound asks for (paper sections 3 and 4).
  FinishModel(const model::Cage& cage, const ModelRequest& request,
              const model::RunControl& control);
  const ModelFigures& figures() const { return figures_; }
  const PatchModel& patches() const { return *patches_; }

 private:
  std::shared_ptr<const PatchModel> patches_;
  ModelFigures figures_;
};

}  // namespace limitgauge::engine::surface
