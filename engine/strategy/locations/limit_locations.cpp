#include "engine/strategy/locations/limit_locations.h"

#include <algorithm>
#include <utility>

#include "engine/tolerance.h"

namespace limitgauge::engine::strategy {

LimitLocations limit_locations(const surface::PatchModel& model, const StageRequest& request) {
  const double error = kLimitMeshShare * request.cut.tolerance_mm;
  surface::OffsetModel mesh = surface::sample_offset(model, 0, error);
  const double kept = request.allowance_mm + error + std::max(0.0, mesh.excess_mm);
  model::Box3 part;
  for (const surface::Grid& grid : mesh.grids)
    for (const Vec3& p : grid.points) part.add(p);
  CutterLocations surface(surface::pieces(mesh), request.cutter, kept);
  const double lowest = part.low.z - request.cutter.corner_radius_mm - kHeightError_mm;
  return {std::move(surface), std::move(mesh), part, kept, lowest};
}

}  // namespace limitgauge::engine::strategy
