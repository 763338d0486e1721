// write_samples FOLDER [--no-pictures] [NAME...]: the reports of sample jobs, each in its folder,
// for checks by readers that are not ours: passed, failed, undecided, foreign and cut, a program
// without a design (without names these), for browsers hostile (markup in every text) and large
// (200,000 cells a stage), turning (the tool of one stage), and thinned, whose field is too large to be shown whole.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reports/run/report.h"
#include "tests/reports/hostile_result.h"
#include "tests/reports/sample_result.h"

using namespace limitgauge::reports;

namespace {

constexpr int kSamplesPerEdge = 41;
/// 30 patches of 82 x 82 and of 99 x 99 cells.
constexpr int kLargeSamplesPerEdge = 83, kThinnedSamplesPerEdge = 100;

struct Sample {
  std::function<RunResult()> result;
  bool names_folders = true;  ///< the stages' names do
};

RunResult thinned_result() {
  RunResult result = sample_result(Outcome::passed, kThinnedSamplesPerEdge);
  result.stages.resize(1);
  return result;
}

const std::map<std::string, Sample> kSamples = {
    {"passed", {[] { return sample_result(Outcome::passed, kSamplesPerEdge); }}},
    {"failed", {[] { return sample_result(Outcome::failed, kSamplesPerEdge); }}},
    {"undecided", {[] { return sample_result(Outcome::indeterminate, kSamplesPerEdge); }}},
    {"foreign", {[] { return foreign_result(kSamplesPerEdge); }}},
    {"cut", {[] { return cut_result(); }}},
    {"turning", {[] { return turning_result(kSamplesPerEdge); }}},
    {"hostile", {[] { return hostile_result(); }, false}},
    {"large", {[] { return sample_result(Outcome::passed, kLargeSamplesPerEdge); }}},
    {"thinned", {thinned_result}},
};

/// What the page's field must hold: a line a sample, deviation in all its digits.
void write_field(const StageResult& stage, const std::filesystem::path& file) {
  std::ofstream out(file);
  out.precision(9);
  for (const auto& s : stage.ran->deviation->field.samples)
    out << s.deviation_mm << ' ' << s.line << ' ' << s.stage << ' ' << s.reachable << '\n';
}

/// The stage's files, and in the result what the page shows of them.
void write_stage(StageResult& stage, bool names_folder, const std::filesystem::path& folder,
                 bool pictures) {
  std::string name = stage.name;
  if (!names_folder) stage.name = "stage";
  StageFiles files = write_stage_files(stage, folder, {.pictures = pictures, .rapid_mm_min = 5000});
  if (stage.ran) {
    stage.ran->path_view = std::move(files.path_view);
    if (stage.ran->deviation) write_field(stage, folder / stage.name / "field.txt");
  }
  stage.name = std::move(name);
  if (pictures) stage.pictures = std::move(files.pictures);
}

void write_all(const Sample& sample, const std::filesystem::path& folder, bool pictures) {
  RunResult result = sample.result();
  std::filesystem::create_directories(folder);
  for (StageResult& stage : result.stages)
    write_stage(stage, sample.names_folders, folder, pictures);
  write_stages_vtm(result, folder);
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
  if (argc < 2) return 2;
  const std::filesystem::path folder(argv[1]);
  std::vector<std::string> names(argv + 2, argv + argc);
  const bool pictures = std::erase(names, "--no-pictures") == 0;
  if (names.empty()) names = {"passed", "failed", "undecided", "foreign", "cut"};
  for (const std::string& name : names) write_all(kSamples.at(name), folder / name, pictures);
  std::ofstream(folder / "schema.json") << result_schema();
}
