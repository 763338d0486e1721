// write_histories FOLDER: pages of histories for browsers, each in a folder of its name as
// report.html, with its JSON: forty (runs of one job), two-jobs, one (run), many (1,000 runs) and
// hostile (markup in every text).
#include <filesystem>
#include <fstream>

#include "reports/history/history_report.h"
#include "tests/reports/sample_history.h"

using namespace limitgauge::reports;
using history_report::Overview;

namespace {

void write(const std::filesystem::path& folder, const Overview& overview) {
  std::filesystem::create_directories(folder);
  std::ofstream page(folder / "report.html"), json(folder / "result.json");
  history_report::write_history_html(overview, page);
  history_report::write_history_json(overview, json);
}

Overview two_jobs() {
  auto runs = sample_runs(30);
  for (std::size_t i = 0; i < runs.size(); i += 3) runs[i].job = "wing";
  return overview_of(runs);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder(argv[1]);
  write(folder / "forty", overview_of(sample_runs(40)));
  write(folder / "two-jobs", two_jobs());
  write(folder / "one", overview_of(sample_runs(1)));
  write(folder / "many", overview_of(sample_runs(1000)));
  write(folder / "hostile", hostile_overview());
}
