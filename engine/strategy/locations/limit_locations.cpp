#include "engine/strategy/locations/limit_locations.h"

#include <utility>

#include "engine/tolerance.h"

namespace limitgauge::engine::strategy {

LimitLocations limit_locations(const surface::PatchModel& model, const StageRequest& request) {
  const double error = kLimitMeshShare * request.cut.tolerance_mm;
  surface::OffsetSampler sampler(model, error);
  const double kept = request.allowance_mm + error + sampler.excess_mm(0);
  std::vector<surface::Grid> pieces = surface::pieces(sampler, 0);
  model::Box3 part;
  for (int p = 0; p < sampler.patches(); ++p)
    for (const Vec3& point : pieces[p].points) part.add(point);
  CutterLocations surface(std::move(pieces), request.cutter, kept);
  const double lowest = part.low.z - request.cutter.corner_radius_mm - kHeightError_mm;
  return {std::move(surface), std::move(sampler), part, kept, lowest};
}

}  // namespace limitgauge::engine::strategy
