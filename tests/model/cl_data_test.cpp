#include "model/gcode/cl_data.h"

#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>

#include "model/base/error.h"
#include "model/gcode/program_path.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"

using namespace limitgauge::model;

namespace {

ClData cl_data_of(const std::string& text) {
  std::istringstream in(text);
  return read_cl_data(in, "cl.apt");
}

std::string written(const Toolpath& path, const std::string& cutter, const ClOptions& options) {
  std::ostringstream out;
  write_cl_data(path, parse_cutter(cutter), options, out);
  return out.str();
}

std::string refusal_of(const std::string& text) {
  return limitgauge::tests::message_of<InputError>([&] { cl_data_of(text); });
}

Toolpath small_path() {
  Toolpath path;
  path.start = {0, 0, 10};
  path.moves = {
      {{1.00004, 2, 10}, 0, 0, MoveKind::rapid}, {{1, 2, -0.5}, 300, 0, MoveKind::feed},
      {{1, 2.5, -0.5}, 300, 0, MoveKind::feed},  {{1, 2.5, 10}, 0, 0, MoveKind::rapid},
      {{1, 2.5, 9}, 300, 0, MoveKind::feed},     {{1, 2.5, 8.25}, 333.3333F, 0, MoveKind::feed}};
  return path;
}

}  // namespace

TEST_CASE("CL data, letter by letter", "[unit][cl]") {
  CHECK(written(small_path(), "ball:D=6", {"dome finish", 2, 4}) ==
        "PARTNO dome finish\nUNITS/MM\nCUTTER/6,3\nLOADTL/2\nFROM/0,0,10\n"
        "RAPID\nGOTO/1,2,10\nFEDRAT/300,MMPM\nGOTO/1,2,-0.5\nGOTO/1,2.5,-0.5\n"
        "RAPID\nGOTO/1,2.5,10\nGOTO/1,2.5,9\nFEDRAT/333.3333,MMPM\nGOTO/1,2.5,8.25\nFINI\n");
}

TEST_CASE("every cutter has its figures", "[unit][cl]") {
  const auto cutter_line = [](const std::string& cutter) {
    const std::string text = written({}, cutter, {});
    const std::size_t begin = text.find("CUTTER");
    return text.substr(begin, text.find("LOADTL") - begin);
  };
  CHECK(cutter_line("flat:D=8") == "CUTTER/8\n");
  CHECK(cutter_line("bull:D=8,r=1.5") == "CUTTER/8,1.5\n");
  CHECK(cutter_line("taper:D=2,angle=45,L=10") == "CUTTER/2,0,1,0,0,45,10\n");
  // Seven figures of seventeen digits do not fit 72 columns.
  const std::string text =
      written({}, "taper:D=1.234567890123,r=0.371234567,angle=7.77777777777,L=12.345678901", {});
  CHECK_THAT(text, ContainsSubstring("$\n"));
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) CHECK(line.size() <= 72);
  const SevenFigures taper = *cl_data_of(text).cutter;
  CHECK(taper == seven_figures(parse_cutter(
                     "taper:D=1.234567890123,r=0.371234567,angle=7.77777777777,L=12.345678901")));
  // The upper line touches the corner circle: both are as far from its centre as its radius.
  const double angle = taper.upper_angle * std::acos(-1.0) / 180;
  const double off = (taper.diameter / 2 - taper.centre_radius) * std::cos(angle) +
                     taper.centre_height * std::sin(angle);
  CHECK(off == Approx(taper.corner_radius));
}

TEST_CASE("short forms of a cutter say the same as seven figures", "[unit][cl]") {
  for (const char* text : {"flat:D=8", "ball:D=6", "bull:D=8,r=1.5"}) {
    SevenFigures expected = seven_figures(parse_cutter(text));
    expected.height = 0;
    CHECK(*cl_data_of(written({}, text, {})).cutter == expected);
  }
}

TEST_CASE("all seven figures of a cutter are written and read", "[unit][cl]") {
  for (const char* text : {"drill:D=6,angle=118,L=40", "apt:D=10,r=1,a=12,b=-7,L=30",
                           "apt:D=8,r=0.7,b=-20,L=6", "apt:D=6,a=30,b=10,L=9"}) {
    CAPTURE(text);
    const Cutter cutter = parse_cutter(text);
    const SevenFigures figures = *cl_data_of(written({}, text, {})).cutter;
    CHECK(figures == seven_figures(cutter));
    CHECK(to_text(cutter_of(figures)) == to_text(cutter));
  }
  const SevenFigures inch = *cl_data_of("UNITS/INCHES\nCUTTER/.5,.05,.2,.05,0,0,2\nFINI\n").cutter;
  CHECK(inch.diameter == 12.7);
  CHECK(inch.height == 50.8);
}

TEST_CASE("figures that make no cutter are refused with their place", "[unit][cl]") {
  CHECK(
      refusal_of("CUTTER/10,1,4\nFINI\n") ==
      "cl.apt:1:1: error: CUTTER with 3 figures; expected d, or d and r, or all of d,r,e,f,a,b,h");
  CHECK(refusal_of("CUTTER/10,1,4.02,1,0,0,30\nFINI\n") ==
        "cl.apt:1:1: error: e is 4.02, but the other figures make it 4; expected figures that make "
        "a cutter");
  CHECK_THAT(refusal_of("CUTTER/10,6\nFINI\n"), ContainsSubstring("corner radius must not exceed"));
  CHECK_THAT(refusal_of("CUTTER/10,0,5,0,0,95,30\nFINI\n"), ContainsSubstring("side angle"));
  CHECK_THAT(refusal_of("CUTTER/10,0,5,0,0,0,0\nFINI\n"), ContainsSubstring("flute length"));
}

TEST_CASE("CL data are read as a path", "[unit][cl]") {
  const ClData data = cl_data_of(
      "\xEF\xBB\xBFpartno/ two words \r\n$$ a remark\nPPRINT anything, $ at all/\nunits / inches\n"
      "SPINDL/RPM,12000,CLW\nCOOLNT/ON\nLOADTL/3\nRAPID\nGOTO/1,2,$ \n 3 $$ start\nFEDRAT/IPM,10\n"
      "GOTO/1,2,2,0,0,1\nUNITS/MM\nfedrat/200\nGOTO/0,.5,-1.e1\nRAPID\nGOTO/0,0,0\n\n"
      "GOTO/0,0,1\nFINI\nnothing is read here");
  CHECK(data.part == "two words");
  CHECK(data.tool == 3);
  CHECK_FALSE(data.cutter.has_value());
  CHECK_FALSE(data.from.has_value());
  REQUIRE(data.moves.size() == 5);
  CHECK(data.moves[0].to == Vec3{25.4, 50.8, 3 * 25.4});
  CHECK(data.moves[0].kind == MoveKind::rapid);
  CHECK(data.moves[1].to == Vec3{25.4, 50.8, 50.8});
  CHECK(data.moves[1].feed_mm_min == 254.0F);
  CHECK(data.moves[1].line == 12);
  CHECK(data.moves[2].to == Vec3{0, 0.5, -10});
  CHECK(data.moves[2].feed_mm_min == 200.0F);
  CHECK(data.moves[3].kind == MoveKind::rapid);
  CHECK(data.moves[4].kind == MoveKind::feed);
}

TEST_CASE("CL data that cannot be used are refused with their place", "[unit][cl]") {
  const std::string feed = "FEDRAT/100\n", end = "FINI\n";
  CHECK(refusal_of("FROM/1,2\n" + end) ==
        "cl.apt:1:1: error: FROM with 2 figures; expected 3, or 6 with a tool axis");
  CHECK(refusal_of("FROM/0,0,0\nGOTO/1,2,x\n" + end) ==
        "cl.apt:2:10: error: 'X' is not a number; expected a number");
  CHECK(refusal_of("FROM/0,0,0\nGOTO/1,2,3\n" + end) ==
        "cl.apt:2:1: error: a feed move without a feed rate; expected FEDRAT or RAPID before it");
  CHECK_THAT(refusal_of("GOTTO/1,2,3\n" + end),
             ContainsSubstring("cl.apt:1:1: ") && ContainsSubstring("'GOTO'"));
  CHECK_THAT(refusal_of("GODLTA/1,2,3\n" + end), ContainsSubstring("not supported"));
  CHECK_THAT(refusal_of("GOTO/1,2,3,0,2,0\n" + end), ContainsSubstring("1:12: error: a tool axis"));
  CHECK_THAT(refusal_of("GOTO/1,2,\n" + end), ContainsSubstring("1:10: error: the statement ends"));
  CHECK_THAT(refusal_of("GOTO/1,2,3 4\n" + end), ContainsSubstring("1:12: error: '4' after"));
  CHECK_THAT(refusal_of("GOTO/1,2,1e20\n" + end), ContainsSubstring("beyond any machine"));
  CHECK_THAT(refusal_of("RAPID\nGOTO/1,2,3\nFROM/1,2,3\n" + end),
             ContainsSubstring("3:1: error: FROM"));
  CHECK_THAT(refusal_of("FROM/1,2,3\nFROM/1,2,3\n" + end), ContainsSubstring("2:1: error: FROM"));
  // The first one is a motion like any other.
  CHECK_THAT(refusal_of("GOTO/1,2,3\n" + end),
             ContainsSubstring("1:1: error: a feed move without"));
  CHECK_THAT(refusal_of("FEDRAT/1e-50\n" + end), ContainsSubstring("at least 1e-6"));
  CHECK_THAT(refusal_of("FEDRAT/0\n" + end), ContainsSubstring("feed rate '0'"));
  CHECK_THAT(refusal_of("FEDRAT/MMPM\n" + end), ContainsSubstring("without its number"));
  CHECK_THAT(refusal_of("FEDRAT/1,2\n" + end), ContainsSubstring("a second feed rate"));
  CHECK_THAT(refusal_of("UNITS/FEET\n" + end), ContainsSubstring("unknown unit"));
  CHECK_THAT(refusal_of("LOADTL/1\nLOADTL/2\n" + end), ContainsSubstring("second tool"));
  CHECK_THAT(refusal_of("CUTTER/1\nCUTTER/2\n" + end), ContainsSubstring("second cutter"));
  CHECK_THAT(refusal_of("LOADTL/1.5\n" + end), ContainsSubstring("an integer"));
  CHECK_THAT(refusal_of("(x)\n" + end), ContainsSubstring("1:1: error: '(' begins no word"));
  CHECK(refusal_of(feed) ==
        "cl.apt:2:1: error: the program does not end; it may have been cut off; "
        "expected FINI");
}

TEST_CASE("random paths are the same after writing and reading CL data", "[property][cl]") {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> number(-200, 200);
  for (int round = 0; round < 100; ++round) {
    const int decimals = static_cast<int>(random() % 10);
    const double unit = std::pow(10, -decimals);
    Toolpath path;
    path.start = {number(random), number(random), number(random)};
    float feed = 100;
    for (int i = 0; i < 100; ++i) {
      if (random() % 4 == 0) feed = static_cast<float>(std::pow(10, 1 + number(random) / 100));
      const bool rapid = random() % 4 == 0;
      path.moves.emplace_back(Vec3{number(random), number(random), number(random)},
                              rapid ? 0.0F : feed, 0, rapid ? MoveKind::rapid : MoveKind::feed);
    }
    const std::string text = written(path, "ball:D=6", {"part", 1, decimals});
    const ClData data = cl_data_of(text);
    REQUIRE(data.moves.size() == path.moves.size());
    REQUIRE(data.from);
    CHECK(distance(*data.from, path.start) <= unit);
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      CHECK(distance(data.moves[i].to, path.moves[i].to) <= unit);
      CHECK((data.moves[i].kind == path.moves[i].kind));  // a bit-field
      CHECK(data.moves[i].feed_mm_min == path.moves[i].feed_mm_min);
    }
    // What was read is what was written, exactly.
    Toolpath back;
    back.start = *data.from, back.moves = data.moves;
    CHECK(written(back, "ball:D=6", {"part", 1, decimals}) == text);
  }
}

TEST_CASE("CL data with any bytes changed give a path or an InputError", "[property][cl]") {
  const std::string whole =
      "PARTNO part\nUNITS/MM\nCUTTER/6,3\nLOADTL/1\nFROM/0,0,10\nRAPID\nGOTO/1,2,10 $$ x\n"
      "FEDRAT/300,MMPM\nGOTO/1,$\n2,-0.5\nGOTO/1,2.5,-0.5,0,0,1\nMULTAX/ON\n"
      "GOTO/1,2.5,-0.5,.6,0,.8\nFINI\n";
  std::mt19937 random(22);
  const std::string alphabet = "GOTFEDRAPIMN0123456789.-+,/$ \n\r\t(\xFF";
  for (int round = 0; round < 6000; ++round) {
    std::string text = whole.substr(0, round % 3 == 0 ? random() % whole.size() + 1 : whole.size());
    for (int change = 0; change < 3; ++change)
      text[random() % text.size()] = alphabet[random() % alphabet.size()];
    try {
      for (const Move& move : cl_data_of(text).moves) CHECK(is_finite(move.to));
    } catch (const InputError& error) {
      CHECK(error.place().line > 0);
      CHECK(error.place().column > 0);
    }
  }
}

TEST_CASE("paths that are no CL data are refused before anything is written", "[unit][cl]") {
  const auto refused = [](const Move& move, const ClOptions& options) {
    Toolpath path;
    path.moves = {move};
    std::ostringstream out;
    CHECK_THROWS_AS(write_cl_data(path, parse_cutter("ball:D=6"), options, out),
                    std::invalid_argument);
    CHECK(out.str().empty());
  };
  refused({{std::nan(""), 0, 0}, 100, 0, MoveKind::feed}, {});
  refused({{1, 2, 3}, 0, 0, MoveKind::feed}, {});
  refused({{1, 2, 3}, 100, 0, MoveKind::feed}, {"", 1, 10});
  refused({{1, 2, 3}, 100, 0, MoveKind::feed}, {"", -1, 4});
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  CHECK_THROWS_AS(write_cl_data({}, parse_cutter("ball:D=6"), {}, out), ResourceError);
}

TEST_CASE("CL data are told from G-code by their name or by how they begin", "[unit][cl]") {
  for (const char* text : {"PARTNO x\n", "  $$ remark\nGOTO/1,2,3", "units / MM\n", "GOTO/1,2,3",
                           "\xEF\xBB\xBFPPRINT by a post"})
    CHECK(is_cl_data(text, "a.txt"));
  for (const char* text :
       {"", "%\nO1\n", "G0 X1", "(PARTNO)", "GOTO 10", "FROM", "N10 G1 X1", "RAPIDS"})
    CHECK_FALSE(is_cl_data(text, "a.nc"));
  CHECK(is_cl_data("TOOL PATH/x", "a.CLS"));
  CHECK(is_cl_data("G0 X1", "a.apt"));
  CHECK_FALSE(is_cl_data("G0 X1", "cls"));
}

TEST_CASE("CL data read as a program are the path that was written", "[unit][cl]") {
  const Toolpath path = small_path();
  std::istringstream in(written(path, "ball:D=6", {"dome finish", 2, 6}));
  MachineSetup machine;
  machine.work_offsets.front() = WorkOffset{{100, 50, -7}, 90};
  const Program program = read_program(in, "folder/dome.apt", machine);
  CHECK(program.name == "dome");
  REQUIRE(program.tool_changes.size() == 1);
  CHECK(program.tool_changes[0].tool == 2);
  CHECK(program.tool_changes[0].line == 4);
  CHECK(program.assumed == std::vector<std::string>{
                               "line 3: CUTTER/6,3 is not acted on, the tool stated is cut with"});
  for (int axis = 0; axis < 3; ++axis)
    CHECK(program.start_said_mm[static_cast<std::size_t>(axis)] == path.start[axis]);
  PathOptions options;
  options.machine_in_part = machine_in_part({}, *machine.work_offsets.front());
  options.start_mm = RigidPlacement{90, {100, 50, -7}}(path.start);
  const Toolpath back = to_toolpath(program, options);
  CHECK(distance(back.start, path.start) < 1e-12);
  REQUIRE(back.moves.size() == path.moves.size());
  for (std::size_t i = 0; i < back.moves.size(); ++i) {
    CHECK(distance(back.moves[i].to, path.moves[i].to) < 1e-6);
    CHECK(back.moves[i].kind == path.moves[i].kind);
    CHECK(back.moves[i].feed_mm_min == path.moves[i].feed_mm_min);
  }
}

TEST_CASE("what CL data ask of spindle and coolant is listed", "[unit][cl]") {
  std::istringstream in(
      "UNITS/MM\nSPINDL/RPM,1200\nCOOLNT/ON\nFEDRAT/10\nGOTO/1,2,3\nGOTO/1,2,4\nFINI");
  const Program program = read_program(in, "a.cls");
  REQUIRE(program.ignored.size() == 2);
  CHECK(program.ignored[0].word == "SPINDL/RPM,1200");
  CHECK(program.ignored[1].line == 3);
  CHECK(program.motions.size() == 2);
  CHECK_FALSE(program.start_said_mm[2].has_value());
}
