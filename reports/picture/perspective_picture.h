#pragma once

#include "reports/picture/image.h"
#include "reports/run/run_result.h"

namespace limitgauge::reports {

/// perspective.png: the error map in true perspective, shaded, with its colour bar, the stage and
/// its verdict, and the worst gouge and leftover marked as the page numbers them. Seen from the
/// corner from which most of these are in sight.
Image draw_perspective_picture(const StageResult& stage);

}  // namespace limitgauge::reports
