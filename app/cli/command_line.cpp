#include "app/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <thread>

#include "app/cli/command_definition.h"
#include "app/run/gate_limits.h"
#include "app/usage/usage_texts.h"
#include "model/text/message_text.h"

namespace limitgauge::app {
namespace {

std::vector<const CLI::App*> commands_of(CLI::App& app) {
  const std::vector<CLI::App*> all = app.get_subcommands([](CLI::App*) { return true; });
  return {all.begin(), all.end()};
}

std::vector<std::string> command_names(CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : commands_of(app)) names.push_back(sub->get_name());
  return names;
}

/// "run, plan or view".
std::string list(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

/// A word that is no command, before the library says so in its own way.
void refuse_unknown_command(int argc, const char* const* argv, CLI::App& app) {
  if (argc < 2 || argv[1][0] == '-') return;
  const std::string_view word = argv[1];
  const std::vector<std::string> names = command_names(app);
  if (std::find(names.begin(), names.end(), word) != names.end()) return;
  const std::vector<std::string_view> known(names.begin(), names.end());
  throw UsageError("unknown command " + model::in_quotes(word) + "; expected " +
                   model::in_quotes(model::nearest_word(word, known)) + " or another of " +
                   list(names));
}

/// The long options of one command, as they are typed: "--threads".
std::vector<std::string> long_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// "one of verify or cut", which have an option of this name; empty where none has.
std::string of_other_commands(CLI::App& app, const std::string& name) {
  std::vector<std::string> having;
  for (const CLI::App* sub : commands_of(app))
    if (sub->get_option_no_throw(name) != nullptr) having.push_back(sub->get_name());
  return having.empty() ? "" : "it is one of " + list(having);
}

/// What to do about `name`, which `command` does not know.
std::string remedy(CLI::App& app, const CLI::App& command, const std::string& name) {
  if (std::string others = of_other_commands(app, name); !others.empty()) return others;
  const std::vector<std::string> names = long_options(command);
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string meant = model::meant_word(name, known);
  return meant.empty() ? "expected one that it has" : "expected " + model::in_quotes(meant);
}

/// Of a command line that the library could not read: a flag that is mistyped comes before what is
/// missing for want of it.
void refuse_unknown_option(int argc, const char* const* argv, CLI::App& app) {
  const std::vector<const CLI::App*> all = commands_of(app);
  const auto command = std::find_if(all.begin(), all.end(), [&](const CLI::App* one) {
    return argc > 1 && one->get_name() == argv[1];
  });
  if (command == all.end()) return;
  for (int i = 2; i < argc && argv[i] != std::string_view("--"); ++i) {
    const std::string word = argv[i];
    if (!word.starts_with("--")) continue;
    const std::string name = word.substr(0, word.find('='));
    if (const CLI::Option* known = (*command)->get_option_no_throw(name)) {
      // The next word is its value, whatever that begins with.
      if (name == word && known->get_items_expected_max() > 0) ++i;
      continue;
    }
    throw UsageError("unknown option " + model::in_quotes(name) + " of " + (*command)->get_name() +
                     "; " + remedy(app, **command, name) + "; see limitgauge " +
                     (*command)->get_name() + " --help");
  }
}

/// `--generate man|bash|zsh|fish`: for the build and for packagers, not for users; no option of the
/// library, so that it stands in none of the texts that it writes.
std::optional<std::string> generated(int argc, const char* const* argv,
                                     const CommandReference& program) {
  if (argc < 2 || argv[1] != std::string_view("--generate")) return std::nullopt;
  const std::string_view what = argc == 3 ? argv[2] : "";
  if (what == "man") return man_page(program, LIMITGAUGE_VERSION);
  if (what == "bash") return bash_completion(program);
  if (what == "zsh") return zsh_completion(program);
  if (what == "fish") return fish_completion(program);
  throw UsageError("--generate writes one text; expected man, bash, zsh or fish");
}

void check_combinations(const std::string& command, const CommonOptions& common) {
  const bool has_job = command == "run" || command == "plan" || command == "verify" ||
                       command == "cut" || command == "study";
  if (!has_job && !common.overrides.empty()) {
    throw UsageError(
        "--set overrides a key of a job and this command reads none; "
        "expected it with run, plan, verify, cut or study");
  }
  if (common.quiet && common.verbose) {
    throw UsageError("--quiet and --verbose contradict each other; expected one of them");
  }
  const bool has_result = command == "run" || command == "verify" || command == "cut" ||
                          command == "compare" || command == "probe";
  if (common.json && !has_result) {
    throw UsageError("--json prints the result of a run and " + command +
                     " has none; expected it with run, verify, cut, compare or probe");
  }
}

void check_coverage(const std::string& command, const Parsed& parsed) {
  // With --set the limits may be stated there: they are looked at when it has been read.
  if (command == "verify" && parsed.common.overrides.empty() &&
      !coverage_has_limit(parsed.verify.limits))
    throw UsageError(std::string("--coverage: ") + kCoverageWithoutLimit + "; expected " +
                     kCoverageExpected);
}

CommonOptions common_options(const Parsed& parsed) {
  CommonOptions common = parsed.common;
  const unsigned all = std::max(1U, std::thread::hardware_concurrency());
  common.threads = parsed.threads > 0 ? static_cast<unsigned>(parsed.threads) : all;
  return common;
}

Command chosen(const std::string& command, const Parsed& parsed) {
  if (command == "run") return parsed.run;
  if (command == "plan") return parsed.plan;
  if (command == "verify") return parsed.verify;
  if (command == "cut") return parsed.cut;
  if (command == "inspect") return parsed.inspect;
  if (command == "compare") return parsed.compare;
  if (command == "probe") return parsed.probe;
  if (command == "study") return parsed.study;
  if (command == "history") return parsed.history;
  return parsed.view;
}

std::string help_of(const CLI::App& app, const CommandReference& program) {
  const std::vector<CLI::App*> asked = app.get_subcommands();
  for (const CommandReference& command : program.commands)
    if (!asked.empty() && command.name == asked.front()->get_name())
      return command_help(program.name, command);
  return program_help(program);
}

}  // namespace

CommandLine parse_command_line(int argc, const char* const* argv) {
  CommandDefinition definition;
  CLI::App& app = definition.app();
  refuse_unknown_command(argc, argv, app);
  if (std::optional<std::string> text = generated(argc, argv, definition.reference()))
    return {PrintCommand{*std::move(text)}, {}};
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {PrintCommand{help_of(app, definition.reference())}, {}};
  } catch (const CLI::CallForVersion& version) {
    return {PrintCommand{std::string(version.what()) + "\n"}, {}};
  } catch (const CLI::ParseError& error) {
    refuse_unknown_option(argc, argv, app);
    throw UsageError(std::string(error.what()) + "; see limitgauge --help");
  }
  const std::string command = app.get_subcommands().front()->get_name();
  const CommonOptions common = common_options(definition.parsed());
  check_combinations(command, common);
  check_coverage(command, definition.parsed());
  return {chosen(command, definition.parsed()), common};
}

CommandReference command_reference() {
  return CommandDefinition().reference();
}

}  // namespace limitgauge::app
