#include "reports/page/stock_data.h"

#include "reports/page/surface_data.h"

namespace limitgauge::reports::page {

Json stock_data(const StockView& view, Blob& blob) {
  std::vector<std::uint32_t> stage, move, line;
  for (const StockView::Maker& maker : view.makers) {
    stage.push_back(maker.pass);
    move.push_back(maker.move), line.push_back(maker.line);
  }
  return {{"position", points_block(on_grid(view.mesh.vertices), blob)},
          {"triangle", blob.add(corners_of(view.mesh.triangles), 3)},
          {"maker", blob.add(stage)},
          {"move", blob.add(move)},
          {"line", blob.add(line)},
          {"surface_triangles", view.surface_triangles},
          {"within_mm", view.within_mm},
          {"checked", view.checked}};
}

}  // namespace limitgauge::reports::page
