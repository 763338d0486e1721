// write_samples FOLDER [NAME...]: the reports of sample jobs, each in its folder, for checks by
// readers that are not ours: passed, failed, undecided (without names these three), and, for
// browsers, hostile (markup in every text) and large (200,000 cells a stage).
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
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
  bool page_only = false;  ///< no stage files: a hostile name is none for a folder
};

const std::map<std::string, Sample> kSamples = {
    {"passed", {[] { return sample_result(Outcome::passed, kSamplesPerEdge); }}},
    {"failed", {[] { return sample_result(Outcome::failed, kSamplesPerEdge); }}},
    {"undecided", {[] { return sample_result(Outcome::indeterminate, kSamplesPerEdge); }}},
    {"hostile", {[] { return hostile_result(); }, true}},
    {"large", {[] { return sample_result(Outcome::passed, kLargeSamplesPerEdge); }, true}},
};

void write_all(const Sample& sample, const std::filesystem::path& folder) {
  RunResult result = sample.result();
  std::filesystem::create_directories(folder);
  for (StageResult& stage : result.stages)
    if (stage.ran)
      stage.pictures =
          sample.page_only ? draw_pictures(stage) : write_stage_files(stage, folder, {}).pictures;
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
