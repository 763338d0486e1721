// write_samples FOLDER [NAME...]: the reports of sample jobs, each in its folder, for checks by
// readers that are not ours: passed, failed, undecided, and large, the page of a field that is too
// large to be shown whole (without names these four); for browsers hostile, with markup in every
// text, and full, with as many cells a stage as a page shows.
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reports/report.h"
#include "tests/reports/hostile_result.h"
#include "tests/reports/sample_result.h"

using namespace limitgauge::reports;

namespace {

constexpr int kSamplesPerEdge = 41;
/// 30 patches of 82 x 82 cells.
constexpr int kFullSamplesPerEdge = 83;
/// 30 patches of 99 x 99 cells.
constexpr int kLargeSamplesPerEdge = 100;

struct Sample {
  std::function<RunResult()> result;
  bool names_folders = true;  ///< the stages' names do
};

RunResult large_result() {
  RunResult result = sample_result(Outcome::passed, kLargeSamplesPerEdge);
  result.stages.resize(1);
  return result;
}

const std::map<std::string, Sample> kSamples = {
    {"passed", {[] { return sample_result(Outcome::passed, kSamplesPerEdge); }}},
    {"failed", {[] { return sample_result(Outcome::failed, kSamplesPerEdge); }}},
    {"undecided", {[] { return sample_result(Outcome::indeterminate, kSamplesPerEdge); }}},
    {"large", {large_result}},
    {"hostile", {hostile_result, false}},
    {"full", {[] { return sample_result(Outcome::passed, kFullSamplesPerEdge); }}},
};

/// What the page's field must hold: a line a sample, deviation in all its digits.
void write_field(const StageResult& stage, const std::filesystem::path& file) {
  std::ofstream out(file);
  out.precision(9);
  for (const auto& s : stage.ran->deviation.field.samples)
    out << s.deviation_mm << ' ' << s.line << ' ' << s.stage << ' ' << s.reachable << '\n';
}

void write_files(StageResult& stage, const std::string& name, const std::filesystem::path& folder) {
  std::string own = std::exchange(stage.name, name);
  StageFiles files = write_stage_files(stage, folder, {.rapid_mm_min = 5000});
  stage.name = std::move(own);
  stage.pictures = std::move(files.pictures);
  if (!stage.ran) return;
  stage.ran->path_view = std::move(files.path_view);
  write_field(stage, folder / name / "field.txt");
}

void write_all(const Sample& sample, const std::filesystem::path& folder) {
  RunResult result = sample.result();
  std::filesystem::create_directories(folder);
  for (StageResult& stage : result.stages)
    write_files(stage, sample.names_folders ? stage.name : "stage", folder);
  std::ofstream json(folder / "result.json"), junit(folder / "junit.xml"),
      page(folder / "report.html");
  write_result_json(result, json);
  write_junit(result, junit);
  write_html(result, page);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const std::filesystem::path folder(argv[1]);
  std::vector<std::string> names(argv + 2, argv + argc);
  if (names.empty()) names = {"passed", "failed", "undecided", "large"};
  for (const std::string& name : names) write_all(kSamples.at(name), folder / name);
  std::ofstream(folder / "schema.json") << result_schema();
}
