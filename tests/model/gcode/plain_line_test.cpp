// Lines that only move: what reads them at once against what reads every line.
#include "model/gcode/text/plain_line.h"

#include <random>
#include <string_view>

#include "model/gcode/text/lexer.h"
#include "tests/model/gcode/read_text.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::gcode;
using namespace limitgauge::model::test;

namespace {

/// Bytes of the line that are read; nothing for a line that is not plain.
std::optional<std::size_t> bytes_of(std::string_view text, PlainLine& line) {
  const char* const end = read_plain_line(text.data(), text.data() + text.size(), line);
  return end == nullptr ? std::nullopt : std::optional(static_cast<std::size_t>(end - text.data()));
}

bool is_plain(std::string_view text) {
  PlainLine line;
  return bytes_of(text, line).has_value();
}

template <class Choices>
auto any_of(std::mt19937& random, const Choices& choices) {
  return choices[random() % std::size(choices)];
}

std::string random_number(std::mt19937& random) {
  static constexpr const char* kNumbers[] = {"0",       "1.",         "-.5",   "+2.25",
                                             "12.3456", "-0",         "007.5", "-31",
                                             "42.125",  "99999.9999", "1 2",   "1234567890.12345",
                                             "2e9",     "1e",         "-"};
  const std::size_t odd = random() % 200 == 0 ? std::size(kNumbers) : 10;
  return kNumbers[random() % odd];
}

/// Nearly all of them plain, some with something else, a few wrong.
std::string random_line(std::mt19937& random) {
  static constexpr const char* kBegins[] = {"",     "",   "",    "",    "N10",
                                            " n7 ", "G1", "G0 ", "G01", "g0"};
  static constexpr const char* kModes[] = {
      "G91",      "G90",       "G20",     "G21",   "M5",         "G92 X1", "G28 Z0",
      "G2 X1 I1", "F200",      "S800 M3", "T2 M6", "G43 H2",     "G55",    "G81 Z-1 R1 F9",
      "G80",      "G93",       "G94",     "G18",   "#5=2",       "X#5",    "(remark)",
      "/X1 Y1",   "G53 G0 Z0", "G1",      "M3",    "G17 G1 F300"};
  if (random() % 12 == 0) return any_of(random, kModes);
  std::string line = any_of(random, kBegins);
  for (const char letter : {'X', 'y', 'Z'})
    if (random() % 3 != 0)
      line += (random() % 2 ? " " : "") + std::string(1, letter) + random_number(random);
  if (random() % 400 == 0) line += "X3";
  return line + (random() % 8 == 0 ? " \r" : "");
}

struct LineReading {
  std::string motions, error;
  std::vector<std::string> assumed;
};

std::string flags_of(const Motion& m) {
  std::string text;
  for (const bool flag : {m.position_known, m.spindle_stopped, m.parked, m.astray, m.height_known})
    text += flag ? '1' : '0';
  return text + ' ' + std::to_string(m.feed_mm_min) + '\n';
}

LineReading lines_read(const std::string& text, const MachineSetup& machine) {
  LineReading reading;
  try {
    const Program program = read_text(text, machine);
    for (const Motion& m : program.motions) reading.motions += to_text(m) + ' ' + flags_of(m);
    reading.assumed = program.assumed;
  } catch (const InputError& error) {
    // The rest may quote what stands there.
    const std::string text_of_error = error.what();
    reading.error = text_of_error.substr(0, text_of_error.find(" error: "));
  }
  return reading;
}

}  // namespace

TEST_CASE("a plain line is read to its end", "[unit][program]") {
  PlainLine line;
  CHECK(bytes_of("N5 G1 X1.5Y-.25 \r\nZ1", line) == 17);
  CHECK(line.axes == std::array{1.5, -0.25, 0.0});
  CHECK(line.states(0));
  CHECK(line.states(1));
  CHECK(!line.states(2));
  CHECK(line.motion == 10);
  CHECK(!line.has_whole_number);
  CHECK(bytes_of("z+007", line) == 5);
  CHECK(line.axes[2] == 7);
  CHECK(!line.motion);
  CHECK(line.has_whole_number);
  CHECK(bytes_of("G00X0", line) == 5);
  CHECK(line.motion == 0);
  CHECK(!line.has_whole_number);
}

TEST_CASE("what is more than a plain line, or wrong, is none", "[unit][program]") {
  for (const char* const text :
       {"",    " ",      "\n",   "G1",   "N1",     "N X1",     "X",        "X-",
        "X.",  "X1.2.3", "X1X2", "X1 2", "X1 .5",  "X#1",      "X[1]",     "X1(a)",
        "X1;", "/X1",    "%",    "G2X1", "G1.0X1", "G1 G1 X1", "G0 G1 X1", "G-1X1",
        "GX1", "X1A0",   "X1F2", "O1",   "X=1",    "X1=2",     "X1e3",     "X1234567890.123456",
        "X--1"})
    CHECK(!is_plain(text));
}

TEST_CASE("plain lines move as all lines do", "[property][program]") {
  std::mt19937 random(20261127);
  std::size_t moved = 0, refused = 0;
  for (int round = 0; round < 3000; ++round) {
    MachineSetup machine = round % 2 == 0 ? fresh_machine() : MachineSetup{};
    machine.control = any_of(random, kControls);
    std::string text = random() % 4 == 0 ? "" : "G0 X0. Y0. Z5.\nF300 G1 Z1.\n", same = text;
    for (std::size_t n = 3 + random() % 20; n > 0; --n) {
      const std::string line = random_line(random);
      text += line + '\n';
      // An empty comment makes a line one that must be looked at.
      same += line + ";\n";
    }
    CAPTURE(text, name(machine.control));
    const LineReading found = lines_read(text, machine), expected = lines_read(same, machine);
    CAPTURE(found.error, expected.error);
    REQUIRE(found.motions == expected.motions);
    REQUIRE(found.assumed == expected.assumed);
    REQUIRE(found.error == expected.error);
    moved += !found.motions.empty();
    refused += !found.error.empty();
  }
  CHECK(moved > 1000);
  CHECK(refused > 500);
}

TEST_CASE("plain lines are counted and named as all lines are", "[unit][program]") {
  const Program program = read_text("G1 F100 X1\nX2\n\nN9 Y1\nX2000000\n");
  REQUIRE(program.motions.size() == 4);
  CHECK(program.motions[1].line == 2);
  CHECK(program.motions[2].line == 4);
  CHECK(program.motions[3].to == Vec3{2000000, 1, 0});
  CHECK(error_of("G1 F100 X1\nX2\nX2000000000\n") ==
        "3:1: error: a position beyond any machine; expected at most 1e9 mm");
}
