#include <algorithm>
#include <array>
#include <string_view>

#include "app/job/job_parts.h"
#include "app/job/job_reader.h"
#include "app/run/gate_limits.h"
#include "app/toml/toml_table.h"
#include "model/base/text_file.h"
#include "model/text/message_text.h"

namespace limitgauge::app {
namespace {

/// A stage that reads a program plans nothing: figures of a plan beside it would be ignored.
void refuse_plan_keys(const TomlTable& stage) {
  for (const char* key : kCutKeys) {
    if (!stage.has(key)) continue;
    throw model::InputError(stage.place(key),
                            "\"" + std::string(key) + "\" beside \"program\" would change nothing",
                            "it only beside \"strategy\"");
  }
}

/// What the strategies' cutter locations know. A program may be cut with any tool.
void require_plannable(const TomlTable& stage, const model::Cutter& cutter) {
  if (cutter.type != model::CutterType::drill && cutter.type != model::CutterType::apt) return;
  throw model::InputError(stage.place("tool"),
                          "strategy \"" + stage.text("strategy") + "\" with the " +
                              model::name(cutter.type) + " cutter \"" + cutter.id + "\"",
                          "flat, ball, bull or taper; a program takes any tool");
}

/// A ball's centre goes where it goes however the tool leans; no other cutter has such a place.
void require_leaning_ball(const TomlTable& stage, const JobStage& result) {
  if (!result.plan->cut.lean || result.cutter.type == model::CutterType::ball) return;
  throw model::InputError(stage.place("tilt"),
                          std::string("\"tilt\" of the ") + model::name(result.cutter.type) +
                              " cutter \"" + result.cutter.id + "\"",
                          "a ball, whose rows alone lean");
}

void read_source(const TomlTable& stage, bool first, JobStage& result, JobContext& context) {
  const bool planned = stage.has("strategy");
  if (planned == stage.has("program")) {
    throw model::InputError(
        planned ? stage.place("program") : stage.place(),
        "stage \"" + result.name + "\" has " +
            (planned ? "both strategy and program" : "neither strategy nor program"),
        "one of the two");
  }
  if (planned) {
    require_plannable(stage, result.cutter);
    result.plan = read_plan(stage, result.name, context);
    require_leaning_ball(stage, result);
    if (first && result.plan->cut.strategy == engine::strategy::Strategy::rest)
      throw model::InputError(stage.place("strategy"),
                              "a rest stage is the first: nothing was cut before it",
                              "a stage before it that leaves the rest");
    return;
  }
  refuse_plan_keys(stage);
  result.program_as_stated = stage.text("program");
  result.program = context.folder / result.program_as_stated;
  if (!model::is_file(result.program)) {
    throw model::InputError(stage.place("program"), "no file \"" + result.program_as_stated + "\"",
                            "a program");
  }
}

/// By its id; a stage that names the program's tool number may leave the id out.
const JobTool& find_tool(const TomlTable& stage, const std::vector<JobTool>& tools) {
  if (!stage.has("tool") && stage.has("program_tool")) {
    const int number = stage.whole("program_tool");
    for (const JobTool& tool : tools)
      if (tool.number == number) return tool;
    throw model::InputError(stage.place("program_tool"),
                            "no tool has the number " + std::to_string(number),
                            "a [[tool]] with it");
  }
  const std::string id = stage.text("tool");
  std::vector<std::string_view> ids;
  for (const JobTool& tool : tools) {
    if (tool.cutter.id == id) return tool;
    ids.push_back(tool.cutter.id);
  }
  throw model::InputError(stage.place("tool"), "no tool has the id \"" + id + "\"",
                          "\"" + model::nearest_word(id, ids) + "\" or another id of a [[tool]]");
}

constexpr const char* kPartKeys[] = {"program_tool", "program_section", "program_comment"};

/// Which part of the program; at most one of the keys.
void read_part(const TomlTable& stage, JobStage& result) {
  const char* stated = nullptr;
  for (const char* key : kPartKeys) {
    if (!stage.has(key)) continue;
    if (stated != nullptr)
      throw model::InputError(stage.place(key),
                              "\"" + std::string(key) + "\" beside \"" + stated + "\"",
                              "one of them");
    if (result.plan)
      throw model::InputError(stage.place(key),
                              "\"" + std::string(key) + "\" in a stage without a program",
                              "it only beside \"program\"");
    stated = key;
  }
  if (stage.has("program_tool")) result.part.tool = stage.whole("program_tool");
  if (stage.has("program_section")) result.part.section = stage.whole("program_section");
  if (stage.has("program_comment")) result.part.comment = stage.text("program_comment");
  if (result.part.tool && result.tool_number && *result.part.tool != *result.tool_number)
    throw model::InputError(stage.place("program_tool"),
                            "T" + std::to_string(*result.part.tool) + " is not the number of \"" +
                                result.cutter.id + "\"",
                            "T" + std::to_string(*result.tool_number) + ", or another tool");
}

/// What stands beside the stages' folders in a folder of results.
constexpr std::array<std::string_view, 8> kBesideStages = {
    "result.json", "report.html",     "findings.csv", "findings.sarif",
    "junit.xml",   "manifest.sha256", "stages.vtm",   "INCOMPLETE.txt"};

std::string read_name(const TomlTable& stage, const std::vector<JobStage>& before) {
  const std::string name = stage.text("name");
  if (!is_plain_name(name)) {
    throw model::InputError(stage.place("name"), "\"" + name + "\" cannot name a folder",
                            "letters, digits, '.', '_', '-'");
  }
  if (std::find(kBesideStages.begin(), kBesideStages.end(), name) != kBesideStages.end())
    throw model::InputError(stage.place("name"), "\"" + name + "\" is a file of the results",
                            "a name for the stage's folder beside it");
  for (const JobStage& other : before) {
    if (other.name != name) continue;
    throw model::InputError(stage.place("name"), "a second stage \"" + name + "\"",
                            "names that differ");
  }
  return name;
}

JobStage read_stage(const toml::table& table, const std::vector<JobStage>& before,
                    const std::vector<JobTool>& tools, const std::vector<JobSetup>& setups,
                    JobContext& context) {
  const TomlTable stage(table, "[[stage]]",
                        {"name", "tool", "strategy", "program", "program_tool", "program_section",
                         "program_comment", "allowance", "gate", "setup"},
                        kCutKeys);
  JobStage result;
  result.name = read_name(stage, before);
  const JobTool& tool = find_tool(stage, tools);
  result.cutter = tool.cutter;
  result.tool_number = tool.number;
  result.tool_length_mm = tool.length_mm;
  const auto setup = read_setup_name(stage, setups);
  if (!setup)
    throw model::InputError(stage.place(), "stage \"" + result.name + "\" names no setup",
                            "setup = \"" + setups.front().setup.name + "\" or another [[setup]]");
  result.setup = *setup;
  read_source(stage, before.empty(), result, context);
  read_part(stage, result);
  if (stage.has("allowance")) {
    result.allowance_mm = part_length_or_zero_mm(stage, "allowance", context.part_lengths);
  } else if (context.has_design) {
    context.defaulted.push_back("stage " + result.name + ": allowance 0 mm (default)");
  }
  result.limits = read_gate(stage, context.part_lengths);
  return result;
}

/// A number is a share of the surface, a text an area.
void read_unreachable(const TomlTable& gate, verifier::GateLimits& limits) {
  if (!gate.is_text("unreachable")) {
    limits.has_unreachable = true;
    limits.unreachable = gate.share("unreachable");
    return;
  }
  const std::string text = gate.text("unreachable");
  if (!set_unreachable(text, limits) || limits.unreachable_is_share)
    throw model::InputError(gate.place("unreachable"),
                            "\"unreachable\" in [stage.gate] is \"" + text + "\"",
                            kUnreachableExpected);
}

}  // namespace

verifier::GateLimits read_gate(const TomlTable& stage, std::vector<PartLength>& lengths) {
  verifier::GateLimits limits;
  if (!stage.has("gate")) return limits;
  const TomlTable gate(stage.table("gate"), "[stage.gate]",
                       {"gouge", "uncut", "coverage", "unreachable", "unavoidable"});
  limits.has_gouge = gate.has("gouge");
  limits.has_uncut = gate.has("uncut");
  limits.has_coverage = gate.has("coverage");
  limits.has_unavoidable = gate.has("unavoidable");
  if (limits.has_gouge) limits.gouge_mm = part_length_mm(gate, "gouge", lengths);
  if (limits.has_uncut) limits.uncut_mm = part_length_mm(gate, "uncut", lengths);
  if (limits.has_coverage) limits.coverage = gate.share("coverage");
  if (!coverage_has_limit(limits))
    throw model::InputError(gate.place("coverage"), kCoverageWithoutLimit, kCoverageExpected);
  if (limits.has_unavoidable)
    limits.unavoidable_mm = part_length_or_zero_mm(gate, "unavoidable", lengths);
  if (gate.has("unreachable")) read_unreachable(gate, limits);
  return limits;
}

std::vector<JobStage> read_stages(const std::vector<const toml::table*>& stages,
                                  const std::vector<JobTool>& tools,
                                  const std::vector<JobSetup>& setups, JobContext& context) {
  std::vector<JobStage> all;
  for (const toml::table* table : stages)
    all.push_back(read_stage(*table, all, tools, setups, context));
  return all;
}

}  // namespace limitgauge::app
