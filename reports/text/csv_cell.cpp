#include "reports/text/csv_cell.h"

#include <algorithm>
#include <array>

#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

/// What makes a formula of a cell in one spreadsheet or another; the last four are the full-width
/// forms that some take for the others.
constexpr std::array<std::string_view, 8> kFormulaHeads = {"=",  "+",  "-",  "@",
                                                           "＝", "＋", "－", "＠"};

bool may_be_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\n"), text.size()));
  return std::any_of(kFormulaHeads.begin(), kFormulaHeads.end(),
                     [&](std::string_view head) { return text.starts_with(head); });
}

}  // namespace

std::string csv_text_cell(std::string_view text) {
  const std::string clean = clean_text(text);
  std::string out = may_be_formula(clean) ? "\"'" : "\"";
  for (const char c : clean) out.append(c == '"' ? 2 : 1, c);
  return out + '"';
}

}  // namespace limitgauge::reports
