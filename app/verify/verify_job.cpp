#include "app/verify/verify_job.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "app/cli/usage_error.h"
#include "app/inputs/stock_file.h"
#include "app/job/foreign_programs.h"
#include "app/job/job_parts.h"
#include "app/job/job_reader.h"
#include "app/job/program_parts.h"
#include "app/run/gate_limits.h"
#include "app/verify/tolerance_option.h"
#include "model/base/absolute_path.h"
#include "model/base/error.h"
#include "model/base/text_file.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

/// The argument of an option as the file in its errors.
template <class Parse>
auto parse_option(const std::string& option, const std::string& text, const Parse& parse) {
  try {
    return parse(text);
  } catch (const model::InputError& error) {
    const int column = error.place().column;
    throw UsageError(option + " " + text +
                     (column > 0 ? " (column " + std::to_string(column) + ")" : std::string()) +
                     ": " + error.what());
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + " " + text + ": " + error.what());
  }
}

/// `box:...`, `mesh:FILE` or `vdb:FILE`.
model::Stock stock_of(const std::string& text, Job& job) {
  for (const std::string kind : {"mesh:", "vdb:"}) {
    if (text.rfind(kind, 0) != 0) continue;
    const std::string file = text.substr(kind.size());
    StockFile loaded =
        kind == "mesh:" ? load_mesh_stock(file, file, {}) : load_vdb_stock(file, file);
    for (std::string& said : loaded.assumptions) job.defaulted.push_back(std::move(said));
    job.sources.push_back({JobFile::Role::stock, file, file});
    return std::move(loaded.stock);
  }
  return parse_option("--stock", text, [](const std::string& spec) {
    model::Stock stock = model::parse_stock(spec);
    require_valid(stock);
    return stock;
  });
}

/// `SPEC` or `N=SPEC`: a specification begins with a letter.
JobTool tool_of(const std::string& text) {
  JobTool tool;
  const std::size_t digits = text.find_first_not_of("0123456789");
  const bool numbered = digits != 0 && digits < text.size() && text[digits] == '=';
  if (numbered && digits > 5)
    throw UsageError("--tool " + text + ": no tool has such a number; expected 1 to 99999");
  if (numbered) tool.number = std::stoi(text.substr(0, digits));
  tool.cutter = parse_option("--tool", numbered ? text.substr(digits + 1) : text,
                             [](const std::string& spec) {
                               model::Cutter cutter = model::parse_cutter(spec);
                               require_valid(cutter);
                               if (cutter.id.empty()) cutter.id = spec;
                               return cutter;
                             });
  return tool;
}

std::vector<JobTool> tools_of(const CutCommand& command) {
  std::vector<JobTool> tools;
  for (const std::string& text : command.tools) {
    JobTool tool = tool_of(text);
    for (const JobTool& before : tools)
      if (!tool.number || !before.number || *tool.number == *before.number)
        throw UsageError("--tool " + text + ": several tools need numbers that differ; expected " +
                         "N=SPEC for each");
    tools.push_back(std::move(tool));
  }
  return tools;
}

/// Two cutters of one shape are each off by figures of their own.
void tell_apart(std::vector<JobTool>& tools) {
  const std::vector<JobTool> stated = tools;
  for (JobTool& tool : tools) {
    const auto same = std::count_if(stated.begin(), stated.end(), [&](const JobTool& other) {
      return other.cutter.id == tool.cutter.id;
    });
    if (same > 1) tool.cutter.id = std::to_string(*tool.number) + "=" + tool.cutter.id;
  }
}

/// Diameters are the cutters' where the tool table states none; lengths come from the table, where
/// there is one.
void add_tools(const std::vector<JobTool>& tools, Job& job) {
  model::MachineSetup& machine = job.machine;
  for (const JobTool& tool : tools) {
    if (!tool.number) continue;
    const auto known =
        std::find_if(machine.tools.begin(), machine.tools.end(),
                     [&](const model::ToolEntry& entry) { return entry.number == *tool.number; });
    if (known == machine.tools.end()) {
      machine.tools.push_back({*tool.number, std::nullopt, tool.cutter.diameter_mm});
    } else if (!known->diameter_mm) {
      known->diameter_mm = tool.cutter.diameter_mm;
    } else if (*known->diameter_mm != tool.cutter.diameter_mm) {
      job.defaulted.push_back("the tool table has T" + std::to_string(*tool.number) + " " +
                              model::shortest(*known->diameter_mm) +
                              " mm wide, which cutter compensation takes; what cuts is " +
                              model::shortest(tool.cutter.diameter_mm) + " mm wide");
    }
  }
}

/// A name for folders out of a file name: what is not plain becomes '_'.
std::string plain_name(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  for (char& c : name) {
    if (!is_plain_name(std::string("a") + c)) c = '_';
  }
  return is_plain_name(name) ? name : "program";
}

JobFixture fixture_of(const std::filesystem::path& file) {
  if (!model::is_file(file))
    throw UsageError("--fixture " + file.string() + ": no such file; expected STL, OBJ or PLY");
  return {file.filename().string(), file, file.string(), {}};
}

/// What options state of the part, for what its extent says of them.
std::vector<PartLength> part_lengths_of(const VerifyCommand& command) {
  const verifier::GateLimits& limits = command.limits;
  std::vector<PartLength> lengths = {{"--allowance", command.allowance_mm, {}}};
  if (limits.has_gouge) lengths.push_back({"--gouge", limits.gouge_mm, {}});
  if (limits.has_uncut) lengths.push_back({"--uncut", limits.uncut_mm, {}});
  if (limits.has_unavoidable) lengths.push_back({"--unavoidable", limits.unavoidable_mm, {}});
  return lengths;
}

JobStage stage_of(const CutCommand& command, const JobTool& tool) {
  JobStage stage;
  stage.name = "program";
  stage.cutter = tool.cutter;
  stage.tool_number = tool.number;
  stage.program = command.program;
  stage.program_as_stated = command.program.string();
  return stage;
}

const JobTool& tool_numbered(const std::vector<JobTool>& tools, const model::ToolChange& change,
                             const std::filesystem::path& program) {
  for (const JobTool& tool : tools)
    if (tool.number == change.tool) return tool;
  throw model::InputError({program.string(), static_cast<int>(change.line), 0},
                          "T" + std::to_string(change.tool) + " is loaded, which no --tool states",
                          "--tool " + std::to_string(change.tool) + "=SPEC");
}

/// A stage for each loading of a tool. What the earlier ones leave is the later ones' work, so the
/// limits hold for the last, which measures everything that was cut.
std::vector<JobStage> stages_by_tool(const CutCommand& command, const Job& job,
                                     const std::vector<JobTool>& tools) {
  const model::Program program =
      model::read_program_or_name_control(command.program, machine_for(job, tools.front().cutter));
  std::vector<JobStage> stages;
  for (const model::ToolChange& change : loadings(program)) {
    JobStage stage = stage_of(command, tool_numbered(tools, change, command.program));
    stage.part.section = static_cast<int>(stages.size()) + 1;
    stage.name = "T" + std::to_string(change.tool);
    const auto times = std::count_if(stages.begin(), stages.end(), [&](const JobStage& before) {
      return before.tool_number == change.tool;
    });
    if (times > 0) stage.name += "-" + std::to_string(times + 1);
    stages.push_back(std::move(stage));
  }
  if (stages.empty())
    throw model::InputError({command.program.string(), 0, 0}, "the program loads no tool",
                            "one --tool without a number");
  return stages;
}

/// Of several tools, those that the program loads nowhere.
void say_idle_tools(const std::vector<JobTool>& tools, Job& job) {
  if (tools.size() == 1) return;
  for (const JobTool& tool : tools)
    if (std::none_of(job.stages.begin(), job.stages.end(),
                     [&](const JobStage& stage) { return stage.tool_number == tool.number; }))
      job.defaulted.push_back("T" + std::to_string(*tool.number) +
                              ", which --tool states, is loaded nowhere: nothing is cut with it");
}

/// The name of a file's format where it is one that holds no cage.
const char* other_than_cage(const std::filesystem::path& file) {
  const std::string extension = model::lower_extension(file);
  if (extension == ".stl") return "STL: triangles";
  if (extension == ".ply") return "PLY: a mesh of facets";
  return extension == ".step" || extension == ".stp" ? "STEP: faces and curves" : nullptr;
}

/// A mesh is the design itself, a cage its control polygon: taken for each other, every figure
/// would be of another part.
void require_cage(const std::filesystem::path& file) {
  const char* format = other_than_cage(file);
  if (!format) return;
  throw UsageError("--cage " + file.string() + " is " + format +
                   ", and --cage takes the control cage of a Catmull-Clark surface; expected an "
                   "OBJ with quads or n-gons; a mesh goes to --target; without a design "
                   "`limitgauge cut` with the same --stock, --tool and "
                   "--program says what happens on the way and shows what is left");
}

JobDesign design_of(const VerifyCommand& command) {
  if (command.cage.empty() == command.target.empty())
    throw UsageError(command.cage.empty()
                         ? "verify needs a design; expected --cage (a Catmull-Clark cage) or "
                           "--target (a triangle mesh); without one, limitgauge cut"
                         : "--cage beside --target; expected one of the two");
  if (command.target.empty()) require_cage(command.cage);
  const bool is_mesh = command.cage.empty();
  JobDesign design;
  design.kind = is_mesh ? DesignKind::mesh : DesignKind::cage;
  design.file = is_mesh ? command.target : command.cage;
  design.as_stated = design.file.string();
  return design;
}

}  // namespace

Job job_of(const VerifyCommand& command) {
  JobDesign design = design_of(command);
  Job job = job_of(static_cast<const CutCommand&>(command));
  job.design = std::move(design);
  job.part_lengths = part_lengths_of(command);
  for (JobStage& stage : job.stages) stage.allowance_mm = command.allowance_mm;
  job.stages.back().limits = command.limits;
  return job;
}

Job job_of(const CutCommand& command) {
  Job job;
  job.name = plain_name(command.program);
  job.voxel_mm = command.voxel_mm;
  if (command.voxel_mm) job.stated_voxel = {"--voxel", *command.voxel_mm, {}};
  job.stock = stock_of(command.stock, job);
  job.near_miss_mm = command.near_miss_mm;
  for (const std::filesystem::path& file : command.fixtures)
    job.fixtures.push_back(fixture_of(file));
  std::vector<JobTool> tools = tools_of(command);
  if (!command.tolerances.empty()) {
    tell_apart(tools);
    job.tolerances = tolerances_of(command.tolerances, tools);
  }
  job.machine = machine_of(command.machine);
  if (const std::filesystem::path& table = command.machine.tool_table; !table.empty())
    job.sources.push_back({JobFile::Role::tool_table, table, table.string()});
  add_tools(tools, job);
  if (!command.program_offset.empty())
    job.program_frame.translate_mm = point_of("--program-offset", command.program_offset);
  job.program_frame.rotate_z_deg = command.program_rotation_deg;
  job.stages = tools.size() == 1 ? std::vector{stage_of(command, tools.front())}
                                 : stages_by_tool(command, job, tools);
  say_idle_tools(tools, job);
  return job;
}

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
  for (const JobStage& stage : job.stages) {
    toml::table keys{{"name", stage.name}};
    if (job.design) {
      keys.insert("allowance", stage.allowance_mm);
      keys.insert("gate", gate_table(stage.limits));
    }
    stages.push_back(std::move(keys));
  }
  return toml::table{{"name", job.name}, {"stage", std::move(stages)}};
}

/// A key that is no key of a job is told by the table's own reader.
void refuse_options(const TomlTable& table, const std::string& command, const std::string& where,
                    std::span<const std::pair<const char*, const char*>> options) {
  for (const auto& [key, option] : options)
    if (table.has(key))
      throw model::InputError(table.place(key),
                              command + " takes \"" + key + "\" of " + where + " from its options",
                              option);
}

constexpr std::pair<const char*, const char*> kJobOptions[] = {
    {"stock", "--stock"},
    {"tool", "--tool"},
    {"fixture", "--fixture"},
    {"post", "none: no program is written"},
    {"published", "none: such figures stand in a job file"}};
constexpr std::pair<const char*, const char*> kSurfaceOptions[] = {{"cage", "--cage"},
                                                                   {"mesh", "--target"}};
constexpr std::pair<const char*, const char*> kStageOptions[] = {{"tool", "--tool"},
                                                                 {"program", "--program"}};

void read_surface(const TomlTable& root, Job& job) {
  const TomlTable surface(root.table("surface"), "[surface]",
                          {"cage", "mesh", "precision", "transform"});
  if (!job.design)
    throw model::InputError(root.place("surface"), "cut measures against no surface",
                            "limitgauge verify, with --cage or --target");
  refuse_options(surface, "verify", "[surface]", kSurfaceOptions);
  if (surface.has("precision"))
    job.design->precision_mm = part_length_mm(surface, "precision", job.part_lengths);
  read_placement(surface, *job.design);
}

void read_stage(const toml::table& table, const std::string& command, bool has_design,
                JobStage& stage, std::vector<PartLength>& lengths) {
  const TomlTable keys(table, "[[stage]] of " + command,
                       {"name", "allowance", "gate", "tool", "program"});
  refuse_options(keys, command, "[[stage]]", kStageOptions);
  if (keys.text("name") != stage.name)
    throw model::InputError(keys.place("name"), command + " names its stages itself",
                            "other keys of the stage \"" + stage.name + "\"");
  if (!has_design) return;
  stage.allowance_mm = part_length_or_zero_mm(keys, "allowance", lengths);
  stage.limits = read_gate(keys, lengths);
}

}  // namespace

void apply_verify_overrides(Job& job, std::span<const std::string> overrides) {
  if (overrides.empty()) return;
  job.overrides.assign(overrides.begin(), overrides.end());
  toml::table table = nameable(job);
  apply_overrides(table, overrides);
  const TomlTable root(table, "the job", {}, kJobKeys);
  const std::string command = job.design ? "verify" : "cut";
  refuse_options(root, command, "the job", kJobOptions);
  if (!job.design) refuse_design_keys(root);
  job.name = read_job_name(root);
  job.part_lengths.clear();  // all of them stand in the table, too
  if (root.has("surface")) read_surface(root, job);
  JobContext context;  // what it gathers of defaults concerns job files
  if (root.has("machine") || root.has("program_frame")) read_machine(root, job, context);
  read_settings(root, job);
  std::vector<model::Cutter> cutters;
  for (const JobStage& stage : job.stages) cutters.push_back(stage.cutter);
  read_tolerances(root, cutters, job);
  const std::vector<const toml::table*> stages = root.tables("stage");
  for (std::size_t i = 0; i < stages.size(); ++i)
    read_stage(*stages[i], command, job.design.has_value(), job.stages.at(i), job.part_lengths);
}

}  // namespace limitgauge::app
