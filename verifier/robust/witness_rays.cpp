#include "verifier/robust/witness_rays.h"

#include "verifier/gate/stock_rays.h"

namespace limitgauge::verifier {
namespace {

std::vector<Pass> passes_at_values(const RobustScene& scene, const RobustFigure& figure) {
  ToleranceValues values;
  for (const NamedLength& value : figure.at) values.push_back(value.mm);
  return ToleranceBox(*scene.check.tolerances, scene.passes).passes_at(values);
}

}  // namespace

void read_witnesses(RobustDeviation& robust, const RobustScene& scene,
                    const model::Stock& raw_stock, const StockProbe& probe,
                    const model::RunControl& control) {
  for (RobustFigure* figure : {&robust.gouge, &robust.uncut}) {
    if (!figure->place || figure->body != "cutter") continue;
    const std::vector<Pass> passes = passes_at_values(scene, *figure);
    const std::unique_ptr<StockProbe> cut = probe.cut_by(passes, control);
    if (!cut) continue;
    const RemovedSpace removed(raw_stock, passes);
    const double allowance = scene.check.allowance_mm;
    const double longest = length(model::bounding_box(raw_stock).size()) + allowance;
    const RayReading read = read_ray({scene.cells, removed, scene.raw, *cut, longest},
                                     figure->place->point, figure->normal, allowance);
    figure->voxel_mm = figure == &robust.gouge ? read.gouge_mm : read.uncut_mm;
  }
}

}  // namespace limitgauge::verifier
