#include "verifier/certificate/leftover_regions.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "verifier/certificate/exceedance.h"
#include "verifier/reach/reach_query.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

/// One box a tile of the plane, around the spots whose middles lie in it.
std::vector<model::Box3> gathered(const std::vector<Spot>& spots, double tile_mm) {
  std::map<std::pair<long, long>, model::Box3> tiles;
  for (const Spot& spot : spots) {
    const model::Vec3& p = spot.place.point;
    const auto tile = [&](double at) { return static_cast<long>(std::floor(at / tile_mm)); };
    const double r = spot.radius_mm;
    tiles[{tile(p.x), tile(p.y)}].add(
        model::Box3{p - model::Vec3{r, r, r}, p + model::Vec3{r, r, r}});
  }
  std::vector<model::Box3> boxes;
  for (const auto& [place, box] : tiles) boxes.push_back(box);
  return boxes;
}

}  // namespace

LeftoverRegions find_leftover_regions(const ReferenceSurface& surface,
                                      const model::Stock& raw_stock, std::span<const Pass> passes,
                                      const LeftoverRequest& request,
                                      const model::RunControl& control) {
  if (!(request.threshold_mm > 0) || !(request.tile_mm > 0))
    throw std::invalid_argument("threshold and tile must be positive");
  const SurfaceCells cells(surface.tree(), first_cell_radius_mm(surface.tree()));
  const RemovedSpace space(raw_stock, passes);
  const CutterProfile cutter(request.cutter);
  const Reachability search(cells, cutter, request.allowance_mm, kContact_mm);
  const ReachMap proven = classify_reach(cells, search, kReachEffort, control);
  const ReachQuery reach(std::span(&search, 1), proven);
  ExceedanceRequest asked;
  asked.side = Side::uncut;
  asked.allowance_mm = request.allowance_mm;
  asked.threshold_mm = request.threshold_mm;
  asked.slack_mm = request.threshold_mm / 4;
  const Exceedance found = find_exceedance(cells, space, &reach, asked, control);
  LeftoverRegions regions{gathered(found.spots, request.tile_mm), 0, found.complete};
  for (const Spot& spot : found.spots) regions.area_mm2 += spot.area_mm2;
  return regions;
}

}  // namespace limitgauge::verifier
