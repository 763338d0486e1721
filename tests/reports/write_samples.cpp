// write_samples FOLDER: the reports of a passed, a failed, an undecided and a foreign sample job,
// for checks by readers that are not ours.
#include <filesystem>
#include <fstream>
#include <vector>

#include "reports/report.h"
#include "tests/reports/sample_result.h"

using namespace limitgauge::reports;

namespace {

void write_all(RunResult result, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (StageResult& stage : result.stages)
    stage.pictures = write_stage_files(stage, folder, {}).pictures;
  std::ofstream json(folder / "result.json"), junit(folder / "junit.xml"),
      page(folder / "report.html"), sarif(folder / "findings.sarif"),
      csv(folder / "findings.csv", std::ios::binary);
  write_result_json(result, json);
  write_junit(result, junit);
  write_sarif(result, sarif);
  write_findings_csv(result, csv);
  write_html(result, page);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder(argv[1]);
  write_all(sample_result(Outcome::passed, 41), folder / "passed");
  write_all(sample_result(Outcome::failed, 41), folder / "failed");
  write_all(sample_result(Outcome::indeterminate, 41), folder / "undecided");
  write_all(foreign_result(41), folder / "foreign");
  std::ofstream(folder / "schema.json") << result_schema();
}
