#include "app/usage/usage_texts.h"

namespace limitgauge::app {
namespace {

/// The names of the options, as one word list of the shell.
std::string option_names(const CommandReference& command) {
  std::string out;
  for (const OptionReference& option : command.options) {
    if (option.positional) continue;
    for (const std::string& name : option.names) out += (out.empty() ? "" : " ") + name;
  }
  return out;
}

std::string bash_action(const ValueHint& hint) {
  if (!hint.words.empty()) {
    std::string words;
    for (const std::string& word : hint.words) words += (words.empty() ? "" : " ") + word;
    return "_limitgauge_words '" + words + "'";
  }
  switch (hint.kind) {
    case ValueHint::Kind::file:
      return "_limitgauge_files '" + hint.extension + "'";
    case ValueHint::Kind::folder:
      return "_limitgauge_folders";
    case ValueHint::Kind::text:
      break;
  }
  return ":";
}

/// "run:-o|run:--output".
std::string pattern(const CommandReference& command, const OptionReference& option) {
  std::string out;
  for (const std::string& name : option.names)
    out += (out.empty() ? "" : "|") + command.name + ":" + name;
  return out;
}

std::string value_cases(const CommandReference& program) {
  std::string out;
  for (const CommandReference& command : program.commands)
    for (const OptionReference& option : command.options)
      if (!option.positional && !option.value.empty())
        out +=
            "    " + pattern(command, option) + ") " + bash_action(option.hint) + "; return ;;\n";
  return out;
}

std::string word_cases(const CommandReference& program) {
  std::string names;
  for (const CommandReference& command : program.commands)
    names += (names.empty() ? "" : " ") + command.name;
  std::string out = "    '') options='" + option_names(program) + "'; words='" + names + "' ;;\n";
  for (const CommandReference& command : program.commands) {
    out += "    " + command.name + ") options='" + option_names(command) + "' ;;\n";
  }
  return out;
}

std::string argument_cases(const CommandReference& program) {
  std::string out;
  for (const CommandReference& command : program.commands)
    for (const OptionReference& option : command.options)
      if (option.positional)
        out += "      " + command.name + ") " + bash_action(option.hint) + " ;;\n";
  return out;
}

constexpr const char* kHelpers = R"(# Written by the program from the options that it parses.

_limitgauge_files() {
  compopt -o filenames 2>/dev/null
  local pattern='*'
  [ -z "$1" ] || pattern="*.$1"
  mapfile -t COMPREPLY < <(compgen -f -X "!$pattern" -- "$cur"; compgen -d -- "$cur")
  mapfile -t COMPREPLY < <(printf '%s\n' "${COMPREPLY[@]}" | sort -u | sed '/^$/d')
}

_limitgauge_folders() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$cur")
}

_limitgauge_words() {
  compopt -o nospace 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$cur")
}

)";

constexpr const char* kBegin = R"(_limitgauge() {
  local cur=${COMP_WORDS[COMP_CWORD]} at=$COMP_CWORD command='' word option options='' words=''
  COMPREPLY=()
  # The shell splits words at = and : and hands these over as words of their own.
  if [ "$cur" = : ] || [ "$cur" = = ]; then
    cur=''
    at=$((at + 1))
  fi
  option=${COMP_WORDS[at - 1]}
  if [ "$option" = : ]; then
    # Behind mesh: or vdb: there is a file, behind ball: and the like there are numbers.
    case ${COMP_WORDS[at - 2]} in mesh | vdb) _limitgauge_files '' ;; esac
    return
  fi
  [ "$option" != = ] || option=${COMP_WORDS[at - 2]}
  for word in "${COMP_WORDS[@]:1:COMP_CWORD - 1}"; do
    case $word in
      -*) ;;
      *) command=$word; break ;;
    esac
  done
  case $command:$option in
)";

constexpr const char* kChoice = R"(  esac
  if [[ $cur == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$cur")
  elif [ -n "$words" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$cur")
  else
    case $command in
)";

constexpr const char* kEnd = R"(    esac
  fi
}
complete -F _limitgauge limitgauge
)";

}  // namespace

std::string bash_completion(const CommandReference& program) {
  std::string out = std::string(kHelpers) + kBegin + value_cases(program);
  return out + "  esac\n  case $command in\n" + word_cases(program) + kChoice +
         argument_cases(program) + kEnd;
}

}  // namespace limitgauge::app
