#include <fstream>

#include "app/inputs/setup_view.h"
#include "app/job/job_reader.h"
#include "app/job/oriented_job.h"
#include "app/job/setup_frame.h"
#include "model/base/error.h"
#include "model/base/text_file.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

using model::Vec3;

const std::string kAxes =
    "[[machine.axis]]\nword = \"A\"\ndirection = [2, 0, 0]\npoint = [3, -7, -60]\nlimits = [-120, "
    "30]\n[[machine.axis]]\nword = \"C\"\ndirection = [0, 0, 1]\npoint = [5, 2, -30]\nlimits = "
    "[-360, 360]\n";

/// The good job on a machine with these keys and axes.
std::string on_machine(const std::string& keys, const std::string& axes = kAxes) {
  return good_job() + "[machine]\n" + keys + "\n" + axes;
}

Job fixture_job(const std::string& name) {
  return read_job(tests::fixtures() / "rotary" / (name + ".toml"));
}

}  // namespace

TEST_CASE("a job states the rotary axes of its machine", "[unit][job]") {
  const Job job = read(on_machine("kinematics = \"table-table\""));
  REQUIRE(job.machine.kinematics.has_value());
  const model::Kinematics& machine = *job.machine.kinematics;
  CHECK(machine.kind == model::MachineKind::table_table);
  REQUIRE(machine.axes.size() == 2);
  CHECK(machine.axes[0].word == 'A');
  CHECK(machine.axes[0].direction == Vec3{1, 0, 0});
  CHECK(machine.axes[0].point_mm == Vec3{3, -7, -60});
  CHECK(machine.axes[0].low_deg == -120);
  CHECK(machine.axes[0].high_deg == 30);
  CHECK_FALSE(job.machine.starts_tool_centred.has_value());
  CHECK(read(on_machine("kinematics = \"table-table\"\ntool_centred = true"))
            .machine.starts_tool_centred == true);
  CHECK_FALSE(read(good_job()).machine.kinematics.has_value());
}

TEST_CASE("axes that make no machine are errors at their key", "[unit][job]") {
  const auto message = [](const std::string& text) { return error_of(text); };
  using Catch::Contains;
  CHECK_THAT(message(on_machine("")), Contains("\"axis\" of [machine] without \"kinematics\""));
  CHECK_THAT(message(on_machine("kinematics = \"table-table\"", "")),
             Contains("\"kinematics\" without its axes"));
  CHECK_THAT(message(on_machine("kinematics = \"tables\"")), Contains("table-table"));
  const std::string one = kAxes.substr(0, kAxes.rfind("[[machine.axis]]"));
  CHECK_THAT(message(on_machine("kinematics = \"head-table\"", one)),
             Contains("1 axes of a head-table machine"));
  CHECK_THAT(message(on_machine("kinematics = \"table-table\"", one + one)),
             Contains("a second axis A"));
  CHECK_THAT(
      message(on_machine("kinematics = \"table-table\"", with(one, "[2, 0, 0]", "[0, 0, 0]"))),
      Contains("\"direction\" of an axis has no length"));
  CHECK_THAT(
      message(on_machine("kinematics = \"table-table\"", with(one, "[-120, 30]", "[10, 30]"))),
      Contains("leave out 0"));
}

TEST_CASE("a program that turns its axes falls into stretches, each in a setup of its own",
          "[unit][job]") {
  const Job job = fixture_job("trunnion");
  REQUIRE(job.stages.size() == 4);
  const char* const names[] = {"rough.1", "rough.2", "rough", "rough.4"};
  const char* const setups[] = {"vice", "vice.A35C70", "vice.A-35C250", "vice"};
  for (std::size_t i = 0; i < 4; ++i) {
    const JobStage& stage = job.stages[i];
    CHECK(stage.name == names[i]);
    CHECK(job.setups[stage.setup].setup.name == setups[i]);
    REQUIRE(stage.piece.has_value());
    CHECK(stage.piece->stage == "rough");
    CHECK(stage.piece->number == i + 1);
    CHECK(stage.piece->cuts == (i == 1 || i == 2));
    CHECK(only_positions(stage) == (i == 0 || i == 3));
    CHECK(stage.limits.has_gouge);
    CHECK(stage.limits.has_uncut == (i == 2));
    // Together they take every motion but the turns.
    if (i > 0)
      CHECK(stage.piece->range.first ==
            job.stages[i - 1].piece->range.last + stage.piece->range.turns.size());
  }
  CHECK(to_text(*job.stages[1].piece) == "stretch 2 of 4, A35C70");
  // In both ways to stand the tool is along the part's Z.
  for (const std::size_t i : {1, 2})
    CHECK(distance(tool_axis(job.setups[job.stages[i].setup].setup), {0, 0, 1}) < 1e-12);
}

TEST_CASE("a program that turns nothing stays one stage", "[unit][job]") {
  const tests::TemporaryFolder folder;
  std::string job = model::read_text_file(tests::fixtures() / "rotary/trunnion.toml");
  job = with(job, "../cages", (tests::fixtures() / "cages").string());
  std::ofstream(folder.path() / "trunnion.nc")
      << "G21 G90\nT1 M6\nS1 M3\nG43 H1\nG0 X0 Y0 Z100\nA0 C0\nG1 Z50 F100\nM30\n";
  std::ofstream(folder.path() / "job.toml") << job;
  const Job read = read_job(folder.path() / "job.toml");
  REQUIRE(read.stages.size() == 1);
  CHECK_FALSE(read.stages[0].piece.has_value());
  CHECK(read.setups.size() == 1);
}

TEST_CASE("fixtures stand as what carries them", "[unit][job]") {
  Job job = fixture_job("trunnion");
  const model::RotaryAngles turned{35, 0, 70};
  const std::size_t setup = job.stages[1].setup;
  const Job view = in_setup(job, setup);
  const model::Kinematics& machine = *job.machine.kinematics;
  const Vec3 zero{12, 34, -56}, p{1, 2, 3};
  const auto at = [&](FixtureMount mount) { return turned_body(view, mount, turned).point(p); };
  CHECK(distance(at({FixtureMount::Kind::machine, {}}), p) < 1e-12);
  CHECK(distance(at({}), machine.table(turned).point(p + zero) - zero) < 1e-12);
  CHECK(distance(at({FixtureMount::Kind::axis, 'A'}),
                 machine.axes[0].turn(35).point(p + zero) - zero) < 1e-12);
  using Catch::Contains;
  const std::string clamp =
      "[[fixture]]\nname = \"vice\"\nfile = \"cages/quick-dome.obj\"\naxis = \"";
  CHECK_THAT(error_of(good_job() + clamp + "A\"\n"), Contains("the machine has no rotary axes"));
  CHECK_THAT(error_of(on_machine("kinematics = \"table-table\"") + clamp + "B\"\n"),
             Contains("\"B\" is no axis of the machine"));
}

TEST_CASE("bodies that go with the tool stand as the machine has it", "[unit][job]") {
  const std::optional<model::Kinematics> machine = *fixture_job("swivel-head").machine.kinematics;
  const model::RotaryAngles angles{0, 35, -70};
  constexpr double kLength_mm = 80;
  const Vec3 gauge{5, -3, 100}, p{1, 2, 3};
  // The tool's frame in the machine's, as model::Kinematics has it.
  model::Pose tool = machine->head(angles);
  tool.shift_mm = gauge + tool.point({0, 0, -kLength_mm});
  CHECK(distance(tool.shift_mm, machine->stand(gauge, angles, kLength_mm).tip_mm) < 1e-12);
  const auto stands = [&](const FixtureMount& mount) {
    return tool.point(body_in_tool(machine, mount, angles, kLength_mm).point(p));
  };
  // Of two heads the first alone turns what is mounted on it.
  const Vec3 on_spindle =
      gauge + machine->axes[0].turn(-70).point(machine->axes[1].turn(35).point(p));
  CHECK(distance(stands({FixtureMount::Kind::spindle, {}}), on_spindle) < 1e-12);
  CHECK(distance(stands({FixtureMount::Kind::head, 'B'}), on_spindle) < 1e-12);
  CHECK(distance(stands({FixtureMount::Kind::head, 'C'}),
                 gauge + machine->axes[0].turn(-70).point(p)) < 1e-12);
  const model::Pose upright = body_in_tool({}, {FixtureMount::Kind::spindle, {}}, {}, kLength_mm);
  CHECK(upright.point(p) == p + Vec3{0, 0, kLength_mm});
}

TEST_CASE("a body that goes with the tool needs the length of each stage's tool", "[unit][job]") {
  const std::string nose =
      "[[fixture]]\nname = \"nose\"\nfile = \"cages/quick-dome.obj\"\naxis = \"spindle\"\n";
  using Catch::Contains;
  CHECK_THAT(error_of(good_job() + nose),
             Contains("\"nose\" goes with the spindle") && Contains("\"length\" of the tool"));
  const Job job =
      read(with(good_job(), "diameter = 6\n", "diameter = 6\nnumber = 1\nlength = 75\n") + nose);
  CHECK(job.fixtures.at(0).mount.with_tool());
  CHECK(job.stages.at(0).tool_length_mm == 75);
}

}  // namespace limitgauge::app
