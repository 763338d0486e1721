// write_samples FOLDER: the reports of a passed, a failed and an undecided sample job, for checks
// by readers that are not ours, and the page of one whose field is too large to be shown whole.
#include <filesystem>
#include <fstream>
#include <vector>

#include "reports/report.h"
#include "tests/reports/sample_result.h"

using namespace limitgauge::reports;

namespace {

/// What the page's field must hold: a line a sample, deviation in all its digits.
void write_field(const StageResult& stage, const std::filesystem::path& file) {
  std::ofstream out(file);
  out.precision(9);
  for (const auto& s : stage.ran->deviation.field.samples)
    out << s.deviation_mm << ' ' << s.line << ' ' << s.stage << ' ' << s.reachable << '\n';
}

void write_all(RunResult result, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  for (StageResult& stage : result.stages) {
    StageFiles files = write_stage_files(stage, folder, {.rapid_mm_min = 5000});
    stage.pictures = std::move(files.pictures);
    if (!stage.ran) continue;
    stage.ran->path_view = std::move(files.path_view);
    write_field(stage, folder / stage.name / "field.txt");
  }
  std::ofstream json(folder / "result.json"), junit(folder / "junit.xml"),
      page(folder / "report.html");
  write_result_json(result, json);
  write_junit(result, junit);
  write_html(result, page);
}

/// 30 patches of 99 x 99 cells.
void write_large_page(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  RunResult result = sample_result(Outcome::passed, 100);
  result.stages.resize(1);
  std::ofstream page(folder / "report.html");
  write_html(result, page);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder(argv[1]);
  write_all(sample_result(Outcome::passed, 41), folder / "passed");
  write_all(sample_result(Outcome::failed, 41), folder / "failed");
  write_all(sample_result(Outcome::indeterminate, 41), folder / "undecided");
  write_large_page(folder / "large");
  std::ofstream(folder / "schema.json") << result_schema();
}
