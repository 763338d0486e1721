#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

std::string ignored(const std::string& text) {
  std::string list;
  for (const IgnoredWord& word : read_text(text).ignored) list += word.word + ";";
  return list;
}

}  // namespace

TEST_CASE("auxiliary words are listed with what belongs to them", "[unit][gcode]") {
  CHECK(ignored("M62 P1\nM66 P0 L3 Q2\nM68 E1 Q0.5\nM19 R90 P1 Q5\nM50 P0\nM48\nM60\n") ==
        "M62 P1;M66 P0 L3 Q2;M68 E1 Q0.5;M19 R90 P1 Q5;M50 P0;M48;M60;");
  CHECK(ignored("G96 D2500 S100 M3\nG97 S5\nM61 Q2\n") == "G96 D2500;S100;M3;G97;S5;M61 Q2;");
  CHECK(ignored("G10 L2 P1 X0\nG92 X0\nG28.1\nM70\n").empty());
}

TEST_CASE("two codes that want the same words", "[unit][gcode]") {
  for (const char* block :
       {"G28 G1 X0", "G10 L2 P1 G0 X0", "G92 G1 X0", "G52 G0 X1", "G30 G81 X0"}) {
    CAPTURE(block);
    CHECK(error_of(block).find("would both use axis words") != std::string::npos);
  }
  CHECK(error_of("G64 P1 G10 L2 P1").find("in one block") != std::string::npos);
  CHECK(error_of("G64 P1 G10 L2 X1").find("1:5: error: 'P1' would be used by G10 and by G64") == 0);
  CHECK(error_of("G80 G92 X1 Y1 Z1") == "no error");
  CHECK(error_of("G92.1 G10 L2 P1 X0") == "no error");
}

TEST_CASE("words that a code lacks or that are out of range", "[unit][gcode]") {
  const auto expect = [](const std::string& block, const std::string& error) {
    CAPTURE(block);
    CHECK(error_of(block).find(error) == 0);
  };
  expect("M62", "1:1: error: 'M62' lacks a word; expected P");
  expect("M66 P1 E1", "1:1: error: 'M66' lacks a word; expected P or E");
  expect("M67 Q1", "1:1: error: 'M67' lacks a word; expected E");
  expect("M19 R361", "1:5: error: 'R361' beside M19 is out of range");
  expect("M61", "1:1: error: M61 without a tool");
  expect("G96", "1:1: error: G96 without its surface speed");
  expect("G10 P1 X0", "1:1: error: G10 without its L word");
  expect("G10 L2 X0", "1:1: error: G10 without its P word");
  expect("G10 L2 P10 X0", "1:8: error: 'P10' names no coordinate system");
  expect("G10 L3 P1 X0", "1:5: error: 'L3' beside G10");
  expect("G10 L10 P1 X0", "1:5: error: G10 L10 is not carried out: it measures a tool");
  expect("G10 L20 P1 R5", "1:12: error: 'R5' has no meaning beside G10 L20");
  expect("G10 L1 P1", "1:8: error: G10 L1 without a length and a radius");
  expect("S1e300", "1:3: error: 'e300' beside no code");
  expect("S-1", "1:1: error: a negative spindle speed");
  expect("S9999999999", "1:1: error: a spindle speed beyond any machine");
  expect("G0 X1 E2", "1:7: error: 'E2' beside no code that uses it");
  expect("M6", "1:1: error: a tool change without a tool");
}

TEST_CASE("codes that are refused say why", "[unit][gcode]") {
  for (const char* code : {"G5", "G5.1", "G7", "G12", "G33", "G33.1", "G38.2", "G38.5", "G70",
                           "G71.2", "G76", "G17.1", "M100", "M199"}) {
    CAPTURE(code);
    CHECK(error_of(code).find(std::string("1:1: error: '") + code + "' is not carried out: ") == 0);
  }
  for (const char* code : {"G6", "G38", "G38.1", "G101", "M10", "M200"}) {
    CAPTURE(code);
    CHECK(error_of(code).find("1:1: error: ") == 0);
  }
}

TEST_CASE("comments alone in their line name what follows", "[unit][gcode]") {
  const Program program =
      read_text("( rough )\nG0 X1 (not alone)\n;  finish\t\nX2\n/ (skipped?)\n()\n");
  REQUIRE(program.comments.size() == 4);
  CHECK(program.comments[0].text == "rough");
  CHECK(program.comments[0].line == 1);
  CHECK(program.comments[0].motion == 0);
  CHECK(program.comments[1].text == "finish");
  CHECK(program.comments[1].motion == 1);
  CHECK(program.comments[2].text == "skipped?");
  CHECK(program.comments[3].text.empty());
  CHECK(read_text("(" + std::string(500, 'x') + ")\n").comments[0].text.size() == 200);
}

TEST_CASE("modes that a program never says are listed where they first matter", "[unit][gcode]") {
  const std::string units =
      "lengths are taken to be in millimetres: nothing before says which unit";
  const std::string places =
      "places are taken to be absolute (G90): nothing before says G90 or G91";
  const auto assumed = [](const char* text) { return read_text(text).assumed; };
  using Listed = std::vector<std::string>;
  CHECK(assumed("S100 M3\nG0 X1\nX2\n") == Listed{"line 2: " + units, "line 2: " + places});
  CHECK(assumed("G90\nG0 X1\n") == Listed{"line 2: " + units});
  CHECK(assumed("G20\nG0 X1\n") == Listed{"line 2: " + places});
  CHECK(assumed("G0 G21 G91 X1\n").empty());
  // Only what comes before the motion says what it means.
  CHECK(assumed("G21\nG0 X1\nG90 X2\n") == Listed{"line 2: " + places});
  CHECK(assumed("G21\nM3 S100\nM30\n").empty());
}

TEST_CASE("what feeds take of a spindle that is not said in full is listed", "[unit][gcode]") {
  const std::string speed = "the spindle is taken to turn: nothing before says how fast (S)";
  const std::string left =
      "the cutter is taken to be one that cuts counter-clockwise: M4 turns the spindle";
  const auto assumed = [](const std::string& text) {
    return read_text("G21 G90\n" + text).assumed;
  };
  using Listed = std::vector<std::string>;
  CHECK(assumed("M3\nG0 X1\nG1 X2 F100\nX3\n") == Listed{"line 4: " + speed});
  CHECK(assumed("M3\nG1 X2 F100 S500\nX3\n").empty());
  CHECK(assumed("M4 S500\nG0 X1\nG1 X2 F100\nX3\n") == Listed{"line 4: " + left});
  CHECK(assumed("M4\nG1 X2 F100\nM3\nX3\n") == Listed{"line 3: " + speed, "line 3: " + left});
  // Said nowhere, it is the operator's; at rest, it is a finding where material is met.
  CHECK(assumed("G1 X2 F100\n").empty());
  CHECK(assumed("M3 S0\nG1 X2 F100\n").empty());
  CHECK(assumed("M4 S500 F100\nG0 X0 Y0 Z1\nG98 G74 Z-1 R1\nG80\n").empty());
}

TEST_CASE("assumptions are listed once", "[unit][gcode]") {
  const Program program = read_text("G21 G90\nT1 M6\nG43 H1\nG0 Z1\nG49\nG43 H1\nZ1\n");
  CHECK(program.assumed.size() == 1);
}
