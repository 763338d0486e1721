#include <algorithm>
#include <set>
#include <sstream>

#include "model/base/memory.h"
#include "model/base/text_file.h"
#include "model/gcode/cl_data.h"
#include "model/gcode/flow/flow.h"
#include "model/gcode/program.h"
#include "model/gcode/read/interpreter.h"
#include "model/gcode/read/subprogram_files.h"
#include "model/gcode/text/lexer.h"
#include "model/gcode/text/program_text.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model {
namespace {

/// Shortest line that moves the tool, for the guess at how many motions will come: `X1` and its
/// end.
constexpr std::size_t kShortestMoveBytes = 8;
/// Motions beyond one a line, for loops and cycles; more would be a program that does not end.
constexpr std::size_t kExpandedMotions = 5'000'000 / gcode::kFlowShare;

/// Goes over the plain lines that come next and carries them out.
void take_plain_lines(gcode::Lexer& lexer, gcode::Interpreter& interpreter) {
  gcode::PlainLine line;
  while (lexer.see_plain(line) && interpreter.move_plainly(line)) lexer.pass_plain();
}

/// The program of a text in plain characters.
Program read_plain(std::string_view text, const std::string& name, const MachineSetup& machine) {
  Program program;
  program.name = std::filesystem::path(name).stem().string();
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  program.motions.reserve(std::min(lines, text.size() / kShortestMoveBytes) + 1);
  prefer_large_pages(program.motions.data(), program.motions.capacity() * sizeof(Motion));
  gcode::Parameters parameters;
  gcode::Lexer lexer(text, name, parameters, gcode::rules_of(machine.control));
  if (machine.kinematics)
    for (const RotaryAxis& axis : machine.kinematics->axes)
      lexer.set_rotary(lexer.rotary() | gcode::letter_bit(axis.word));
  gcode::Flow flow(lexer, parameters, {}, gcode::subprograms_in(machine.subprograms));
  gcode::Interpreter interpreter(program, machine, lexer, parameters, lines + kExpandedMotions);
  gcode::Block block;
  bool goes_on = true;
  while (goes_on && flow.next(block)) {
    if (lexer.rules().rounds_calculated) interpreter.round_calculated(block);
    goes_on = interpreter.execute(gcode::Statement(block, lexer));
    if (goes_on && interpreter.goes_plainly() && flow.goes_straight())
      take_plain_lines(lexer, interpreter);
  }
  // What begins with '%' ends with it: the lexer has seen to that.
  program.has_end = !goes_on || lexer.begins_with_percent() || lexer.ended_by_percent();
  program.ends_in_line = text.ends_with('\n');
  interpreter.finish();
  return program;
}

}  // namespace

Program read_program(std::string_view text, const std::string& name, const MachineSetup& machine) {
  const std::string decoded = as_program_text(text, name);
  if (!decoded.empty()) text = decoded;
  if (is_cl_data(text, name)) {
    std::istringstream in{std::string(text)};
    return to_program(read_cl_data(in, name), name, machine);
  }
  gcode::check_language(text, name);
  std::vector<gcode::MendedCharacter> characters;
  const std::string mended = gcode::mended(text, characters);
  Program program = read_plain(mended.empty() ? text : mended, name, machine);
  std::set<std::string> told;
  for (const gcode::MendedCharacter& character : characters) {
    if (told.insert(character.what).second)
      program.assumed.push_back("line " + std::to_string(character.line) + ": " + character.what);
  }
  return program;
}

const AxisTurn* Program::turn_of(std::size_t motion) const {
  const auto found = std::ranges::lower_bound(turns, motion, {}, &AxisTurn::motion);
  return found != turns.end() && found->motion == motion ? &*found : nullptr;
}

const TipPlace* Program::tip_place_of(std::size_t motion) const {
  const auto found = std::ranges::lower_bound(tip_places, motion, {}, &TipPlace::motion);
  return found != tip_places.end() && found->motion == motion ? &*found : nullptr;
}

std::string missing_end_words(const Program& program) {
  return std::string("ends without M2, M30 or '%'") +
         (program.ends_in_line ? "" : ", and its last line without a line end") +
         ": taken to be whole, it may have been cut off";
}

Program read_program(const std::filesystem::path& path, const MachineSetup& machine) {
  return read_program(std::string_view(read_program_text(path)), path.string(), machine);
}

Program read_program(std::istream& in, const std::string& name_in_errors,
                     const MachineSetup& machine) {
  return read_program(std::string_view(read_text(in, name_in_errors)), name_in_errors, machine);
}

}  // namespace limitgauge::model
