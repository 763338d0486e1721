#include <functional>
#include <sstream>

#include "app/cli/command_line.h"
#include "app/usage/usage_notes.h"
#include "app/usage/usage_texts.h"
#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

using Visit = std::function<void(const CommandReference&, const OptionReference&)>;

void for_each_option(const CommandReference& program, const Visit& visit) {
  for (const OptionReference& option : program.options) visit(program, option);
  for (const CommandReference& command : program.commands)
    for (const OptionReference& option : command.options) visit(command, option);
}

const OptionReference& option_of(const CommandReference& program, const std::string& command,
                                 const std::string& name) {
  for (const CommandReference& one : program.commands)
    for (const OptionReference& option : one.options)
      if (one.name == command && option.names.back() == name) return option;
  throw std::runtime_error("no option " + name);
}

TEST_CASE("what is told of the options is what the parser knows", "[unit][usage]") {
  const CommandReference program = command_reference();
  CHECK(program.name == "limitgauge");
  std::vector<std::string> names;
  for (const CommandReference& command : program.commands) names.push_back(command.name);
  CHECK(names == std::vector<std::string>{"run", "plan", "verify", "cut", "inspect", "compare",
                                          "probe", "study", "history", "view"});
  const OptionReference& output = option_of(program, "run", "--output");
  CHECK(output.names == std::vector<std::string>{"-o", "--output"});
  CHECK(output.value == "DIR");
  CHECK(output.hint.kind == ValueHint::Kind::folder);
  CHECK_FALSE(output.required);
  const OptionReference& job = option_of(program, "run", "JOB");
  CHECK(job.positional);
  CHECK(job.required);
  CHECK(job.hint.extension == "toml");
  const OptionReference& tool = option_of(program, "verify", "--tool");
  CHECK(tool.required);
  CHECK(tool.repeatable);
  CHECK(tool.hint.words.size() == 6);
  CHECK(option_of(program, "view", "--no-browser").value.empty());
  CHECK_FALSE(option_of(program, "view", "--port").repeatable);
}

TEST_CASE("every option has words for itself and a name for its value", "[unit][usage]") {
  for_each_option(command_reference(),
                  [](const CommandReference& command, const OptionReference& option) {
                    CAPTURE(command.name, option.names.front());
                    CHECK_FALSE(option.summary.empty());
                    CHECK(option.value.find("TEXT") == std::string::npos);
                    CHECK(option.value.find(':') == std::string::npos);
                  });
}

TEST_CASE("help fits 80 columns and names every option", "[unit][usage]") {
  const CommandReference program = command_reference();
  std::string all = program_help(program);
  for (const CommandReference& command : program.commands) {
    const std::string help = command_help(program.name, command);
    for (const OptionReference& option : command.options)
      CHECK_THAT(help, ContainsSubstring("  " + signature(option)));
    all += help;
  }
  std::istringstream in(all);
  for (std::string line; std::getline(in, line);) {
    CAPTURE(line);
    CHECK(line.size() <= 80);
    CHECK((line.empty() || line.back() != ' '));
  }
}

TEST_CASE("help of the program lists exit codes, files and environment", "[unit][usage]") {
  const std::string help = program_help(command_reference());
  for (const auto& notes : {exit_code_notes(), file_notes(), environment_notes()})
    for (const UsageNote& note : notes)
      CHECK_THAT(help, ContainsSubstring("\n  " + std::string(note.name)));
  CHECK_THAT(help, ContainsSubstring("NO_COLOR") && ContainsSubstring("report.html"));
}

TEST_CASE("the manual page has its sections and every option", "[unit][usage]") {
  const CommandReference program = command_reference();
  const std::string page = man_page(program, "9.8.7");
  std::size_t at = 0;
  for (const char* section : {"NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "COMMANDS",
                              "EXIT STATUS", "FILES", "ENVIRONMENT", "EXAMPLES", "SEE ALSO"}) {
    const std::size_t next = page.find(std::string(".SH ") + section + "\n", at);
    CAPTURE(section);
    REQUIRE(next != std::string::npos);
    at = next;
  }
  CHECK_THAT(page, ContainsSubstring("limitgauge 9.8.7"));
  CHECK_THAT(page, ContainsSubstring("\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIDIR\\fR"));
  for (const CommandReference& command : program.commands)
    CHECK_THAT(page, ContainsSubstring(".SS " + command.name + "\n"));
}

TEST_CASE("text in a manual page is no request and no escape", "[unit][usage]") {
  CommandReference program{"p", "S.", {}, {}};
  program.options.push_back({{"--x"}, false, false, false, "", ".br in \\fBbold\\fR", {}});
  CHECK_THAT(man_page(program, "1"), ContainsSubstring("\n\\&.br in \\efBbold\\efR.\n"));
}

TEST_CASE("completions name every command and option", "[unit][usage]") {
  const CommandReference program = command_reference();
  const std::string bash = bash_completion(program);
  const std::string zsh = zsh_completion(program);
  const std::string fish = fish_completion(program);
  for_each_option(program, [&](const CommandReference& command, const OptionReference& option) {
    if (option.positional) return;
    const std::string& name = option.names.back();
    CAPTURE(command.name, name);
    CHECK_THAT(bash, ContainsSubstring(name));
    CHECK_THAT(zsh, ContainsSubstring(name));
    CHECK_THAT(fish, ContainsSubstring("-l " + name.substr(2)));
  });
}

}  // namespace
}  // namespace limitgauge::app
