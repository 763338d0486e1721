#include "app/job/machine_options.h"

#include <fstream>

#include "app/cli/usage_error.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

std::string error_of(const MachineOptions& options) {
  return tests::message_of<std::exception>([&] { machine_of(options); });
}

}  // namespace

TEST_CASE("the machine as the command line states it", "[unit][cli]") {
  const tests::TemporaryFolder folder;
  const auto table = folder.path() / "tool.tbl";
  std::ofstream(table) << "T1 P1 Z80.5 D6 ;ball\nT2 P2 D8\n";
  MachineOptions options;
  options.work_offsets = {"G54=1,2,3", "g59.1=4,5,6,30"};
  options.home = "0,0,150";
  options.start = "1,-2,30.5";
  options.tool_table = table;
  const model::MachineSetup machine = machine_of(options);
  REQUIRE(machine.work_offsets[0]);
  CHECK(machine.work_offsets[0]->origin_mm == model::Vec3{1, 2, 3});
  REQUIRE(machine.work_offsets[6]);
  CHECK(machine.work_offsets[6]->rotation_deg == 30);
  CHECK(machine.home_mm == model::Vec3{0, 0, 150});
  CHECK(!machine.second_home_mm);
  CHECK(machine.start_mm == model::Vec3{1, -2, 30.5});
  REQUIRE(machine.tools.size() == 2);
  CHECK(machine.tools[0].length_mm == 80.5);
  CHECK(machine.tools[1].diameter_mm == 8.0);
}

TEST_CASE("the control and its subprograms as the command line states them", "[unit][cli]") {
  const tests::TemporaryFolder folder;
  MachineOptions options;
  CHECK(!machine_of(options).control_is_stated);
  CHECK(machine_of(options).control == model::Control::linuxcnc);
  options.control = "haas";
  options.subprograms = folder.path();
  options.work_offsets = {"G54.1P7=1,2,3", "g154 p8=4,5,6,30"};
  const model::MachineSetup machine = machine_of(options);
  CHECK(machine.control == model::Control::haas);
  CHECK(machine.control_is_stated);
  CHECK(machine.subprograms == folder.path());
  CHECK(machine.extended_offsets.at(7).origin_mm == model::Vec3{1, 2, 3});
  CHECK(machine.extended_offsets.at(8).rotation_deg == 30);
  options.work_offsets.emplace_back("G54.1P7=0,0,0");
  CHECK_THAT(error_of(options), ContainsSubstring("G54.1 P7 is stated twice"));
  options.work_offsets = {"G54.1P301=0,0,0"};
  CHECK_THAT(error_of(options), ContainsSubstring("is no work offset"));
  options.work_offsets.clear();
  options.subprograms = folder.path() / "none";
  CHECK_THAT(error_of(options), ContainsSubstring("none: no such folder"));
  options.control = "Heidenhain";
  CHECK(error_of(options) ==
        "--control Heidenhain: no such control; expected linuxcnc, fanuc, haas, "
        "mach3, grbl or siemens");
}

TEST_CASE("machine options that say nothing", "[unit][cli]") {
  MachineOptions options;
  options.home = "1,2";
  CHECK(error_of(options) == "--home 1,2: 2 numbers; expected X,Y,Z");
  options.home = "1,x,2";
  CHECK_THAT(error_of(options), ContainsSubstring("\"x\" is no number"));
  options.home = "";
  for (const char* wrong : {"1,2", "1,nan,2", "above", "1,2,3,4", "1e5,0,0"}) {
    options.start = wrong;
    CHECK_THAT(error_of(options), ContainsSubstring(std::string("--start ") + wrong + ": "));
  }
  options.start = "";
  options.work_offsets = {"G60=1,2,3"};
  CHECK_THAT(error_of(options), ContainsSubstring("\"G60\" is no work offset"));
  options.work_offsets = {"G54=1,2,3", "G54=1,2,3"};
  CHECK_THAT(error_of(options), ContainsSubstring("G54 is stated twice"));
  options.work_offsets = {"G54"};
  CHECK_THAT(error_of(options), ContainsSubstring("expected G54=X,Y,Z"));
}

}  // namespace limitgauge::app
