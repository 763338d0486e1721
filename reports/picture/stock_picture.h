#pragma once

#include "reports/picture/image.h"
#include "simulator/stock/stock_model.h"

namespace limitgauge::reports {

/// The stock's surface, seen from the front right and above in parallel projection, shaded, on a
/// transparent ground, with the axes in a corner. `largest_width` in pixels. The axes are
/// those of the frame that `from_part` leads from to the mesh's.
Image draw_stock_picture(const simulator::StockMesh& mesh, int largest_width,
                         const model::Pose& from_part = {});

}  // namespace limitgauge::reports
