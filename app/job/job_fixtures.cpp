#include "app/job/job_parts.h"

#include <array>
#include <limits>

#include "model/base/text_file.h"

namespace limitgauge::app {
namespace {

JobFixture read_fixture(const toml::table& table, const JobContext& context) {
  const TomlTable fixture(table, "[[fixture]]", {"name", "file", "translate"});
  JobFixture read;
  read.name = fixture.text("name");
  read.file_as_stated = fixture.text("file");
  read.file = context.folder / read.file_as_stated;
  if (!model::is_file(read.file)) {
    throw model::InputError(fixture.place("file"), "no file \"" + read.file_as_stated + "\"",
                            "a closed mesh as STL, OBJ or PLY");
  }
  if (fixture.has("translate")) read.translate_mm = fixture.position("translate");
  return read;
}

}  // namespace

void read_fixtures(const TomlTable& root, Job& job, const JobContext& context) {
  if (!root.has("fixture")) return;
  for (const toml::table* table : root.tables("fixture")) {
    JobFixture fixture = read_fixture(*table, context);
    for (const JobFixture& other : job.fixtures) {
      if (other.name != fixture.name) continue;
      throw model::InputError(place_of(table->get("name")->source()),
                              "a second fixture \"" + fixture.name + "\"", "names that differ");
    }
    job.fixtures.push_back(std::move(fixture));
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
    box.low[axis] = low, box.high[axis] = high;
  }
  return box;
}

}  // namespace limitgauge::app
