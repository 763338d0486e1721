#pragma once

#include "reports/page/blocks.h"
#include "reports/page/path_view.h"

namespace limitgauge::reports::page {

/// "path" of a stage.
Json path_data(const PathView& view, Blob& blob);

}  // namespace limitgauge::reports::page
