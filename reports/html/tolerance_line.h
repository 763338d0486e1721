#pragma once

#include <string>
#include <string_view>

#include "reports/run/run_result.h"

namespace limitgauge::reports::html {

/// For the header: which tolerances the verdict holds for, and what is of the stated tools and zero
/// alone. Empty where no stage was certified for any.
std::string tolerance_line(const RunResult& result);

/// What the table of stages has to say of its figures then; empty likewise.
std::string toleranced_table_words(const RunResult& result);

/// The style of what the page says of tolerances; empty likewise, so that other pages have none.
std::string_view tolerance_style(const RunResult& result);

}  // namespace limitgauge::reports::html
