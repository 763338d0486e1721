#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "model/base/error.h"
#include "model/gcode/program.h"
#include "tests/model/fixture_files.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

/// As `limitgauge inspect` takes it: a fresh machine, with the tool table beside the program.
MachineSetup machine_for(std::filesystem::path path, Control control = Control::linuxcnc) {
  MachineSetup machine;
  machine.control = control;
  machine.assume_fresh_machine = true;
  path.replace_extension(".tbl");
  if (std::filesystem::exists(path)) machine.tools = parse_tool_table(text_of(path), path.string());
  return machine;
}

std::vector<std::string> rows_of(const std::string& text) {
  std::vector<std::string> rows;
  std::istringstream in(text);
  for (std::string row; std::getline(in, row);) rows.push_back(row);
  return rows;
}

bool same_word(const std::string& one, const std::string& other) {
  if (one == other) return true;
  char* end = nullptr;
  const double value = std::strtod(one.c_str(), &end);
  if (*end != '\0') return false;
  // Expected figures have nine decimals at most, half a unit of which is 0.5e-9; the rest is for
  // the roundings of an angle's sine at lengths up to a metre.
  return std::abs(value - std::strtod(other.c_str(), nullptr)) < 1e-9;
}

/// Whether a motion's text says the same as the row expected, word by word.
bool same_motion(const std::string& text, const std::string& expected) {
  std::istringstream one(text), other(expected);
  std::string word, expected_word;
  while (other >> expected_word) {
    if (!(one >> word) || !same_word(word, expected_word)) return false;
  }
  return !(one >> word);
}

void check_motions(const Program& program, const std::vector<std::string>& expected) {
  CHECK(program.motions.size() == expected.size());
  for (std::size_t i = 0; i < std::min(program.motions.size(), expected.size()); ++i) {
    const std::string text = to_text(program.motions[i]);
    INFO("motion " << i + 1 << ": " << text << ", expected " << expected[i]);
    CHECK(same_motion(text, expected[i]));
  }
}

std::string ignored_text(const Program& program) {
  std::string text;
  for (const IgnoredWord& ignored : program.ignored)
    text.append(std::to_string(ignored.line)).append(" ").append(ignored.word).append("\n");
  return text;
}

/// The programs of fixtures/programs/controls/CONTROL/`kind`.
std::vector<std::filesystem::path> programs_of(Control control, const std::string& kind) {
  const std::string folder = "programs/controls/" + std::string(name(control)) + "/" + kind;
  std::vector<std::filesystem::path> files;
  for (const char* extension : {".ngc", ".nc", ".tap", ".mpf"}) {
    const auto found = fixture_files(folder, extension);
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

}  // namespace

TEST_CASE("every good program of a control gives its moves", "[unit][program]") {
  std::size_t count = 0;
  for (const Control control : kControls) {
    for (const std::filesystem::path& path : programs_of(control, "good")) {
      CAPTURE(path);
      ++count;
      try {
        const Program program = read_program(path, machine_for(path, control));
        check_motions(program, rows_of(text_beside(path, ".moves")));
        CHECK(ignored_text(program) == text_beside(path, ".ignored"));
        CHECK(program.has_end);
      } catch (const InputError& error) {
        FAIL_CHECK(error.what());
      }
    }
  }
  CHECK(count >= 60);
}

TEST_CASE("every bad program of a control gets its one error", "[unit][program]") {
  std::size_t count = 0;
  for (const Control control : kControls) {
    for (const std::filesystem::path& path : programs_of(control, "bad")) {
      ++count;
      const std::string error =
          message_of<InputError>([&] { read_program(path, machine_for(path, control)); });
      const std::string expected = text_beside(path, ".error");
      CHECK(error + "\n" ==
            path.string() + (expected.starts_with("error") ? ": " : ":") + expected);
    }
  }
  CHECK(count >= 40);
}

TEST_CASE("every good program gives its canonical moves", "[unit][program]") {
  const auto files = fixture_files("programs/good", ".ngc");
  REQUIRE(files.size() >= 160);
  for (const std::filesystem::path& path : files) {
    CAPTURE(path);
    try {
      const Program program = read_program(path, machine_for(path));
      CHECK(program.name == path.stem());
      check_motions(program, rows_of(text_beside(path, ".moves")));
      CHECK(ignored_text(program) == text_beside(path, ".ignored"));
    } catch (const InputError& error) {
      FAIL_CHECK(error.what());
    }
  }
}

TEST_CASE("every bad program gets its one error", "[unit][program]") {
  const auto files = fixture_files("programs/bad", ".ngc");
  REQUIRE(files.size() >= 290);
  for (const std::filesystem::path& path : files) {
    const std::string error =
        message_of<InputError>([&] { read_program(path, machine_for(path)); });
    CHECK(error + "\n" == path.string() + ":" + text_beside(path, ".error"));
  }
}
