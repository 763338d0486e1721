#include "app/usage/usage_texts.h"

#include <algorithm>
#include <sstream>

#include "app/usage/usage_notes.h"

namespace limitgauge::app {
namespace {

constexpr std::size_t kTerminalWidth = 80;
constexpr std::size_t kNameColumn = 26;
constexpr std::size_t kIndent = 2;

/// `text` after what stands on the line already, `at` columns, broken at spaces; all of it from
/// column `column` on.
std::string in_column(const std::string& text, std::size_t at, std::size_t column) {
  const std::string fresh = '\n' + std::string(column, ' ');
  std::string out;
  if (at > 0 && at + 1 > column) {
    out = fresh;
    at = column;
  }
  out += std::string(column - std::min(at, column), ' ');
  at = column;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (at > column && at + 1 + word.size() > kTerminalWidth) {
      out += fresh;
      at = column;
    }
    if (at > column) {
      out += ' ';
      ++at;
    }
    out += word;
    at += word.size();
  }
  return out + '\n';
}

std::string entry(const std::string& name, const std::string& text) {
  return std::string(kIndent, ' ') + name + in_column(text, kIndent + name.size(), kNameColumn);
}

std::string notes(const std::string& title, std::span<const UsageNote> notes) {
  std::string out = "\n" + title + ":\n";
  for (const UsageNote& note : notes) out += entry(std::string(note.name), std::string(note.text));
  return out;
}

std::string options_of(const CommandReference& command, bool positional) {
  std::string out;
  for (const OptionReference& option : command.options)
    if (option.positional == positional) out += entry(signature(option), summary(option));
  return out;
}

}  // namespace

std::string signature(const OptionReference& option) {
  std::string text;
  for (const std::string& name : option.names) text += (text.empty() ? "" : ",") + name;
  if (option.positional || option.value.empty()) return text;
  return text + " " + option.value;
}

std::string synopsis(const std::string& program, const CommandReference& command) {
  std::string text = program + " " + command.name;
  for (const OptionReference& option : command.options) {
    if (option.required && !option.positional)
      text += " " + option.names.back() + " " + option.value;
  }
  text += " [OPTIONS]";
  for (const OptionReference& option : command.options)
    if (option.positional) text += " " + option.names.front();
  return text;
}

std::string summary(const OptionReference& option) {
  const bool required = option.required && !option.positional;
  if (required && option.repeatable) return option.summary + " (required, repeatable)";
  if (required) return option.summary + " (required)";
  return option.repeatable ? option.summary + " (repeatable)" : option.summary;
}

std::string command_help(const std::string& program, const CommandReference& command) {
  const std::string usage = "Usage:";
  std::string out = command.summary + ".\n\n" + usage;
  out += in_column(synopsis(program, command), usage.size(), usage.size() + 1);
  if (const std::string arguments = options_of(command, true); !arguments.empty())
    out += "\nArguments:\n" + arguments;
  return out + "\nOptions:\n" + options_of(command, false);
}

std::string program_help(const CommandReference& program) {
  std::string out = program.summary + "\n\nUsage: " + program.name + " COMMAND [OPTIONS]\n";
  out += "\nCommands (" + program.name + " COMMAND --help lists their options):\n";
  for (const CommandReference& command : program.commands)
    out += entry(command.name, command.summary);
  out += "\nOptions:\n" + options_of(program, false);
  out += notes("Exit codes", exit_code_notes());
  out += notes("Files in the output folder", file_notes());
  return out + notes("Environment", environment_notes());
}

}  // namespace limitgauge::app
