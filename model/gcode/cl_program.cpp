#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <string>

#include "model/base/angle.h"
#include "model/base/text_file.h"
#include "model/gcode/cl_data.h"
#include "model/gcode/program_path.h"
#include "model/text/characters.h"

namespace limitgauge::model {
namespace {

constexpr std::array<std::string_view, 4> kEndings = {".apt", ".cl", ".cls", ".ncl"};
/// What a program in CL data may begin with; no program in G-code has a slash there.
constexpr std::array<std::string_view, 9> kFirstWords = {
    "UNITS", "CUTTER", "LOADTL", "FROM", "GOTO", "FEDRAT", "SPINDL", "COOLNT", "MULTAX"};
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

std::string at_line(std::uint32_t line) {
  return "line " + std::to_string(line) + ": ";
}

/// How the tool stands, in the machine's frame, and what is taken for granted of that.
void take_axes(const ClData& data, double frame_turn_deg, Program& program) {
  if (data.axes.empty()) return;
  const auto along = [&](const Vec3& axis) { return turned(axis, frame_turn_deg); };
  ToolAxes axes{along(data.from_axis.value_or(data.axes.front())), {}};
  for (const Vec3& axis : data.axes) axes.to.push_back(along(axis));
  program.axes = std::move(axes);
  if (!data.from)
    program.assumed.push_back(at_line(data.moves.front().line) +
                              "the tool is taken to stand before the first GOTO as it does then");
  if (data.turning_line != 0)
    program.assumed.push_back(at_line(data.turning_line) +
                              "while the tip goes straight, the tool's axis is taken to go evenly "
                              "along the great circle between its ends");
  if (data.kept_axis_line != 0)
    program.assumed.push_back(at_line(data.kept_axis_line) +
                              "three figures are taken to leave the tool's axis as it was");
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
  if (!data.units_are_stated && !data.moves.empty())
    program.assumed.push_back(at_line(data.moves.front().line) +
                              "lengths are taken to be in millimetres: nothing says UNITS");
  if (data.cutter)
    program.assumed.push_back("line " + std::to_string(data.cutter_line) + ": " +
                              data.cutter_as_stated +
                              " is not acted on, the tool stated is cut with");
  const WorkOffset g54 = machine.work_offsets.front().value_or(WorkOffset());
  const RigidPlacement to_machine{g54.rotation_deg, g54.origin_mm};
  take_start(data, machine, program);
  take_axes(data, g54.rotation_deg, program);
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
