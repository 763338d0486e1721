#include "app/job/job_parts.h"

#include <algorithm>
#include <stdexcept>

#include "app/job/job_reader.h"
#include "model/text/message_text.h"

namespace limitgauge::app {
namespace {

/// Rows that are typed by hand have as many digits as somebody typed.
constexpr double kTypedRotation = 1e-6;

constexpr const char* kTurnExpected =
    "rotate = [{ axis = [1, 0, 0], angle = 180 }], flip = \"x\" or \"y\", or matrix = [[..], [..], "
    "[..]] with the rows of a rotation";

model::Pose read_turns(const TomlTable& setup) {
  model::Pose pose;
  for (const toml::table* table : setup.tables("rotate")) {
    const TomlTable turn(*table, "\"rotate\" of " + setup.where(), {"axis", "angle"});
    try {
      pose = model::turn_about(turn.vec3("axis"), turn.angle_deg("angle")) * pose;
    } catch (const std::invalid_argument& error) {
      throw model::InputError(turn.place("axis"), error.what(), kTurnExpected);
    }
  }
  return pose;
}

model::Pose read_matrix(const TomlTable& setup) {
  const auto rows = setup.vec3_rows("matrix");
  try {
    return model::rotation_of(rows, kTypedRotation);
  } catch (const std::invalid_argument& error) {
    throw model::InputError(setup.place("matrix"),
                            "\"matrix\" in " + setup.where() + ": " + error.what(), kTurnExpected);
  }
}

model::Pose read_rotation(const TomlTable& setup) {
  const char* stated = nullptr;
  for (const char* key : {"rotate", "flip", "matrix"}) {
    if (!setup.has(key)) continue;
    if (stated != nullptr)
      throw model::InputError(setup.place(key),
                              "\"" + std::string(key) + "\" beside \"" + stated + "\"",
                              "one of them");
    stated = key;
  }
  if (setup.has("rotate")) return read_turns(setup);
  if (setup.has("matrix")) return read_matrix(setup);
  if (!setup.has("flip")) return {};
  constexpr double kOver_deg = 180;
  const bool about_x = setup.one_of("flip", {"x", "y"}) == "x";
  return model::turn_about(about_x ? model::Vec3{1, 0, 0} : model::Vec3{0, 1, 0}, kOver_deg);
}

std::string read_name(const TomlTable& setup, const std::vector<JobSetup>& before) {
  const std::string name = setup.text("name");
  if (!is_plain_name(name))
    throw model::InputError(setup.place("name"), "\"" + name + "\" is no plain name",
                            "letters, digits, '.', '_', '-'");
  for (const JobSetup& other : before)
    if (other.setup.name == name)
      throw model::InputError(setup.place("name"), "a second setup \"" + name + "\"",
                              "names that differ");
  return name;
}

JobSetup read_one_setup(const toml::table& table, const Job& job,
                        const std::vector<JobSetup>& before) {
  const TomlTable setup(table, "[[setup]]",
                        {"name", "rotate", "flip", "matrix", "origin", "work_offsets"});
  JobSetup read;
  read.setup.name = read_name(setup, before);
  read.setup.from_part = read_rotation(setup);
  if (setup.has("origin")) read.setup.from_part.shift_mm = setup.position("origin");
  if (setup.has("work_offsets")) {
    read.machine = job.machine;
    read.machine->work_offsets = {}, read.machine->extended_offsets.clear();
    read_offsets(setup, *read.machine);
  }
  return read;
}

/// A frame has one home, and tolerances are proven where the part is not turned.
void refuse_beside_setups(const TomlTable& root) {
  if (root.has("program_frame"))
    throw model::InputError(root.place("program_frame"),
                            "[program_frame] beside [[setup]]: \"origin\" of a setup says where "
                            "the part lies in its programs' frame",
                            "one of the two");
  if (root.has("tolerances"))
    throw model::InputError(root.place("tolerances"),
                            "[tolerances] beside [[setup]]: figures over tolerances are proven "
                            "for parts that are not turned",
                            "a job without [[setup]], or without [tolerances]");
}

}  // namespace

void read_setups(const TomlTable& root, Job& job) {
  if (!root.has("setup")) return;
  refuse_beside_setups(root);
  std::vector<JobSetup> setups;
  for (const toml::table* table : root.tables("setup"))
    setups.push_back(read_one_setup(*table, job, setups));
  if (!setups.empty()) job.setups = std::move(setups);
}

std::optional<std::size_t> read_setup_name(const TomlTable& table,
                                           const std::vector<JobSetup>& setups) {
  const bool stated = !setups.front().setup.name.empty();
  if (!table.has("setup")) return stated ? std::nullopt : std::optional<std::size_t>(0);
  const std::string name = table.text("setup");
  if (!stated)
    throw model::InputError(table.place("setup"),
                            "\"setup\" in " + table.where() + ", and the job states no setup",
                            "a [[setup]] with name = \"" + name + "\"");
  std::vector<std::string_view> names;
  for (std::size_t k = 0; k < setups.size(); ++k) {
    if (setups[k].setup.name == name) return k;
    names.push_back(setups[k].setup.name);
  }
  throw model::InputError(
      table.place("setup"), "no setup has the name \"" + name + "\"",
      "\"" + model::nearest_word(name, names) + "\" or another name of a [[setup]]");
}

}  // namespace limitgauge::app
