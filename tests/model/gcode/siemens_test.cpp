#include "model/gcode/program.h"
#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using limitgauge::model::test::assumes;
using limitgauge::model::test::read_text;

namespace {

MachineSetup siemens() {
  MachineSetup machine;
  machine.control = Control::siemens;
  machine.assume_fresh_machine = true;
  return machine;
}

}  // namespace

TEST_CASE("Siemens's D1 is in effect behind a change of the tool, and it is said",
          "[unit][program]") {
  MachineSetup machine = siemens();
  machine.tools = {{1, 80, std::nullopt}, {2, 50, std::nullopt}};
  const auto read = [&](const std::string& text) {
    return read_text("G71 G90 G94\nT1 M6\n" + text, machine);
  };
  const std::string note = "D1 is taken to be in effect";
  const Program silent = read("G0 X0 Y0 Z5\nT2 M6\nG0 X0 Y0 Z5\n");
  CHECK(silent.motions.back().to == Vec3{0, 0, 5});
  CHECK(assumes(silent, note));
  for (const std::string said : {"D1\nG0 Z5\n", "D1 G0 Z5\n", "G0 D1 Z5\n"}) {
    CHECK(read(said).motions.back().to.z == 5);
    CHECK(!assumes(read(said), note));
  }
  // Without an offset the spindle's nose is where the program says.
  CHECK(read("D0\nG0 Z100\n").motions.back().to.z == 20);
  CHECK(!assumes(read("D0\nG0 Z100\n"), note));
}

TEST_CASE("Siemens's D is the radius's too, and stays while cutter compensation is on",
          "[unit][program]") {
  MachineSetup machine = siemens();
  machine.tools = {{1, 80, 8}};
  const auto read = [&](const std::string& text) {
    return read_text("G71 G90 G94 G54\nT1 M6\n" + text, machine);
  };
  const std::string contour = "G0 X0 Y-25 Z5\nG1 Z-1 F400\nG41 X10\nY20\n";
  CHECK(read("D1\n" + contour + "X30\nG40 X60\n").motions.size() > 4);
  CHECK_THROWS_WITH(read("D1\n" + contour + "X30 D0\n"),
                    ContainsSubstring("'D0' while cutter compensation is on"));
  CHECK_THROWS_WITH(read("D0\n" + contour), ContainsSubstring("'G41' under D0"));
  CHECK(read("D0\nG0 Z100\nD1\n" + contour).motions.size() > 4);
}

TEST_CASE("Siemens makes up for another length or zero offset in G91, too", "[unit][program]") {
  MachineSetup machine = siemens();
  machine.tools = {{1, 80, std::nullopt}, {2, 50, std::nullopt}};
  machine.work_offsets = {WorkOffset{{}, 0}, WorkOffset{{0, 0, 20}, 0}};
  const auto read = [&](const std::string& text) {
    return read_text("G71 G90 G94 G54\nT1 M6\nD1\nG0 X0 Y0 Z10\n" + text, machine);
  };
  CHECK(read("G91 G0 Z-5\n").motions.back().to.z == 5);
  CHECK(read("T2 M6\nD1\nG0 Z10\nG91 G0 Z-5\n").motions.back().to.z == 5);
  for (const std::string change : {"T2 M6\nD1\n", "T2 M6\n", "D0\n", "G55\n"})
    CHECK_THROWS_WITH(read(change + "G91 G0 Z-5\n"), ContainsSubstring("'Z-5' in G91 behind"));
  CHECK_THROWS_WITH(read("G55\nG0 Z10 X0\nG91 G0 Y-5\n"), ContainsSubstring("'Y-5' in G91"));
  CHECK(read("G54\nG91 G0 Z-5\n").motions.back().to.z == 5);
}

TEST_CASE("the length of Siemens's D is taken along Z in every plane, and it is said",
          "[unit][program]") {
  const std::string note = "the tool's length is taken to act along Z";
  CHECK(assumes(read_text("G71 G90\nG18\nG0 X1\n", siemens()), note));
  CHECK(!assumes(read_text("G71 G90\nG17\nG0 X1\n", siemens()), note));
}

TEST_CASE("Siemens's length stays in effect beside SUPA, unless D0 takes it out",
          "[unit][program]") {
  MachineSetup machine = siemens();
  machine.tools = {{1, 80, std::nullopt}};
  const auto read = [&](const std::string& text) {
    return read_text("G71 G90 G94 G54\nT1 M6\nD1\n" + text, machine);
  };
  for (const std::string code : {"SUPA", "G53", "G153"}) {
    const Program kept = read(code + " G0 Z-100\n"), left = read("G0 " + code + " Z-100 D0\n");
    CHECK(kept.motions.back().to.z == -100);
    CHECK(assumes(kept, "the tool's length is taken to stay in effect"));
    CHECK(left.motions.back().to.z == -180);
    CHECK(!assumes(left, "the tool's length is taken to stay in effect"));
  }
}
