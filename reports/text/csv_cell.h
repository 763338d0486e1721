#pragma once

#include <string>
#include <string_view>

namespace limitgauge::reports {

/// `text` as a cell of an RFC 4180 file: in quotes always, with an apostrophe before what a
/// spreadsheet would take for a formula.
std::string csv_text_cell(std::string_view text);

}  // namespace limitgauge::reports
