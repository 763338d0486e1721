#include "app/usage/usage_texts.h"

namespace limitgauge::app {
namespace {

/// `text` within single quotes.
std::string fish_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') out += '\\';
    out += c;
  }
  return out + "'";
}

/// What the shell offers for a value: the options of `complete`.
std::string offered(const ValueHint& hint) {
  if (!hint.words.empty()) {
    std::string words;
    for (const std::string& word : hint.words) words += (words.empty() ? "" : " ") + word;
    return " -x -a " + fish_quoted(words);
  }
  switch (hint.kind) {
    case ValueHint::Kind::file:
      if (hint.extension.empty()) return " -r -F";
      return " -x -a " + fish_quoted("(__fish_complete_suffix ." + hint.extension + ")");
    case ValueHint::Kind::folder:
      return " -x -a " + fish_quoted("(__fish_complete_directories)");
    case ValueHint::Kind::text:
      break;
  }
  return " -x";
}

std::string named(const OptionReference& option) {
  std::string out;
  for (const std::string& name : option.names)
    out += name.size() > 2 ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.value.empty()) out += offered(option.hint);
  return out + " -d " + fish_quoted(option.summary);
}

/// A positional argument: files are what the shell offers where it is not told otherwise.
std::string argument(const OptionReference& option) {
  if (option.hint.kind == ValueHint::Kind::file && option.hint.extension.empty()) return " -F";
  return " -k" + offered(option.hint);
}

std::string lines(const CommandReference& command, const std::string& condition) {
  std::string out;
  for (const OptionReference& option : command.options)
    out += "complete -c limitgauge -n " + fish_quoted(condition) +
           (option.positional ? argument(option) : named(option)) + "\n";
  return out;
}

}  // namespace

std::string fish_completion(const CommandReference& program) {
  std::string out =
      "# Written by the program from the options that it parses.\n\ncomplete -c limitgauge -f\n";
  out += lines(program, "__fish_use_subcommand");
  for (const CommandReference& command : program.commands) {
    out += "\ncomplete -c limitgauge -n __fish_use_subcommand -a " + command.name + " -d " +
           fish_quoted(command.summary) + "\n";
    out += lines(command, "__fish_seen_subcommand_from " + command.name);
  }
  return out;
}

}  // namespace limitgauge::app
