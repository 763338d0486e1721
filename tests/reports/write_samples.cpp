// write_samples FOLDER [NAME...]: the reports of sample jobs, each in its folder, for checks by
// readers that are not ours: passed, failed, undecided (without names these three), and, for
// browsers, hostile (markup in every text) and large (200,000 cells a stage).
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
constexpr int kLargeSamplesPerEdge = 83;

struct Sample {
  std::function<RunResult()> result;
  bool names_folders = true;  ///< the stages' names do
};

const std::map<std::string, Sample> kSamples = {
    {"passed", {[] { return sample_result(Outcome::passed, kSamplesPerEdge); }}},
    {"failed", {[] { return sample_result(Outcome::failed, kSamplesPerEdge); }}},
    {"undecided", {[] { return sample_result(Outcome::indeterminate, kSamplesPerEdge); }}},
    {"hostile", {[] { return hostile_result(); }, false}},
    {"large", {[] { return sample_result(Outcome::passed, kLargeSamplesPerEdge); }}},
};

void write_all(const Sample& sample, const std::filesystem::path& folder) {
  RunResult result = sample.result();
  std::filesystem::create_directories(folder);
  for (StageResult& stage : result.stages) {
    std::string name = stage.name;
    if (!sample.names_folders) stage.name = "stage";
    StageFiles files = write_stage_files(stage, folder, {.rapid_mm_min = 5000});
    stage.name = std::move(name);
    stage.pictures = std::move(files.pictures);
    if (stage.ran) stage.ran->path_view = std::move(files.path_view);
  }
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
  if (names.empty()) names = {"passed", "failed", "undecided"};
  for (const std::string& name : names) write_all(kSamples.at(name), folder / name);
  std::ofstream(folder / "schema.json") << result_schema();
}
