#include "engine/surface/finish_model.h"

#include <algorithm>
#include <stdexcept>

#include "engine/surface/patch_model.h"
#include "model/base/clock.h"

namespace limitgauge::engine::surface {

namespace {
/// Three coordinates in single precision.
constexpr std::size_t kFloatPoint = 12;
}  // namespace

FinishModel::FinishModel(const model::Cage& cage, const ModelRequest& request,
                         const model::RunControl& control) {
  if (!(request.precision_mm > 0)) throw std::invalid_argument("precision_mm must be positive");
  const model::Stopwatch watch;
  const auto built = std::make_shared<const PatchModel>(cage, request, control);
  patches_ = built;
  figures_.patches = static_cast<int>(built->patches().size());
  if (figures_.patches == 0) throw std::invalid_argument("the cage has no face that is surface");
  figures_.depth_min = figures_.depth_max = built->patches().front().limit.depth;
  for (const ModelPatch& patch : built->patches()) {
    figures_.depths.push_back(patch.limit.depth);
    figures_.depth_min = std::min(figures_.depth_min, patch.limit.depth);
    figures_.depth_max = std::max(figures_.depth_max, patch.limit.depth);
  }
  for (const ModelPatch& patch : built->patches()) {
    figures_.cell_bytes_counted += cell_bytes_counted(patch.limit.depth, kFloatPoint);
    figures_.cell_bytes_allocated += patch.cell_bytes;
  }
  figures_.memory_bytes = built->memory_bytes();
  figures_.seconds = watch.seconds();
}

}  // namespace limitgauge::engine::surface
