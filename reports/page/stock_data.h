#pragma once

#include "reports/page/blocks.h"
#include "reports/page/stock_view.h"

namespace limitgauge::reports::page {

/// "stock" of a stage (reports/web/README.md).
Json stock_data(const StockView& view, Blob& blob);

}  // namespace limitgauge::reports::page
