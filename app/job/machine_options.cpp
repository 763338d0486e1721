#include "app/job/machine_options.h"

#include <cmath>

#include "app/cli/usage_error.h"
#include "app/tolerance.h"
#include "model/base/coordinate_limit.h"
#include "model/base/text_file.h"
#include "model/text/characters.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

std::vector<double> numbers_of(const std::string& option, const std::string& text,
                               std::string_view list, std::size_t least, std::size_t most) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t comma = std::min(list.find(',', at), list.size());
    const auto value = model::parse_number(list.substr(at, comma - at));
    if (!value)
      throw UsageError(option + " " + text + ": \"" + std::string(list.substr(at, comma - at)) +
                       "\" is no number; expected numbers with commas between them");
    numbers.push_back(*value);
    at = comma + 1;
  }
  if (numbers.size() < least || numbers.size() > most)
    throw UsageError(option + " " + text + ": " + std::to_string(numbers.size()) +
                     " numbers; expected X,Y,Z" + (most > least ? " or X,Y,Z,TURN" : ""));
  return numbers;
}

model::Vec3 near_point(const std::string& option, const std::string& text,
                       const std::vector<double>& values) {
  const model::Vec3 point_mm{values[0], values[1], values[2]};
  if (!model::is_near(point_mm))
    throw UsageError(option + " " + text + ": " + model::farthest_words(point_mm) + "; expected " +
                     model::kFarthestExpected);
  return point_mm;
}

/// P of `G54.1P7` and `G154P7`, blanks between or not; nothing for any other name.
std::optional<int> extended_offset(const std::string& name) {
  std::string plain;
  for (const char c : name)
    if (!model::is_blank(c)) plain += model::upper(c);
  const std::size_t head = plain.starts_with("G54.1P") ? 6 : plain.starts_with("G154P") ? 5 : 0;
  const auto number =
      head == 0 ? std::nullopt : model::parse_number(std::string_view(plain).substr(head));
  constexpr double kMost = 300;
  if (!number || *number < 1 || *number > kMost || *number != std::floor(*number))
    return std::nullopt;
  return static_cast<int>(*number);
}

/// `G54` to `G59.3`, in capitals or not.
std::size_t offset_index(const std::string& text, std::string name) {
  for (char& c : name)
    if (c == 'g') c = 'G';
  for (std::size_t i = 0; i < model::kWorkOffsets; ++i)
    if (model::work_offset_name(i) == name) return i;
  throw UsageError("--work-offset " + text + ": \"" + name +
                   "\" is no work offset; expected G54 to G59 or G59.1 to G59.3, or G54.1P1 to "
                   "G54.1P300");
}

void add_offset(const std::string& text, model::MachineSetup& machine) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos)
    throw UsageError("--work-offset " + text + ": expected G54=X,Y,Z or G54=X,Y,Z,TURN");
  const auto extended = extended_offset(text.substr(0, equals));
  const std::size_t index = extended ? model::kWorkOffsets + static_cast<std::size_t>(*extended - 1)
                                     : offset_index(text, text.substr(0, equals));
  const std::vector<double> values =
      numbers_of("--work-offset", text, std::string_view(text).substr(equals + 1), 3, 4);
  if (extended ? machine.extended_offsets.contains(*extended)
               : machine.work_offsets[index].has_value())
    throw UsageError("--work-offset " + text + ": " + model::work_offset_name(index) +
                     " is stated twice; expected it once");
  const double turn_deg = values.size() > 3 ? values[3] : 0;
  if (std::abs(turn_deg) > kLargestAngle_deg)
    throw UsageError("--work-offset " + text + ": a turn of " + model::six_digits(turn_deg) +
                     " degrees; expected " + kAngleExpected);
  const model::WorkOffset offset{near_point("--work-offset", text, values), turn_deg};
  if (extended) {
    machine.extended_offsets[*extended] = offset;
  } else {
    machine.work_offsets[index] = offset;
  }
}

void add_control(const MachineOptions& options, model::MachineSetup& machine) {
  if (!options.control.empty()) {
    const auto control = model::control_named(options.control);
    if (!control)
      throw UsageError("--control " + options.control + ": no such control; expected " +
                       control_names());
    machine.control = *control;
    machine.control_is_stated = true;
  }
  if (options.subprograms.empty()) return;
  std::error_code failure;
  if (!std::filesystem::is_directory(options.subprograms, failure))
    throw UsageError("--subprograms " + options.subprograms.string() +
                     ": no such folder; expected one with a file for each subprogram");
  machine.subprograms = options.subprograms;
}

}  // namespace

model::Vec3 point_of(const std::string& option, const std::string& text) {
  return near_point(option, text, numbers_of(option, text, text, 3, 3));
}

std::string stated_option(const MachineOptions& options) {
  if (!options.control.empty()) return "--control";
  if (!options.subprograms.empty()) return "--subprograms";
  if (!options.work_offsets.empty()) return "--work-offset";
  if (!options.home.empty()) return "--home";
  if (!options.second_home.empty()) return "--second-home";
  if (!options.start.empty()) return "--start";
  return options.tool_table.empty() ? "" : "--tool-table";
}

std::string control_names() {
  std::string names;
  for (const model::Control control : model::kControls) {
    if (!names.empty()) names += control == model::kControls.back() ? " or " : ", ";
    names += model::name(control);
  }
  return names;
}

model::MachineSetup machine_of(const MachineOptions& options) {
  model::MachineSetup machine;
  add_control(options, machine);
  for (const std::string& text : options.work_offsets) add_offset(text, machine);
  if (!options.home.empty()) machine.home_mm = point_of("--home", options.home);
  if (!options.second_home.empty())
    machine.second_home_mm = point_of("--second-home", options.second_home);
  if (!options.start.empty()) machine.start_mm = point_of("--start", options.start);
  if (!options.tool_table.empty())
    machine.tools = model::parse_tool_table(model::read_text_file(options.tool_table),
                                            options.tool_table.string());
  return machine;
}

}  // namespace limitgauge::app
