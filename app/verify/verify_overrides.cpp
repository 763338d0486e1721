#include "app/verify/verify_overrides.h"

#include "app/job/job_overrides.h"
#include "app/job/job_parts.h"
#include "app/job/job_post.h"
#include "app/job/job_reader.h"
#include "app/run/reach_limit.h"

namespace limitgauge::app {
namespace {

toml::table gate_table(const verifier::GateLimits& limits) {
  toml::table gate;
  if (limits.has_gouge) gate.insert("gouge", limits.gouge_mm);
  if (limits.has_uncut) gate.insert("uncut", limits.uncut_mm);
  if (limits.has_coverage) gate.insert("coverage", limits.coverage);
  if (limits.has_unavoidable) gate.insert("unavoidable", limits.unavoidable_mm);
  if (limits.has_unreachable && limits.unreachable_is_share)
    gate.insert("unreachable", limits.unreachable);
  else if (limits.has_unreachable)
    gate.insert("unreachable", unreachable_text(limits));
  return gate;
}

/// What of the job can be named by a key: its name and its stages.
toml::table nameable(const Job& job) {
  toml::array stages;
  for (const JobStage& stage : job.stages)
    stages.push_back(toml::table{{"name", stage.name},
                                 {"allowance", stage.allowance_mm},
                                 {"gate", gate_table(stage.limits)}});
  return toml::table{{"name", job.name}, {"stage", std::move(stages)}};
}

/// A key that is no key of a job is told by the table's own reader.
void refuse_options(const TomlTable& table, const std::string& where,
                    std::span<const std::pair<const char*, const char*>> options) {
  for (const auto& [key, option] : options)
    if (table.has(key))
      throw model::InputError(
          table.place(key),
          std::string("verify takes \"") + key + "\" of " + where + " from its options", option);
}

constexpr std::pair<const char*, const char*> kJobOptions[] = {
    {"stock", "--stock"},
    {"tool", "--tool"},
    {"fixture", "--fixture"},
    {"post", "none: verify writes no program"},
    {"published", "none: such figures stand in a job file"}};
constexpr std::pair<const char*, const char*> kSurfaceOptions[] = {{"cage", "--cage"}};
constexpr std::pair<const char*, const char*> kStageOptions[] = {{"tool", "--tool"},
                                                                 {"program", "--program"}};

void read_surface(const TomlTable& root, Job& job) {
  const TomlTable surface(root.table("surface"), "[surface]", {"cage", "precision", "transform"});
  refuse_options(surface, "[surface]", kSurfaceOptions);
  if (surface.has("precision")) job.precision_mm = surface.positive("precision");
  read_placement(surface, job);
}

void read_stage(const toml::table& table, JobStage& stage) {
  const TomlTable keys(table, "[[stage]] of verify",
                       {"name", "allowance", "gate", "tool", "program"});
  refuse_options(keys, "[[stage]]", kStageOptions);
  if (keys.text("name") != stage.name)
    throw model::InputError(keys.place("name"), "verify names its stages itself",
                            "other keys of the stage \"" + stage.name + "\"");
  stage.allowance_mm = keys.not_negative("allowance");
  stage.limits = read_gate(keys);
}

}  // namespace

void apply_verify_overrides(Job& job, std::span<const std::string> overrides) {
  if (overrides.empty()) return;
  toml::table table = nameable(job);
  apply_overrides(table, overrides);
  const TomlTable root(table, "the job", {}, kJobKeys);
  refuse_options(root, "the job", kJobOptions);
  job.name = read_job_name(root);
  if (root.has("surface")) read_surface(root, job);
  JobContext context;  // what it gathers of defaults concerns job files
  if (root.has("machine") || root.has("program_frame")) read_machine(root, job, context);
  read_settings(root, job);
  const std::vector<const toml::table*> stages = root.tables("stage");
  for (std::size_t i = 0; i < stages.size(); ++i) read_stage(*stages[i], job.stages.at(i));
}

}  // namespace limitgauge::app
