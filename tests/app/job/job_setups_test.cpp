#include <algorithm>
#include <cmath>

#include "app/inputs/setup_view.h"
#include "app/job/settings.h"
#include "model/base/error.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"

namespace limitgauge::app {
namespace {

using model::Vec3;

/// The good job in setups that `tables` state; its stage is cut in `at`.
std::string in_setups(const std::string& tables, const std::string& at = "back") {
  const std::string named =
      with(good_job(), "tool = \"ball3\"\n", "tool = \"ball3\"\nsetup = \"" + at + "\"\n");
  return with(named, "[[tool]]", tables + "\n[[tool]]");
}

std::string back(const std::string& keys) {
  return "[[setup]]\nname = \"back\"\n" + keys;
}

void check_point(const model::Pose& pose, const Vec3& from, const Vec3& to) {
  CHECK(distance(pose.point(from), to) < 1e-12);
}

}  // namespace

TEST_CASE("a setup says how the part lies in the machine", "[unit][job]") {
  const Job job = read(in_setups(
      "[[setup]]\nname = \"front\"\n" +
      back("rotate = [{ axis = [1, 0, 0], angle = 180 }, { axis = [0, 0, 2], angle = 90 }]\n"
           "origin = [1, 2, 10]")));
  REQUIRE(job.setups.size() == 2);
  CHECK(job.setups[0].setup.from_part == model::Pose{});
  CHECK(job.setups[1].setup.name == "back");
  CHECK(job.stages[0].setup == 1);
  // (x, y, z) over X is (x, -y, -z); a quarter about Z makes of that (y, x, -z).
  CHECK(job.setups[1].setup.from_part.point({3, 4, 5}) == Vec3{1 + 4, 2 + 3, 10 - 5});
  CHECK(has_setups(job));
  CHECK_FALSE(has_setups(read(good_job())));
  CHECK(read(good_job()).stages[0].setup == 0);
}

TEST_CASE("a flip and a matrix say the same as a turn", "[unit][job]") {
  const auto pose = [](const std::string& keys) {
    return read(in_setups(back(keys))).setups[0].setup.from_part;
  };
  CHECK(pose("flip = \"x\"") == pose("rotate = [{ axis = [1, 0, 0], angle = 180 }]"));
  CHECK(pose("flip = \"y\"") == pose("rotate = [{ axis = [0, 5, 0], angle = -180 }]"));
  CHECK(pose("matrix = [[1, 0, 0], [0, 0, -1], [0, 1, 0]]") ==
        pose("rotate = [{ axis = [1, 0, 0], angle = 90 }]"));
  // Typed to seven digits, and made a rotation.
  const model::Pose typed = pose("matrix = [[0.8660254, -0.5, 0], [0.5, 0.8660254, 0], [0, 0, 1]]");
  const double half = std::sqrt(3.0) / 2;
  CHECK(std::abs(typed.rows[0].x - half) < 1e-7);
  CHECK(std::abs(length(typed.rows[0]) - 1) < 1e-15);
  check_point(pose("rotate = [{ axis = [0, 0, 1], angle = 30 }]"), {2, 0, 1}, {2 * half, 1, 1});
}

TEST_CASE("the job as a setup has it", "[unit][job]") {
  const Job job = read(in_setups(
      "[[setup]]\nname = \"front\"\n[[fixture]]\nname = \"table\"\nfile = \"findings/plate.obj\"\n"
      "[[fixture]]\nname = \"clamp\"\nfile = \"findings/clamp.obj\"\nsetup = \"front\"\n" +
      back("flip = \"x\"\norigin = [0, 0, 10]\nwork_offsets = { G54 = [1, 2, 3] }")));
  const Job there = in_setup(job, 1);
  const auto block = std::get<model::BoxStock>(there.stock);
  CHECK(block.corner_mm == Vec3{-13, -13, 10 - 5});
  CHECK(block.size_mm == Vec3{26, 26, 9});
  REQUIRE(there.fixtures.size() == 1);
  CHECK(there.fixtures[0].name == "table");
  REQUIRE(there.machine.work_offsets[0]);
  CHECK(there.machine.work_offsets[0]->origin_mm == Vec3{1, 2, 3});
  CHECK(in_setup(job, 0).fixtures.size() == 2);
  CHECK_FALSE(in_setup(job, 0).machine.work_offsets[0]);
}

TEST_CASE("a block that is turned by no quarter leans", "[unit][job]") {
  const Job job =
      read(in_setups(back("rotate = [{ axis = [0, 1, 0], angle = 30 }]\norigin = [0, 0, 1]")));
  const model::Stock there = in_setup(job, 0).stock;
  const auto& block = std::get<model::BoxStock>(std::get<model::LeaningStock>(there).upright);
  CHECK(block.size_mm == Vec3{26, 26, 9});
  model::require_valid(there);
  // Its box: 26 cos 30° + 9 sin 30° wide, and as high as 26 sin 30° + 9 cos 30°.
  const Vec3 size = bounding_box(there).size();
  CHECK(size.x == Approx(13 * std::sqrt(3.0) + 4.5));
  CHECK(size.y == Approx(26));
  CHECK(size.z == Approx(13 + 4.5 * std::sqrt(3.0)));
}

TEST_CASE("what is wrong with a setup is told with its place", "[unit][job]") {
  const auto error = [](const std::string& keys) { return error_of(in_setups(back(keys))); };
  CHECK_THAT(error("flip = \"z\""), Catch::Contains("job.toml:10:8") && Catch::Contains("flip"));
  CHECK_THAT(error("rotate = [{ axis = [0, 0, 0], angle = 10 }]"), Catch::Contains("axis"));
  CHECK_THAT(error("rotate = [{ axis = [0, 0, 1], angle = 9e9 }]"), Catch::Contains("angle"));
  CHECK_THAT(error("matrix = [[1, 0, 0], [0, 1, 0], [0, 0, -1]]"), Catch::Contains("mirror"));
  CHECK_THAT(error("matrix = [[1, 0, 0], [0, 1, 0], [0, 0.5, 1]]"), Catch::Contains("no rotation"));
  CHECK_THAT(error("matrix = [[1, 0, 0], [0, 1, 0]]"), Catch::Contains("has 2 entries"));
  CHECK_THAT(error("flip = \"x\"\nrotate = []"), Catch::Contains("beside"));
  CHECK_THAT(error("turn = 3"), Catch::Contains("\"turn\""));
  CHECK_THAT(error("origin = [0, 0, 1e9]"), Catch::Contains("origin"));
  CHECK_THAT(error("[[setup]]\nname = \"back\""), Catch::Contains("a second setup \"back\""));
  CHECK_THAT(error("[program_frame]\noffset = [1, 2, 3]"), Catch::Contains("[program_frame]"));
  CHECK_THAT(error("[tolerances]\nzero = [0.1, 0.1, 0.1]"), Catch::Contains("[tolerances]"));
}

TEST_CASE("a stage names a setup that there is", "[unit][job]") {
  CHECK_THAT(error_of(in_setups(back(""), "bakc")), Catch::Contains("\"back\""));
  CHECK_THAT(error_of(with(good_job(), "[[tool]]", back("") + "\n[[tool]]")),
             Catch::Contains("stage \"finish\" names no setup"));
  CHECK_THAT(error_of(with(good_job(), "tool = \"ball3\"\n", "tool = \"ball3\"\nsetup = \"a\"\n")),
             Catch::Contains("states no setup"));
}

TEST_CASE("a setup that takes the stock beyond what can be measured is told by its name",
          "[unit][job]") {
  const Job job = read(in_setups(back("origin = [0, 0, 9999]")));
  CHECK_THROWS_WITH(in_setup(job, 0), Catch::Contains("setup \"back\" has the stock reach to z = "
                                                      "10004 mm; expected at most 10000 mm"));
}

TEST_CASE("a bar lies down, or stays one end for end", "[unit][job]") {
  const std::string bar =
      with(in_setups(back("rotate = [{ axis = [0, 1, 0], angle = 90 }]")),
           "shape = \"box\"\nsize = [26, 26, 9]\ncorner = [-13, -13, -4]",
           "shape = \"cylinder\"\ndiameter = 40\nheight = 9\nbase = [0, 0, -4]");
  const Job job = read(bar);
  const model::Stock lying = in_setup(job, 0).stock;
  CHECK(std::holds_alternative<model::CylinderStock>(std::get<model::LeaningStock>(lying).upright));
  CHECK(distance(bounding_box(lying).size(), {9, 40, 40}) < 1e-12);
  const Job over = read(with(bar, "axis = [0, 1, 0], angle = 90", "axis = [0, 1, 0], angle = 180"));
  CHECK(std::get<model::CylinderStock>(in_setup(over, 0).stock).base_mm == Vec3{0, 0, -5});
}

TEST_CASE("finer stages of other setups that were judged are no gouge of a coarser one",
          "[unit][job]") {
  const auto stage = [](const std::string& name, const std::string& setup, double allowance,
                        bool gate) {
    return "[[stage]]\nname = \"" + name + "\"\nsetup = \"" + setup +
           "\"\ntool = \"ball3\"\nstrategy = \"zigzag\"\nstep = 0.1\ntolerance = 0.01\nfeed = "
           "1500\n" +
           "allowance = " + std::to_string(allowance) + "\n" +
           (gate ? "[stage.gate]\ngouge = 0.01\n" : "");
  };
  const std::string text =
      in_setups("[[setup]]\nname = \"front\"\n" + back("flip = \"x\""), "front") +
      stage("kept", "front", 0, false) + stage("coarse", "front", 0.3, true) +
      stage("rough", "back", 0.3, true) + stage("last", "back", 0, true);
  const Job job = read(text);
  // "finish" has a gate, "kept" has none and counts, "coarse" had as much to leave.
  CHECK(finer_stages(job, 3) == std::vector<std::size_t>{0});
  CHECK(finer_stages(job, 4).empty());
  CHECK(finer_stages(job, 2).empty());
  const Settings settings = choose_settings(job, {{-10, -10, -1}, {10, 10, 4}}, kMemory);
  const auto said = assumptions(job, settings);
  CHECK(std::count_if(said.begin(), said.end(), [](const std::string& line) {
          return line.find("stage rough: no gouge of it") == 0 &&
                 line.find("judged: finish") != std::string::npos;
        }) == 1);
}

}  // namespace limitgauge::app
