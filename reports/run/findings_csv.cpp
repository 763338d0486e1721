#include <array>
#include <ostream>

#include "model/base/number_text.h"
#include "reports/run/finding_list.h"
#include "reports/run/report.h"
#include "reports/text/csv_cell.h"
#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

constexpr std::string_view kHeader =
    "stage,kind,id,depth_mm,area_mm2,x,y,z,patch,u,v,body,program,line,move,words";

template <typename T, typename Show>
std::string optional_cell(const std::optional<T>& value, Show show) {
  return value ? std::string(show(*value)) : std::string();
}

std::string row(const RunResult& result, const ListedFinding& f) {
  using verifier::SurfacePlace;
  const auto count = [](std::uint64_t n) { return std::to_string(n); };
  const std::array cells = {
      csv_text_cell(result.stages[f.stage].name),
      csv_text_cell(f.kind),
      csv_text_cell(f.id),
      model::shortest(f.depth_mm),
      optional_cell(f.area_mm2, model::shortest),
      model::shortest(f.point.x),
      model::shortest(f.point.y),
      model::shortest(f.point.z),
      optional_cell(f.place, [](const SurfacePlace& p) { return std::to_string(p.patch); }),
      optional_cell(f.place, [](const SurfacePlace& p) { return model::shortest(p.u); }),
      optional_cell(f.place, [](const SurfacePlace& p) { return model::shortest(p.v); }),
      csv_text_cell(f.body),
      csv_text_cell(program_file(result.stages[f.program_stage])),
      f.line > 0 ? count(f.line) : std::string(),
      f.line > 0 ? count(f.move) : std::string(),
      csv_text_cell(f.words)};
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
