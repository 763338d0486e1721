// write_samples FOLDER [--no-pictures]: the reports of a passed, a failed, an undecided and a
// foreign sample job, for checks by readers that are not ours.
#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

#include "reports/report.h"
#include "tests/reports/sample_result.h"

using namespace limitgauge::reports;

namespace {

void write_all(RunResult result, const std::filesystem::path& folder, bool pictures) {
  std::filesystem::create_directories(folder);
  for (StageResult& stage : result.stages) {
    StageFiles files = write_stage_files(stage, folder, {.pictures = pictures});
    if (pictures) stage.pictures = std::move(files.pictures);
  }
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
  const bool pictures = argc == 2;
  if (!pictures && (argc != 3 || std::string_view(argv[2]) != "--no-pictures")) return 2;
  const std::filesystem::path folder(argv[1]);
  write_all(sample_result(Outcome::passed, 41), folder / "passed", pictures);
  write_all(sample_result(Outcome::failed, 41), folder / "failed", pictures);
  write_all(sample_result(Outcome::indeterminate, 41), folder / "undecided", pictures);
  write_all(foreign_result(41), folder / "foreign", pictures);
  std::ofstream(folder / "schema.json") << result_schema();
}
