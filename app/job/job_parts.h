#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "app/inputs/stock_file.h"
#include "app/job/job.h"
#include "app/toml/toml_table.h"

namespace limitgauge::app {

/// What the readers of a job's parts share.
struct JobContext {
  std::filesystem::path folder;  ///< of the job file
  std::vector<std::string> defaulted;
  std::vector<JobFile> sources;
  StockReaders stock_readers;
  std::vector<PartLength> part_lengths = {};
  bool has_design = true;  ///< the job has a [surface]
};

/// The length at `key`, and its place for what the part's extent says of it.
double part_length_mm(const TomlTable& table, std::string_view key,
                      std::vector<PartLength>& lengths);
/// The same of a length that may be 0.
double part_length_or_zero_mm(const TomlTable& table, std::string_view key,
                              std::vector<PartLength>& lengths);

/// Replaces or adds keys of `job` by `overrides` of the form `dotted.key=value`. The value is TOML;
/// a word that is none is taken as text. Throws InputError that names the override.
void apply_overrides(toml::table& job, std::span<const std::string> overrides);

/// The table that a job file's text and the overrides make together.
toml::table merged_job(const std::string& text, const std::string& name_in_errors,
                       std::span<const std::string> overrides);
/// The job that such a table states.
Job read_merged_job(const toml::table& table, JobContext context);

/// The tables and keys that a job may have.
inline constexpr const char* kJobKeys[] = {"name",          "surface",    "stock", "machine",
                                           "fixture",       "tool",       "stage", "simulation",
                                           "verification",  "report",     "post",  "published",
                                           "program_frame", "tolerances", "setup"};
/// The name, which must do as a folder's.
std::string read_job_name(const TomlTable& root);
/// `transform` of [surface], where it is stated.
void read_placement(const TomlTable& surface, JobDesign& design);
/// Of a job without [surface]: what could only be said of a design is an error that names its key.
/// Throws InputError.
void refuse_design_keys(const TomlTable& root);
/// [simulation], [verification] and [report], as far as they are stated.
void read_settings(const TomlTable& root, Job& job);
/// [tolerances], where it is stated, of the tools of that name. Throws InputError for a tool that
/// is none of them, and for what no such cutter has.
void read_tolerances(const TomlTable& root, std::span<const model::Cutter> tools, Job& job);
/// The limits of a stage; none where it has no gate.
verifier::GateLimits read_gate(const TomlTable& stage, std::vector<PartLength>& lengths);

/// A stock from a file is read, too; what is to be said of it goes among the defaults.
model::Stock read_stock(const toml::table& stock, JobContext& context);
/// The tools; two of one id or number are an error.
std::vector<JobTool> read_tools(const std::vector<const toml::table*>& tools, JobContext& context);
/// Figures of a publication to stand beside the run's own.
reports::PublishedFigures read_published(const TomlTable& root);
/// The stages in order; two of one name, a tool that is not among `tools`, or a setup that is not
/// among `setups`, are an error.
std::vector<JobStage> read_stages(const std::vector<const toml::table*>& stages,
                                  const std::vector<JobTool>& tools,
                                  const std::vector<JobSetup>& setups, JobContext& context);

/// Keys of a stage that say how it is cut, whatever the strategy.
inline constexpr const char* kCutKeys[] = {
    "step",          "scallop", "tolerance",  "feed",      "plunge_feed", "link_feed",
    "floor",         "angle",   "pattern",    "direction", "steep_angle", "overlap",
    "boundary_pass", "entry",   "ramp_angle", "tilt",      "lead",        "lean_from"};

/// How the stage `name` is to be cut. What is left to a default is said in `context`; a key that
/// the strategy does not use is an error: it would change nothing.
StagePlan read_plan(const TomlTable& stage, const std::string& name, JobContext& context);

/// The [[setup]]s: how the part lies in each, and its work offsets; after [machine] was read.
/// Without any, one in which it is not turned. Throws InputError for one that is no rotation, for a
/// second one of a name, and for what says the same otherwise ([program_frame], [tolerances]).
void read_setups(const TomlTable& root, Job& job);
/// `work_offsets` of a table, "[machine]" or a setup.
void read_offsets(const TomlTable& table, model::MachineSetup& machine);
/// Which setup `setup` of a stage or a fixture names; the first where the job states none, and none
/// where it states some and the table says nothing.
std::optional<std::size_t> read_setup_name(const TomlTable& table,
                                           const std::vector<JobSetup>& setups);

/// The fixtures of `[[fixture]]`: name, file, translate, setup, axis. Throws InputError for a file
/// that is not there and for a second fixture of one name.
void read_fixtures(const TomlTable& root, Job& job, const JobContext& context);
/// Throws InputError where a body goes with the spindle and the length of a stage's tool, which
/// says where that is, is not stated. To be asked when the stages were read.
void require_tool_lengths(const TomlTable& root, const Job& job);
/// `travel = { x = [low, high], ... }` of [machine]: an axis that is not named has no limit.
model::Box3 read_travel(const TomlTable& machine);

/// [machine]: rates and clearance. What is left to a default is said in `context`.
void read_machine(const TomlTable& root, Job& job, JobContext& context);
/// `kinematics`, `axis` and `tool_centred` of [machine]: its rotary axes. Throws InputError for
/// axes that are none, or not as many as the machine has.
void read_kinematics(const TomlTable& machine, Job& job);
/// [post]: how programs of planned stages are written. To be read after the stages: without a
/// planned one, no default is worth saying.
void read_post(const TomlTable& root, Job& job, JobContext& context);

/// What programs take from the machine and where they lie: `work_offsets`, `home` and `second_home`
/// of [machine], [program_frame], and the tools that have numbers.
void read_program_machine(const TomlTable& root, const TomlTable& machine, Job& job);
/// The tools that have a number, as the machine's tool table.
std::vector<model::ToolEntry> tool_table(const std::vector<JobTool>& tools);

}  // namespace limitgauge::app
