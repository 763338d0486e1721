#include "app/usage/usage_texts.h"

namespace limitgauge::app {
namespace {

/// `text` within single quotes.
std::string zsh_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      out += c;
    }
  }
  return out + "'";
}

/// `text` where brackets, colons and backslashes mean something to _arguments.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_action(const ValueHint& hint) {
  if (!hint.words.empty()) {
    std::string out = "{compadd -S \"\" --";
    for (const std::string& word : hint.words) out += " " + word;
    return out + "}";
  }
  switch (hint.kind) {
    case ValueHint::Kind::file:
      return hint.extension.empty() ? "_files" : "_files -g \"*." + hint.extension + "\"";
    case ValueHint::Kind::folder:
      return "_files -/";
    case ValueHint::Kind::text:
      break;
  }
  return " ";
}

/// One specification of _arguments for each name: with it, the option's other names are used up.
std::string specification(const OptionReference& option) {
  const std::string value =
      option.value.empty() ? "" : ":" + escaped(option.value) + ":" + zsh_action(option.hint);
  if (option.positional)
    return " " + zsh_quoted("*:" + escaped(option.names.front()) + ":" + zsh_action(option.hint));
  std::string others;
  for (const std::string& name : option.names) others += (others.empty() ? "" : " ") + name;
  std::string out;
  for (const std::string& name : option.names) {
    const bool is_long = name.size() > 2;
    const std::string mark = option.value.empty() ? "" : is_long ? "=" : "+";
    const std::string before = option.repeatable ? "*" : "(" + others + ")";
    out += " " + zsh_quoted(before + name + mark + "[" + escaped(option.summary) + "]" + value);
  }
  return out;
}

std::string arguments(const CommandReference& command) {
  std::string out;
  for (const OptionReference& option : command.options) {
    const std::string one = specification(option);
    out += " \\\n       " + one;
  }
  return out;
}

}  // namespace

std::string zsh_completion(const CommandReference& program) {
  std::string out =
      "#compdef limitgauge\n# Written by the program from the options that it parses.\n\n"
      "_limitgauge() {\n  local context state state_descr line\n  typeset -A opt_args\n"
      "  local -a commands\n  commands=(\n";
  for (const CommandReference& command : program.commands)
    out += "    " + zsh_quoted(command.name + ":" + command.summary) + "\n";
  out += "  )\n  _arguments -C" + arguments(program) +
         " \\\n        '1:command:->command' \\\n        '*::argument:->argument'\n"
         "  case $state in\n    command) _describe command commands ;;\n    argument)\n"
         "      case $line[1] in\n";
  for (const CommandReference& command : program.commands)
    out += "        " + command.name + ") _arguments" + arguments(command) + " ;;\n";
  return out +
         "      esac ;;\n  esac\n}\n\n"
         "if [ \"$funcstack[1]\" = _limitgauge ]; then\n  _limitgauge \"$@\"\nelse\n"
         "  compdef _limitgauge limitgauge\nfi\n";
}

}  // namespace limitgauge::app
