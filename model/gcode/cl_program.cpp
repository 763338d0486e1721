#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <string>

#include "model/base/text_file.h"
#include "model/gcode/cl_data.h"
#include "model/gcode/program_path.h"
#include "model/text/characters.h"

namespace limitgauge::model {
namespace {

constexpr std::array<std::string_view, 4> kEndings = {".apt", ".cl", ".cls", ".ncl"};
/// What a program in CL data may begin with; no program in G-code has a slash there.
constexpr std::array<std::string_view, 8> kFirstWords = {"UNITS", "CUTTER", "LOADTL", "FROM",
                                                         "GOTO",  "FEDRAT", "SPINDL", "COOLNT"};
constexpr std::array<std::string_view, 3> kFirstTexts = {"PARTNO", "PPRINT", "REMARK"};
constexpr std::string_view kBlanks = " \t\r\n";

bool holds(std::span<const std::string_view> words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool begins_as_cl_data(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  if (text.starts_with("$$")) return true;
  const auto end = std::find_if_not(text.begin(), text.end(), is_letter);
  std::string word(text.begin(), end);
  std::transform(word.begin(), word.end(), word.begin(), upper);
  if (holds(kFirstTexts, word)) return true;
  const auto next = std::find_if(end, text.end(), [](char c) { return c != ' ' && c != '\t'; });
  return holds(kFirstWords, word) && next != text.end() && *next == '/';
}

void take_start(const ClData& data, const MachineSetup& machine, Program& program) {
  if (!data.from) return;
  const bool stated = machine.start_mm && !machine.start_is_assumed;
  if (!stated) {
    for (int axis = 0; axis < 3; ++axis)
      program.start_said_mm[static_cast<std::size_t>(axis)] = (*data.from)[axis];
  } else if (!(*machine.start_mm == *data.from)) {
    program.assumed.push_back("line " + std::to_string(data.from_line) + ": " +
                              data.from_as_stated +
                              " is not acted on, the tool starts where it is stated to");
  }
}

}  // namespace

bool is_cl_data(std::string_view text, const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), lower);
  return holds(kEndings, ending) || begins_as_cl_data(text);
}

Program to_program(const ClData& data, const std::string& name, const MachineSetup& machine) {
  Program program;
  program.name = std::filesystem::path(name).stem().string();
  program.ignored = data.ignored;
  if (data.tool) program.tool_changes.push_back({data.tool_line, 0, *data.tool});
  if (data.cutter)
    program.assumed.push_back("line " + std::to_string(data.cutter_line) + ": " +
                              data.cutter_as_stated +
                              " is not acted on, the tool stated is cut with");
  const WorkOffset g54 = machine.work_offsets.front().value_or(WorkOffset());
  const RigidPlacement to_machine{g54.rotation_deg, g54.origin_mm};
  take_start(data, machine, program);
  program.motions.reserve(data.moves.size());
  for (const Move& move : data.moves) {
    Motion& motion = program.motions.emplace_back();
    motion.kind = move.kind == MoveKind::rapid ? MotionKind::rapid : MotionKind::feed;
    motion.line = move.line;
    motion.feed_mm_min = move.feed_mm_min;
    motion.to = to_machine(move.to);
  }
  return program;
}

}  // namespace limitgauge::model
