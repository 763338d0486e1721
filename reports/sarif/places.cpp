#include "reports/sarif/places.h"

#include <algorithm>

#include "model/text/hexadecimal.h"
#include "reports/run/program_lines.h"
#include "reports/text/text.h"

namespace limitgauge::reports::sarif {
namespace {

/// The folder that findings.sarif lies in, and the one that paths in a job file start from.
constexpr const char *kOutput = "OUTPUT", *kJob = "JOB";

Json artifact_location(const StageResult& stage) {
  const std::string file = program_file(stage);
  Json out = {{"uri", uri_of(file)}};
  if (!file.starts_with('/')) out["uriBaseId"] = stage.program.empty() ? kOutput : kJob;
  return out;
}

std::vector<std::uint32_t> lines_named(const std::vector<std::vector<ListedFinding>>& findings,
                                       std::size_t stage) {
  std::vector<std::uint32_t> lines;
  for (const std::vector<ListedFinding>& list : findings) {
    for (const ListedFinding& f : list) {
      if (f.program_stage == stage) lines.push_back(f.line);
      if (f.process && f.stage == stage)
        lines.insert(lines.end(), {f.process->first_line, f.process->last_line});
      for (const verifier::NearPass& pass : f.passes)
        if (pass.stage == stage) lines.push_back(pass.line);
    }
  }
  return lines;
}

}  // namespace

Places::Places(const RunResult& result, const std::vector<std::vector<ListedFinding>>& findings) {
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    const StageResult& stage = result.stages[i];
    const Json artifact = {{"location", artifact_location(stage)}, {"roles", {"analysisTarget"}}};
    const auto known = std::find(artifacts_.begin(), artifacts_.end(), artifact);
    artifact_of_stage_.push_back(std::size_t(known - artifacts_.begin()));
    if (known == artifacts_.end()) artifacts_.push_back(artifact);
    if (!stage.ran || !stage.ran->program_text) continue;
    for (ProgramLine& line : program_lines(*stage.ran->program_text, lines_named(findings, i), 0))
      text_[{i, line.line}] = std::move(line.text);
  }
}

Json Places::location(std::size_t stage, std::uint32_t line) const {
  const std::size_t artifact = artifact_of_stage_[stage];
  Json place = artifacts_[artifact]["location"];
  place["index"] = artifact;
  Json out = {{"artifactLocation", std::move(place)}};
  if (line == 0) return out;
  out["region"] = {{"startLine", line}};
  const std::string& snippet = text(stage, line);
  if (!snippet.empty()) out["region"]["snippet"] = {{"text", snippet}};
  return out;
}

const std::string& Places::text(std::size_t stage, std::uint32_t line) const {
  static const std::string kNone;
  const auto found = text_.find({stage, line});
  return found == text_.end() ? kNone : found->second;
}

Json base_ids() {
  const auto base = [](const char* text) { return Json{{"description", {{"text", text}}}}; };
  return {{kOutput, base("The folder of this file: the run's output folder.")},
          {kJob, base("The folder of the job file, from which its paths are taken; without a job "
                      "file the folder that the program was started in.")}};
}

std::string uri_of(std::string_view path) {
  return (path.starts_with('/') ? "file://" : "") + model::percent_encoded(path);
}

}  // namespace limitgauge::reports::sarif
