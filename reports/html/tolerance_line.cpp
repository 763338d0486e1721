#include "reports/html/tolerance_line.h"

#include <algorithm>

#include <fmt/format.h>

#include "reports/html/tolerance_words.h"
#include "reports/text/embedded.h"

namespace limitgauge::reports::html {
namespace {

bool has_tolerances(const RunResult& result) {
  return result.tolerances &&
         std::any_of(result.stages.begin(), result.stages.end(), [](const StageResult& stage) {
           return stage.ran && stage.ran->deviation && stage.ran->deviation->robust;
         });
}

}  // namespace

std::string tolerance_line(const RunResult& result) {
  if (!has_tolerances(result)) return {};
  const bool passed = result.verdict == verifier::Verdict::pass;
  return fmt::format(
      "<p class=\"tolerances\"><strong>Tolerances:</strong> gouge and uncut {} {}, in any "
      "combination. Coverage, what is shown as out of reach, maps, the process, and findings but "
      "for the worst over the tolerances are of the stated tools and zero.</p>\n",
      passed ? "hold for" : "are judged for", tolerances_words(*result.tolerances));
}

std::string toleranced_table_words(const RunResult& result) {
  if (!has_tolerances(result)) return {};
  return " Both are for all values of the tolerances; what they are as stated is said with each "
         "stage.";
}

std::string_view tolerance_style(const RunResult& result) {
  return has_tolerances(result) ? embedded::tolerances_css() : std::string_view();
}

}  // namespace limitgauge::reports::html
