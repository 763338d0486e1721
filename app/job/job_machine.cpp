#include "app/job/job_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "app/tolerance.h"
#include "model/base/text_file.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

/// The table `key` of the job, or an empty one.
const toml::table& table_or_none(const TomlTable& root, const char* key) {
  static const toml::table none;
  return root.has(key) ? root.table(key) : none;
}

double acceleration_of(const TomlTable& machine) {
  machine.positive("acceleration");
  return machine.within("acceleration", kLeastAcceleration_mm_s2, kLargestAcceleration_mm_s2,
                        kAccelerationExpected);
}

void read_acceleration(const TomlTable& machine, Job& job, JobContext& context) {
  if (machine.has("acceleration")) job.acceleration_mm_s2 = acceleration_of(machine);
  if (machine.has("junction_deviation")) {
    if (!job.acceleration_mm_s2)
      throw model::InputError(
          machine.place("junction_deviation"),
          "\"junction_deviation\" without \"acceleration\" would change nothing",
          "both, or neither");
    job.junction_deviation_mm = part_length_mm(machine, "junction_deviation", job.part_lengths);
  } else if (job.acceleration_mm_s2) {
    context.defaulted.push_back("junction deviation " + model::shortest(job.junction_deviation_mm) +
                                " mm (default)");
  }
}

model::Dialect read_dialect(const TomlTable& post) {
  const std::string word = post.one_of("dialect", {"linuxcnc", "fanuc", "grbl"});
  if (word == "fanuc") return model::Dialect::fanuc;
  return word == "grbl" ? model::Dialect::grbl : model::Dialect::linuxcnc;
}

int read_decimals(const TomlTable& post, model::Dialect dialect) {
  const double stated = post.number("decimals");
  const int most = model::rules(dialect).most_decimals;
  if (stated != std::floor(stated) || stated < 0 || stated > most)
    throw model::InputError(post.place("decimals"),
                            "\"decimals\" in [post] is " + model::shortest(stated) +
                                " for dialect " + model::name(dialect),
                            "a whole number from 0 to " + std::to_string(most));
  return static_cast<int>(stated);
}

/// Of keys that add something, leaving them out leaves it out: nothing is chosen.
void say_defaults(const TomlTable& post, const Job& job, JobContext& context) {
  std::string said;
  const auto say = [&](const char* key, const std::string& value) {
    if (post.has(key)) return;
    said += std::string(said.empty() ? " " : ", ") + key + " = " + value;
  };
  say("dialect", model::name(job.post.dialect));
  say("decimals", std::to_string(job.post.decimals));
  if (!said.empty()) context.defaulted.push_back("programs: defaults:" + said);
}

}  // namespace

namespace {

void read_control(const TomlTable& machine, Job& job, const JobContext& context) {
  if (machine.has("control")) {
    const std::string name =
        machine.one_of("control", {"linuxcnc", "fanuc", "haas", "mach3", "grbl", "siemens"});
    job.machine.control = *model::control_named(name);
    job.machine.control_is_stated = true;
  }
  if (!machine.has("subprograms")) return;
  const std::string folder = machine.text("subprograms");
  job.machine.subprograms = context.folder / folder;
  std::error_code failure;
  if (!std::filesystem::is_directory(job.machine.subprograms, failure))
    throw model::InputError(machine.place("subprograms"), "no folder \"" + folder + "\"",
                            "a folder with a file for each subprogram");
}

}  // namespace

void read_machine(const TomlTable& root, Job& job, JobContext& context) {
  const TomlTable machine(
      table_or_none(root, "machine"), "[machine]",
      {"rapid", "clearance", "acceleration", "junction_deviation", "travel", "work_offsets", "home",
       "second_home", "start", "control", "subprograms", "kinematics", "axis", "tool_centred"});
  if (machine.has("rapid")) {
    job.rapid_mm_min = machine.rate_mm_min("rapid");
  } else {
    context.defaulted.push_back("rapid rate " + model::shortest(job.rapid_mm_min) +
                                " mm/min (default)");
  }
  read_acceleration(machine, job, context);
  if (machine.has("travel")) job.travel_mm = read_travel(machine);
  read_program_machine(root, machine, job);
  read_control(machine, job, context);
  read_kinematics(machine, job);
  if (machine.has("clearance")) {
    job.clearance_mm = machine.length_mm("clearance");
  } else {
    context.defaulted.push_back("clearance of rapids above the stock " +
                                model::shortest(job.clearance_mm) + " mm (default)");
  }
}

void read_post(const TomlTable& root, Job& job, JobContext& context) {
  const TomlTable post(table_or_none(root, "post"), "[post]",
                       {"dialect", "decimals", "arcs", "line_numbers", "cl_data"});
  if (post.has("dialect")) job.post.dialect = read_dialect(post);
  job.post.decimals = post.has("decimals") ? read_decimals(post, job.post.dialect)
                                           : model::rules(job.post.dialect).default_decimals;
  if (post.has("arcs")) job.post.arc_tolerance_mm = part_length_mm(post, "arcs", job.part_lengths);
  if (post.has("line_numbers")) job.post.line_numbers = post.boolean("line_numbers");
  if (post.has("cl_data")) job.post.cl_data = post.boolean("cl_data");
  const auto planned = [](const JobStage& stage) { return stage.plan.has_value(); };
  if (std::any_of(job.stages.begin(), job.stages.end(), planned)) say_defaults(post, job, context);
}

namespace {

constexpr const char* kNames[] = {"G54", "G55",   "G56",   "G57",  "G58",
                                  "G59", "G59.1", "G59.2", "G59.3"};
static_assert(std::size(kNames) == model::kWorkOffsets);

/// `G54 = [x, y, z]` or `"G59.1" = { origin = [x, y, z], rotate_z = a }`.
model::WorkOffset read_offset(const TomlTable& offsets, const std::string& key) {
  if (!offsets.is_table(key)) return {offsets.position(key), 0};
  const TomlTable turned(offsets.table(key), key + " of [machine]", {"origin", "rotate_z"});
  return {turned.position("origin"), turned.has("rotate_z") ? turned.angle_deg("rotate_z") : 0};
}

/// `G54.1P1` to `G54.1P300`, of Fanuc and Haas.
std::string extended_name(int number) {
  return "G54.1P" + std::to_string(number);
}

}  // namespace

void read_offsets(const TomlTable& table, model::MachineSetup& machine) {
  constexpr int kMostExtended = 300;
  std::vector<std::string> extended;
  for (int number = 1; number <= kMostExtended; ++number) extended.push_back(extended_name(number));
  std::vector<const char*> names(std::begin(kNames), std::end(kNames));
  for (const std::string& name : extended) names.push_back(name.c_str());
  const TomlTable offsets(table.table("work_offsets"), "\"work_offsets\" of " + table.where(), {},
                          names);
  for (std::size_t i = 0; i < std::size(kNames); ++i)
    if (offsets.has(kNames[i])) machine.work_offsets[i] = read_offset(offsets, kNames[i]);
  for (int number = 1; number <= kMostExtended; ++number) {
    const std::string name = extended_name(number);
    if (offsets.has(name)) machine.extended_offsets[number] = read_offset(offsets, name);
  }
}

void read_program_machine(const TomlTable& root, const TomlTable& machine, Job& job) {
  if (machine.has("work_offsets")) read_offsets(machine, job.machine);
  if (machine.has("home")) job.machine.home_mm = machine.position("home");
  if (machine.has("second_home")) job.machine.second_home_mm = machine.position("second_home");
  if (machine.has("start")) job.machine.start_mm = machine.position("start");
  if (!root.has("program_frame")) return;
  const TomlTable frame(root.table("program_frame"), "[program_frame]", {"offset", "rotate_z"});
  if (frame.has("offset")) job.program_frame.translate_mm = frame.position("offset");
  if (frame.has("rotate_z")) job.program_frame.rotate_z_deg = frame.angle_deg("rotate_z");
}

std::vector<model::ToolEntry> tool_table(const std::vector<JobTool>& tools) {
  std::vector<model::ToolEntry> entries;
  for (const JobTool& tool : tools)
    if (tool.number) entries.push_back({*tool.number, tool.length_mm, tool.cutter.diameter_mm});
  return entries;
}

namespace {

/// What a body is mounted on: a rotary axis, the spindle, or nothing that moves.
FixtureMount read_mount(const TomlTable& fixture, const Job& job) {
  if (!fixture.has("axis")) return {};
  const std::string word = fixture.text("axis");
  if (word == "spindle") return {FixtureMount::Kind::spindle, std::nullopt};
  if (!job.machine.kinematics)
    throw model::InputError(fixture.place("axis"),
                            "\"axis\" of a fixture, and the machine has no rotary axes",
                            "[machine] kinematics, \"spindle\", or a fixture without \"axis\"");
  if (word == "none") return {FixtureMount::Kind::machine, std::nullopt};
  const auto& axes = job.machine.kinematics->axes;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (word == std::string(1, axes[i].word))
      return {
          job.machine.kinematics->is_head(i) ? FixtureMount::Kind::head : FixtureMount::Kind::axis,
          axes[i].word};
  throw model::InputError(fixture.place("axis"), "\"" + word + "\" is no axis of the machine",
                          "the word of a [[machine.axis]], \"spindle\" or \"none\"");
}

JobFixture read_fixture(const toml::table& table, const Job& job, const JobContext& context) {
  const TomlTable fixture(table, "[[fixture]]", {"name", "file", "translate", "setup", "axis"});
  JobFixture read;
  read.name = fixture.text("name");
  read.file_as_stated = fixture.text("file");
  read.file = context.folder / read.file_as_stated;
  if (!model::is_file(read.file)) {
    throw model::InputError(fixture.place("file"), "no file \"" + read.file_as_stated + "\"",
                            "a closed mesh as STL, OBJ or PLY");
  }
  if (fixture.has("translate")) read.translate_mm = fixture.position("translate");
  read.setup = read_setup_name(fixture, job.setups);
  read.mount = read_mount(fixture, job);
  return read;
}

}  // namespace

void read_fixtures(const TomlTable& root, Job& job, const JobContext& context) {
  if (!root.has("fixture")) return;
  for (const toml::table* table : root.tables("fixture")) {
    JobFixture fixture = read_fixture(*table, job, context);
    for (const JobFixture& other : job.fixtures) {
      if (other.name != fixture.name) continue;
      throw model::InputError(place_of(table->get("name")->source()),
                              "a second fixture \"" + fixture.name + "\"", "names that differ");
    }
    job.fixtures.push_back(std::move(fixture));
  }
}

void require_tool_lengths(const TomlTable& root, const Job& job) {
  const auto with_tool = [](const JobFixture& f) { return f.mount.with_tool(); };
  const auto carried = std::ranges::find_if(job.fixtures, with_tool);
  if (carried == job.fixtures.end()) return;
  const std::vector<const toml::table*> stages = root.tables("stage");
  for (std::size_t i = 0; i < job.stages.size(); ++i) {
    if (job.stages[i].tool_length_mm) continue;
    throw model::InputError(place_of(stages[i]->get("tool")->source()),
                            "fixture \"" + carried->name +
                                "\" goes with the spindle, and where that is above the tip of \"" +
                                job.stages[i].cutter.id + "\" is not stated",
                            "\"number\" and \"length\" of the tool");
  }
}

model::Box3 read_travel(const TomlTable& machine) {
  constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  const TomlTable travel(machine.table("travel"), "\"travel\" of [machine]", {"x", "y", "z"});
  model::Box3 box{{-kNoLimit, -kNoLimit, -kNoLimit}, {kNoLimit, kNoLimit, kNoLimit}};
  constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    if (!travel.has(kAxes[axis])) continue;
    const auto [low, high] = travel.ascending_pair(kAxes[axis]);
    if (std::max(std::abs(low), std::abs(high)) > kFarthestTravelMm)
      throw model::InputError(travel.place(kAxes[axis]),
                              std::string("\"") + kAxes[axis] + "\" in " + travel.where() +
                                  " goes from " + model::six_digits(low) + " to " +
                                  model::six_digits(high) + " mm",
                              kTravelExpected);
    box.low[axis] = low, box.high[axis] = high;
  }
  return box;
}

}  // namespace limitgauge::app
