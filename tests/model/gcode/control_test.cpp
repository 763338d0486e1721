#include <fstream>

#include "model/gcode/control/control_codes.h"
#include "model/gcode/program.h"
#include "model/gcode/text/program_text.h"
#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"
#include "tests/support/temporary_folder.h"

using namespace limitgauge::model;
using limitgauge::model::test::assumes;
using limitgauge::model::test::read_text;
using limitgauge::tests::message_of;

namespace {

MachineSetup of(Control control) {
  MachineSetup machine;
  machine.control = control;
  machine.assume_fresh_machine = true;
  return machine;
}

std::string offer_of(const std::string& text, Control control) {
  return message_of<InputError>(
      [&] { read_program_or_name_control(std::string_view(text), "p.nc", of(control)); });
}

}  // namespace

TEST_CASE("controls have names", "[unit][program]") {
  for (const Control control : kControls) CHECK(control_named(name(control)) == control);
  CHECK(!control_named("Haas"));
  CHECK(!control_named(""));
}

TEST_CASE("codes that Fanuc and Haas share with RS274/NGC have no rule of their own",
          "[unit][program]") {
  using gcode::g_rule, gcode::m_rule;
  for (const int tenths :
       {0,   10,  20,  30,  40,  100, 170, 180, 190, 200, 210, 280, 300, 400, 410, 420, 430,
        490, 520, 530, 540, 541, 550, 560, 570, 580, 590, 610, 640, 730, 740, 800, 810, 820,
        830, 840, 850, 860, 880, 890, 900, 910, 920, 930, 940, 950, 960, 970, 980, 990}) {
    CAPTURE(tenths);
    CHECK(g_rule(Control::fanuc, tenths) == nullptr);
    CHECK(g_rule(Control::linuxcnc, tenths) == nullptr);
  }
  for (const int number : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 19, 30, 98, 99})
    CHECK(m_rule(Control::haas, number) == nullptr);
}

TEST_CASE("G53 is a rapid on Fanuc whatever stands beside it, and what stands there stays",
          "[unit][program]") {
  // Kinds of the motions that follow the first feed: r a rapid, f a feed.
  const auto kinds = [](Control control, const std::string& text) {
    std::string out;
    for (const Motion& m :
         read_text("G21 G90 G94\nG0 Z5.\nG1 Z1. F100.\n" + text, of(control)).motions)
      out += m.kind == MotionKind::rapid ? 'r' : 'f';
    return out.substr(2);
  };
  for (const std::string beside : {"", "G1 ", "G0 "})
    CHECK(kinds(Control::fanuc, "G53 " + beside + "X1.\n") == "r");
  CHECK(kinds(Control::fanuc, "G53 X1.\nX2.\n") == "rf");
  CHECK(kinds(Control::fanuc, "G53 G0 X1.\nX2.\n") == "rr");
  CHECK(kinds(Control::fanuc, "G0 Z2.\nG53 G1 X1.\nX2.\n") == "rrf");
  CHECK(kinds(Control::fanuc, "G81 Z0. R2.\nG80 G53 X1.\nX2.\n").ends_with("rf"));
  CHECK(kinds(Control::haas, "G53 G1 X1.\n") == "f");
  CHECK(kinds(Control::linuxcnc, "G53 X1.\n") == "f");
}

TEST_CASE("G43 and H without Z move nothing on Fanuc, and it is said", "[unit][program]") {
  MachineSetup machine = of(Control::fanuc);
  machine.tools = {{1, 80, std::nullopt}, {2, 90, std::nullopt}};
  const auto read = [&](const std::string& text) {
    return read_text("G21 G90 T1 M6\nG0 X0. Y0. Z50.\n" + text, machine);
  };
  const std::string note = "G43 or H is taken to move nothing by itself";
  CHECK(!assumes(read("G43 H1 Z10.\n"), note));
  CHECK(assumes(read("G43 H1\nZ10.\n"), note));
  CHECK(assumes(read("G43 H1 Z10.\nH2\nZ10.\n"), note));
}

TEST_CASE("decimals beyond the least increment are told once", "[unit][program]") {
  const std::string note = "more decimals than";
  for (const std::string line : {"X1.2345\n", "X1.2345 M8\n", "G2 X2. Y0. I1.0001 J0. F100.\n"}) {
    CHECK(assumes(read_text("G21 G90 G17\nG0 X0. Y0.\n" + line, of(Control::fanuc)), note));
    CHECK(!assumes(read_text("G21 G90 G17\nG0 X0. Y0.\n" + line, of(Control::linuxcnc)), note));
  }
  CHECK(!assumes(read_text("G21 G90\nG0 X1.2340\n", of(Control::fanuc)), note));
  CHECK(!assumes(read_text("G20 G90\nG0 X1.2345\n", of(Control::fanuc)), note));
  CHECK(assumes(read_text("G20 G90\nG0 X1.23456\n", of(Control::haas)), note));
}

TEST_CASE("one word, two controls, two meanings", "[unit][program]") {
  // G10 L20 states an origin on Fanuc, and where the tool stands on LinuxCNC.
  const std::string text = "G21 G90\nG0 X5. Y0. Z0.\nG10 L20 P1 X1.\nG54.1 P1\nG0 X0.\n";
  CHECK(read_text(text, of(Control::fanuc)).motions.back().to == Vec3{1, 0, 0});
  CHECK(read_text("G21 G90\nG0 X5. Y0. Z0.\nG10 L20 P1 X1.\nG0 X0.\n", of(Control::linuxcnc))
            .motions.back()
            .to == Vec3{4, 0, 0});
  // G70 is inches on Siemens and a lathe's elsewhere; M61 loads a tool on LinuxCNC only.
  CHECK(read_text("G70\nG0 X1\n", of(Control::siemens)).motions.back().to.x == 25.4);
  CHECK(read_text("M61 Q3\nG0 X1\n", of(Control::linuxcnc)).tool_changes.size() == 1);
  CHECK(read_text("M61\nG0 X1.\n", of(Control::haas)).tool_changes.empty());
  CHECK_THAT(message_of<InputError>(
                 [] { read_text("G0 X0. Y0. Z0.\nG92 X5.\nG52 Y1.\n", of(Control::fanuc)); }),
             ContainsSubstring("one upon the other"));
  CHECK(read_text("G0 X0 Y0 Z0\nG92 X5\nG52 Y1\nG0 Y0\n").motions.back().to.y == 1);
  // FIX of a negative number, and H0.
  CHECK(read_text("G0 X[FIX[-1.5]]\n", of(Control::linuxcnc)).motions.back().to.x == -2);
  CHECK(read_text("G0 X[FIX[-1.5]]\n", of(Control::haas)).motions.back().to.x == -1);
}

TEST_CASE("a contour is entered and its corners are cut as the control does", "[unit][program]") {
  const auto path_of = [](Control control) {
    const std::string offset = control == Control::fanuc  ? "G10 L12 P1 R5.\n"
                               : control == Control::haas ? "G10 L12 P1 R10.\n"
                                                          : "";
    const std::string side = offset.empty() ? "G41.1 D10 " : "G41 D1 ";
    const Program program = read_text("G21 G90 G17 G94 G40 F500.\nG0 X-20. Y0. Z0.\n" + offset +
                                          "G1 " + side + "X0. Y0.\nY30.\nX30.\nG40 X40.\n",
                                      of(control));
    std::string text;
    for (const Motion& m : program.motions)
      text +=
          (m.kind == MotionKind::arc ? " arc " : " ") + shortest(m.to.x) + "," + shortest(m.to.y);
    return text;
  };
  CHECK(path_of(Control::linuxcnc) == " -20,0 -5,5 -5,30 arc 0,35 30,35 40,30");
  for (const Control control : {Control::fanuc, Control::haas})
    CHECK(path_of(control) == " -20,0 -5,0 -5,35 30,35 40,30");
}

TEST_CASE("levels of cycles stay what they were stated as on Fanuc and Haas", "[unit][program]") {
  const auto bottoms_of = [](Control control, const std::string& text) {
    std::string bottoms;
    for (const Motion& m : read_text(text, of(control)).motions)
      if (m.kind == MotionKind::feed) bottoms += " " + shortest(m.to.x) + "," + shortest(m.to.z);
    return bottoms;
  };
  // A row of holes: G91 is for X alone.
  const std::string row = "G21 G90 G17 G94 F9.\nG0 X0. Y0. Z10.\nG98 G81 X5. Z-3. R1.\nG91 X5.";
  CHECK(bottoms_of(Control::fanuc, row + " K2\n") == " 5,-3 10,-3 15,-3");
  CHECK(bottoms_of(Control::haas, row + " L2\n") == " 5,-3 10,-3 15,-3");
  CHECK(bottoms_of(Control::linuxcnc, row + " L2\n") == " 5,-3 10,8 15,8");
  // Stated in G91 they are steps, whatever comes later; a new R takes a depth below it along.
  const std::string steps =
      "G21 G90 G17 G94 F9.\nG0 X0. Y0. Z10.\nG99 G91 G81 X5. Z-3. R-9.\nG90 X7.\nG91 X1. R-8.\n";
  CHECK(bottoms_of(Control::fanuc, steps) == " 5,-2 7,-2 8,-1");
  const std::string pecks =
      "G21 G90 G17 G94 F9.\nG0 X0. Y0. Z10.\nG98 G83 X5. Z-3. R1. Q2.\nG91 X5.\n";
  CHECK(bottoms_of(Control::haas, pecks) == " 5,-1 5,-3 10,-1 10,-3");
  // Another cycle of the run goes on with them.
  const std::string two =
      "G21 G90 G17 G94 F9.\nG0 X0. Y0. Z10.\nG98 G81 X5. Z-3. R1.\nG82 X10. P500\n";
  CHECK(bottoms_of(Control::haas, two) == " 5,-3 10,-3");
}

TEST_CASE("the way across to a hole is at the level where the tool stands on Fanuc and Haas",
          "[unit][program]") {
  const auto path_of = [](Control control, const std::string& cycle) {
    std::string text;
    for (const Motion& m :
         read_text("G21 G90 G17 G94 F9.\nG0 X0. Y0. Z-4.\n" + cycle, of(control)).motions)
      text += " " + shortest(m.to.x) + "," + shortest(m.to.z);
    return text;
  };
  const std::string two = "G99 G81 X10. Z-5. R2.\nX20.\n";
  CHECK(path_of(Control::linuxcnc, two) == " 0,-4 0,2 10,2 10,-5 10,2 10,2 20,2 20,-5 20,2");
  for (const Control control : {Control::fanuc, Control::haas}) {
    CHECK(path_of(control, two) == " 0,-4 10,-4 10,2 10,-5 10,2 20,2 20,-5 20,2");
    // G98 goes back to where the run began, below R too.
    CHECK(path_of(control, "G98 G81 X10. Z-5. R2.\nX20.\n") ==
          " 0,-4 10,-4 10,2 10,-5 10,-4 20,-4 20,2 20,-5 20,-4");
    // From G99 to G98 it goes across first, not aslant.
    CHECK(path_of(control, "G0 Z9.\nG99 G81 X10. Z-5. R2.\nG98 X20.\n") ==
          " 0,-4 0,9 10,9 10,2 10,-5 10,2 20,2 20,-5 20,9");
  }
}

TEST_CASE("a full circle behind a tangent arc stays one", "[unit][program]") {
  // As post-processors round it: a bend of 1e-4 between lead-in and circle.
  const std::string pocket =
      "G21 G90 G17 G94 G40 F500.\nG0 X0. Y0. Z0.\nG10 L12 P1 R5.\nG1 G41 D1 X-9.004 Y0.421\n"
      "G3 X-7.412 Y-10.065 I6.039 J-4.447\nG3 I7.412 J10.065\nG3 X3.074 Y-8.473 I4.447 J6.039\n"
      "G1 G40 X0. Y0.\n";
  int circles = 0;
  Vec3 from;
  for (const Motion& m : read_text(pocket, of(Control::fanuc)).motions) {
    if (m.kind == MotionKind::arc) {
      const double radius = std::hypot(from.x - m.centre1, from.y - m.centre2);
      CHECK(std::abs(std::hypot(m.to.x - m.centre1, m.to.y - m.centre2) - radius) < 2e-3);
      circles += distance(m.to, from) < 1e-9 && std::abs(radius - 7.5) < 1e-3;
    }
    from = m.to;
  }
  CHECK(circles == 1);
  // A short arc is none.
  const std::string chain =
      "G21 G90 G17 G94 G40 F500.\nG0 X0. Y0. Z0.\nG10 L12 P1 R5.\nG1 G41 D1 X7.978 Y1.525\n"
      "X8.082 Y1.573\nG3 X8.155 Y1.608 I-2.328 J4.983\nG1 G40 X20. Y0.\n";
  int arcs = 0;
  for (const Motion& m : read_text(chain, of(Control::fanuc)).motions) {
    if (m.kind == MotionKind::arc) {
      ++arcs;
      CHECK(distance(m.to, from) < 0.02);
      const double turn =
          (from.x - m.centre1) * (m.to.y - m.centre2) - (from.y - m.centre2) * (m.to.x - m.centre1);
      CHECK(turn * m.turns > 0);
    }
    from = m.to;
  }
  CHECK(arcs == 1);
}

TEST_CASE("a hole at the contour's end is drilled there after G40", "[unit][program]") {
  const std::string contour =
      "G21 G90 G17 G94 G40 F9.\nG10 L12 P1 R3.\nG0 X0. Y0. Z0.\nG1 G41 D1 X9.\nX20.\nG40\nG0 Z9.\n";
  const auto last = [&](const std::string& block) {
    return read_text(contour + block, of(Control::fanuc)).motions.back().to;
  };
  CHECK(last("") == Vec3{20, 3, 9});
  CHECK(last("G98 G81 X20. Y0. Z-3. R1.\n") == Vec3{20, 0, 9});
  CHECK(last("Y0.\n") == Vec3{20, 0, 9});
}

TEST_CASE("another offset while compensation is on is refused", "[unit][program]") {
  const auto said = [](const std::string& line) {
    return message_of<InputError>([&] {
      read_text(
          "G21 G90 G17 G94 F9.\nG10 L12 P1 R5.\nG10 L12 P2 R2.\nG0 X0. Y0. Z0.\n"
          "G1 G41 D1 X20.\n" +
              line + "G40 X50.\n",
          of(Control::fanuc));
      throw InputError({"p.nc", 1, 1}, "nothing");
    });
  };
  CHECK_THAT(said("X30. D2\n"), ContainsSubstring("'D2' while cutter compensation is on"));
  CHECK_THAT(said("X30. D0\n"), ContainsSubstring("'D0' while cutter compensation is on"));
  CHECK_THAT(said("G10 L12 P1 R4.\n"), ContainsSubstring("while cutter compensation is on"));
  CHECK_THAT(said("X30. D1\n"), ContainsSubstring("nothing"));
}

TEST_CASE("a refusal names the controls that would read the program", "[unit][program]") {
  CHECK_THAT(offer_of("G187 P1\nG0 X1.\n", Control::linuxcnc),
             ContainsSubstring("; --control haas would read it, and so would fanuc"));
  CHECK_THAT(offer_of("R1=5\nG0 X=R1\n", Control::linuxcnc),
             ContainsSubstring("; --control siemens would read it"));
  CHECK_THAT(offer_of("O1 if [1]\nO1 endif\nG0 X1\n", Control::haas),
             ContainsSubstring("; --control linuxcnc would read it"));
  CHECK_THAT(offer_of("G0 X1Q7Q\n", Control::linuxcnc), !ContainsSubstring("--control"));
}

TEST_CASE("what a control's parameters decide is listed as assumed", "[unit][program]") {
  CHECK(assumes(read_text("G0 X10\n", of(Control::fanuc)), "'X10' and other lengths without"));
  CHECK(!assumes(read_text("G0 X10. Y0\n", of(Control::fanuc)), "without a decimal point"));
  CHECK(!assumes(read_text("G0 X10\n", of(Control::mach3)), "without a decimal point"));
  CHECK(assumes(read_text("G81 X0. Z-1. R1. F9\n", of(Control::haas)), "begun in G98"));
  CHECK(!assumes(read_text("G98 G81 X0. Z-1. R1. F9\n", of(Control::haas)), "begun in"));
  CHECK(assumes(read_text("X1.\n", of(Control::haas)), "begun in G0"));
  CHECK(assumes(read_text("G21\nX1.\n", of(Control::haas)), "begun in G0"));
  CHECK(!assumes(read_text("G21\nG0 X1.\nX2.\n", of(Control::haas)), "begun in G0"));
  CHECK(assumes(read_text("G99 G73 X0. Z-9. R1. Q2. F9\n", of(Control::haas)), "0.254 mm"));
  CHECK(assumes(read_text("G10 L12 P1 R3.\n", of(Control::fanuc)), "state radii"));
  CHECK(assumes(read_text("G10 L12 P1 R3.\n", of(Control::haas)), "state diameters"));
  CHECK(
      assumes(read_text("G10 L12 P1 R3.\nG0 X0. Y0. Z0.\nG41 D1\n", of(Control::fanuc)), "type A"));
  CHECK(assumes(read_text("#1=2\n#1=3 G0 X#1\n", of(Control::fanuc)),
                "variables that are set beside"));
  CHECK(!assumes(read_text("#1=2\nN5 #1=3\nG0 X#1\n", of(Control::fanuc)), "variables that are"));
  const std::string contour =
      "G21 G90 G17 G40 F9.\nG10 L12 P1 R3.\nG0 X0. Y0. Z0.\nG1 G41 D1 X9.\nX20.\n";
  CHECK(assumes(read_text(contour + "G40\nG0 Z9.\nX30.\n", of(Control::haas)), "G40 takes effect"));
  CHECK(!assumes(read_text(contour + "G40 X30.\n", of(Control::haas)), "G40 takes effect"));
  CHECK(assumes(read_text("G18 G99 G81 X0. Y-1. R1. F9\n", of(Control::fanuc)), "5101#0"));
  CHECK(assumes(read_text("#1=#0\nG0 X#1 Y1.\n", of(Control::haas)), "is left out"));
  CHECK(assumes(read_text("G0 X\xE2\x88\x92"
                          "1\n"),
                "a dash that is not ASCII's"));
}

TEST_CASE("a work offset that the program sets is not assumed", "[unit][program]") {
  const auto lies_at_zero = [](const std::string& text) {
    return assumes(read_text(text, of(Control::linuxcnc)), "G55 lies at the machine's zero");
  };
  CHECK(lies_at_zero("G55 G0 X1\n"));
  CHECK(lies_at_zero("G10 L2 P2 X1\nG55 G0 X1\n"));
  CHECK(!lies_at_zero("G10 L2 P2 X1 Y2 Z3\nG55 G0 X1\n"));
  MachineSetup stated = of(Control::linuxcnc);
  stated.work_offsets = {WorkOffset{{}, 0}, WorkOffset{{0, 0, 20}, 0}};
  CHECK(!assumes(read_text("G55 G0 X1\n", stated), "lies at the machine's zero"));
}

TEST_CASE("subprograms in files of a folder", "[unit][program]") {
  const limitgauge::tests::TemporaryFolder folder, elsewhere;
  std::ofstream(folder.path() / "O0100.nc") << "%\nO0100\nG1 X[#1] F50.\nGOTO 5\nX99.\nN5 M99\n%\n";
  std::ofstream(folder.path() / "200") << "G0 Y2.\nM98 P100\nM99\n";
  std::ofstream(folder.path() / "readme.txt") << "not a program\n";
  std::ofstream(elsewhere.path() / "O300.nc") << "G0 X1.\nM99\n";
  std::filesystem::create_symlink(elsewhere.path() / "O300.nc", folder.path() / "O300.nc");
  MachineSetup machine = of(Control::fanuc);
  const std::string text = "G21 G90\n#1=7\nG0 X0. Y0. Z0.\nM98 P200\nG65 P100 A4.\nM30\n";
  CHECK_THAT(message_of<InputError>([&] { read_text(text, machine); }),
             ContainsSubstring("program O200 is not in this file"));
  machine.subprograms = folder.path();
  const Program program = read_text(text, machine);
  REQUIRE(program.motions.size() == 4);
  CHECK(program.motions[1].to == Vec3{0, 2, 0});
  CHECK(program.motions[2].to == Vec3{7, 2, 0});
  CHECK(program.motions[3].to == Vec3{4, 2, 0});
  // Lines are those of the program that a report shows.
  CHECK(program.motions[2].line == 4);
  CHECK(program.motions[3].line == 5);
  CHECK_THAT(message_of<InputError>([&] { read_text("M98 P300\n", machine); }),
             ContainsSubstring("neither in this file nor in the folder"));
  std::ofstream(folder.path() / "O100.tap") << "M99\n";
  CHECK_THAT(message_of<InputError>([&] { read_text(text, machine); }),
             ContainsSubstring("two files of program O100"));
  std::ofstream(folder.path() / "O400.nc") << "G0 X1.\nG0 X#7 Y[1\nM99\n";
  const std::string error = message_of<InputError>([&] { read_text("M98 P400\n", machine); });
  CHECK_THAT(error, ContainsSubstring("O400.nc:2:9: error: "));
  CHECK(subprogram_files(folder.path()).size() == 4);
}

TEST_CASE("a line without end is refused before it is read whole", "[unit][program]") {
  const limitgauge::tests::TemporaryFolder folder;
  const auto file = folder.path() / "long.nc";
  {
    std::ofstream out(file);
    out << "G0 X1\nG0 X";
  }
  // A hole in the file: a gigabyte that takes no room.
  std::filesystem::resize_file(file, std::uintmax_t{1} << 30U);
  CHECK_THAT(message_of<InputError>([&] { read_program(file); }),
             ContainsSubstring("long.nc:2:1000001: error: a line of more than 1000000 bytes"));
}

TEST_CASE("text in other encodings", "[unit][program]") {
  CHECK(as_program_text("G0 X1\r\nG0 X2\r\n", "a").empty());
  CHECK(as_program_text("G0 X1\rG0 X2\r", "a") == "G0 X1\nG0 X2\n");
  CHECK(as_program_text(std::string_view("\xFF\xFEG\0"
                                         "0\0",
                                         6),
                        "a") == "G0");
  CHECK(as_program_text(std::string_view("\0G\0"
                                         "0\0 \0X",
                                         8),
                        "a") == "G0 X");
  CHECK(as_program_text("", "a").empty());
  CHECK(as_program_text("\r", "a").empty());
}

TEST_CASE("what variables and expressions give is rounded to the least increment on Fanuc and Haas",
          "[unit][program]") {
  const auto end = [](const std::string& text, Control control) {
    return read_text("G90 G17 G40\n" + text, of(control)).motions.back().to;
  };
  for (const Control control : {Control::fanuc, Control::haas}) {
    // 30 steps of 10/3 end at 99.99, in inches at 99.999.
    const std::string steps = "#1=0\nG91\nWHILE[#1 LT 30]DO1\nX[10./3.]\n#1=#1+1\nEND1\n";
    CHECK(end("G21 G0 X0.\n" + steps, control).x == Approx(99.99).epsilon(1e-9));
    CHECK(end("G20 G0 X0.\n" + steps, control).x == Approx(99.999 * 25.4).epsilon(1e-9));
    CHECK(end("#1=1.23456\nG21 G0 X#1 Y-#1 Z1.23456\n", control).x == Approx(1.235).epsilon(1e-9));
    CHECK(end("#1=1.23456\nG21 G0 X#1 Y-#1 Z1.23456\n", control).y == Approx(-1.235).epsilon(1e-9));
    CHECK(end("#1=1.23456\nG21 G0 X#1 Y-#1 Z1.23456\n", control).z ==
          Approx(1.23456).epsilon(1e-9));
    CHECK(assumes(read_text("G90 G21 G0 X[10./3.]\n", of(control)), "are rounded to 0.001 mm"));
    CHECK(!assumes(read_text("G90 G21 G0 X[0.1+0.2]\n", of(control)), "are rounded to 0.001 mm"));
  }
  CHECK(end("G21 G0 X[10/3]\n", Control::linuxcnc).x == Approx(10.0 / 3).epsilon(1e-12));
}

TEST_CASE("axis words beside codes that only name axes move nothing", "[unit][program]") {
  for (const Control control : {Control::fanuc, Control::haas})
    for (const std::string code : {"G05.1 Q2 X0. Y0. Z0.", "G50.1 X7. Y7.", "G50.1 X0"}) {
      CAPTURE(code);
      const Program program = read_text("G90 G21 G0 X5. Y6. Z7.\n" + code + "\nX9.\n", of(control));
      REQUIRE(program.motions.size() == 2);
      CHECK(program.motions[1].to == Vec3{9, 6, 7});
      CHECK(!program.ignored.empty());
    }
}

TEST_CASE("arguments of G65 without a decimal point are listed", "[unit][program]") {
  const auto listed = [](const std::string& words) {
    return assumes(read_text("G90 G21 G0 X0.\nG65 P2 " + words + "\nM30\nO2\nG0 X1.\nM99\n",
                             of(Control::fanuc)),
                   "and other arguments of G65 without a decimal point");
  };
  CHECK(listed("A6"));
  CHECK(listed("A6. B7"));
  CHECK(!listed("A6. B7."));
  CHECK(!listed("A0 S5 T3 D2"));
  CHECK(!listed("A[1+1] B[2+3]"));
}

TEST_CASE("Grbl's check mode and settings of its axes are refused", "[unit][program]") {
  const auto reads = [](const std::string& line) {
    return message_of<InputError>(
        [&] { read_text(line + "\nG21 G90 G0 X1\n", of(Control::grbl)); });
  };
  CHECK(reads("$C").find("check mode") != std::string::npos);
  CHECK(reads("$100=80").find("changes which way or how far") != std::string::npos);
  for (const std::string setting : {"$3=1", "$03=1", "$3.0=1", "$102.=80", "$RST=*", "$rst=$"}) {
    CAPTURE(setting);
    CHECK(reads(setting).find("changes which way or how far") != std::string::npos);
  }
  CHECK_NOTHROW(read_text("$X\n$10=1\n$130=200\nG21 G90 G0 X1\n", of(Control::grbl)));
}
