#include <algorithm>
#include <array>
#include <ostream>

#include "reports/finding_list.h"
#include "reports/report.h"
#include "reports/text.h"

namespace limitgauge::reports {
namespace {

constexpr std::string_view kHeader =
    "stage,kind,id,depth_mm,area_mm2,x,y,z,patch,u,v,body,program,line,move,words";

/// What makes a formula of a cell in one spreadsheet or another; the last four are the full-width
/// forms that some take for the others.
constexpr std::array<std::string_view, 8> kFormulaHeads = {"=",  "+",  "-",  "@",
                                                           "＝", "＋", "－", "＠"};

bool may_be_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t\n"), text.size()));
  return std::any_of(kFormulaHeads.begin(), kFormulaHeads.end(),
                     [&](std::string_view head) { return text.starts_with(head); });
}

/// In quotes always; an apostrophe before what a spreadsheet would reckon out.
std::string text_cell(std::string_view text) {
  const std::string clean = clean_text(text);
  std::string out = may_be_formula(clean) ? "\"'" : "\"";
  for (const char c : clean) out.append(c == '"' ? 2 : 1, c);
  return out + '"';
}

template <typename T, typename Show>
std::string optional_cell(const std::optional<T>& value, Show show) {
  return value ? std::string(show(*value)) : std::string();
}

std::string row(const RunResult& result, const ListedFinding& f) {
  using verifier::SurfacePlace;
  const auto count = [](std::uint64_t n) { return std::to_string(n); };
  const std::array cells = {
      text_cell(result.stages[f.stage].name),
      text_cell(f.kind),
      text_cell(f.id),
      shortest(f.depth_mm),
      optional_cell(f.area_mm2, shortest),
      shortest(f.point.x),
      shortest(f.point.y),
      shortest(f.point.z),
      optional_cell(f.place, [](const SurfacePlace& p) { return std::to_string(p.patch); }),
      optional_cell(f.place, [](const SurfacePlace& p) { return shortest(p.u); }),
      optional_cell(f.place, [](const SurfacePlace& p) { return shortest(p.v); }),
      text_cell(f.body),
      text_cell(program_file(result.stages[f.program_stage])),
      f.line > 0 ? count(f.line) : std::string(),
      f.line > 0 ? count(f.move) : std::string(),
      text_cell(f.words)};
  std::string out = cells[0];
  for (std::size_t i = 1; i < cells.size(); ++i) out += "," + cells[i];
  return out;
}

}  // namespace

void write_findings_csv(const RunResult& result, std::ostream& out) {
  out << kHeader << "\r\n";
  for (std::size_t i = 0; i < result.stages.size(); ++i)
    for (const ListedFinding& finding : list_findings(result, i))
      out << row(result, finding) << "\r\n";
}

}  // namespace limitgauge::reports
