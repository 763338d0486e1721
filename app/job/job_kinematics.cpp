#include <algorithm>
#include <cmath>

#include "app/job/job_parts.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

constexpr const char* kAxisExpected =
    "[[machine.axis]] with word, direction, point and limits, one or two of them";

model::MachineKind read_kind(const TomlTable& machine) {
  const std::string word = machine.one_of("kinematics", {"table-table", "head-table", "head-head"});
  if (word == "table-table") return model::MachineKind::table_table;
  return word == "head-table" ? model::MachineKind::head_table : model::MachineKind::head_head;
}

model::RotaryAxis read_axis(const toml::table& table) {
  const TomlTable axis(table, "[[machine.axis]]", {"word", "direction", "point", "limits"});
  model::RotaryAxis read;
  read.word = axis.one_of("word", {"A", "B", "C"}).front();
  const model::Vec3 direction = axis.vec3("direction");
  const double size = length(direction);
  if (!(size > 0) || !std::isfinite(size))
    throw model::InputError(axis.place("direction"), "\"direction\" of an axis has no length",
                            "the direction that the axis turns about, right-handed");
  read.direction = direction / size;
  read.point_mm = axis.position("point");
  const auto [low, high] = axis.ascending_pair("limits");
  constexpr double kMost_deg = 1e6;
  if (!(std::max(std::abs(low), std::abs(high)) <= kMost_deg))
    throw model::InputError(axis.place("limits"),
                            "\"limits\" of an axis from " + model::six_digits(low) + " to " +
                                model::six_digits(high) + " degrees",
                            "at most a million degrees either way");
  read.low_deg = low, read.high_deg = high;
  if (low > 0 || high < 0)
    throw model::InputError(axis.place("limits"), "\"limits\" of an axis leave out 0",
                            "a range with 0 in it: rotary axes stand there at the start");
  return read;
}

std::vector<model::RotaryAxis> read_axes(const TomlTable& machine) {
  std::vector<model::RotaryAxis> axes;
  for (const toml::table* table : machine.tables("axis")) {
    axes.push_back(read_axis(*table));
    for (std::size_t i = 0; i + 1 < axes.size(); ++i)
      if (axes[i].word == axes.back().word)
        throw model::InputError(place_of(table->source()),
                                std::string("a second axis ") + axes.back().word,
                                "words that differ");
  }
  return axes;
}

void check_count(const TomlTable& machine, const model::Kinematics& kinematics) {
  const std::size_t least = kinematics.kind == model::MachineKind::head_table ? 2 : 1;
  if (kinematics.axes.size() >= least && kinematics.axes.size() <= 2) return;
  throw model::InputError(machine.place("axis"),
                          std::to_string(kinematics.axes.size()) + " axes of a " +
                              model::name(kinematics.kind) + " machine",
                          least == 2 ? "two [[machine.axis]], the head's first" : kAxisExpected);
}

}  // namespace

void read_kinematics(const TomlTable& machine, Job& job) {
  if (!machine.has("kinematics")) {
    for (const char* key : {"axis", "tool_centred"})
      if (machine.has(key))
        throw model::InputError(machine.place(key),
                                "\"" + std::string(key) + "\" of [machine] without \"kinematics\"",
                                "kinematics = \"table-table\", \"head-table\" or \"head-head\"");
    return;
  }
  model::Kinematics kinematics;
  kinematics.kind = read_kind(machine);
  if (!machine.has("axis"))
    throw model::InputError(machine.place("kinematics"), "\"kinematics\" without its axes",
                            kAxisExpected);
  kinematics.axes = read_axes(machine);
  check_count(machine, kinematics);
  job.machine.kinematics = std::move(kinematics);
  if (machine.has("tool_centred"))
    job.machine.starts_tool_centred = machine.boolean("tool_centred");
}

}  // namespace limitgauge::app
