#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "app/cli/command.h"
#include "app/usage/command_reference.h"

namespace limitgauge::app {

/// What the library fills in; turned into a CommandLine when all is well.
struct Parsed {
  CommonOptions common;
  int threads = 0;
  RunCommand run;
  PlanCommand plan;
  VerifyCommand verify;
  CutCommand cut;
  InspectCommand inspect;
  CompareCommand compare;
  ProbeCommand probe;
  StudyCommand study;
  HistoryCommand history;
  ViewCommand view;
};

/// The program's options with what is known of their values beyond what the library keeps. One
/// definition parses the command line and writes help, man page and completions.
class CommandDefinition {
 public:
  CommandDefinition();
  CommandDefinition(const CommandDefinition&) = delete;
  CommandDefinition& operator=(const CommandDefinition&) = delete;

  CLI::App& app() { return app_; }
  const Parsed& parsed() const { return parsed_; }
  CommandReference reference() const;

 private:
  CLI::Option* hint(CLI::Option* option, const std::string& value, ValueHint hint = {});
  CLI::Option* file(CLI::Option* option, const std::string& extension = "");
  CLI::Option* folder(CLI::Option* option);
  void add_common(CLI::App& sub);
  void hide_unused(CLI::App& sub);
  void offer_json(CLI::App& sub, const char* help);
  void add_machine(CLI::App& sub, MachineOptions& machine);
  void add_run();
  void add_plan();
  void add_verify();
  void add_cut();
  void add_inputs(CLI::App& sub, CutCommand& command);
  void add_placement(CLI::App& sub, CutCommand& command);
  void add_checks(CLI::App& sub);
  void add_inspect();
  void add_compare();
  void add_probe();
  void add_study();
  /// `what` is done where, `alone` says how many at a time by themselves.
  void add_engine(CLI::App& sub, EngineOptions& engine, const std::string& what,
                  const std::string& alone);
  void add_cache(CLI::App& sub, EngineOptions& engine, const std::string& what);
  void add_history();
  void add_history_options(CLI::App& run, HistoryOptions& history);
  void add_view();
  OptionReference reference(const CLI::Option& option) const;
  CommandReference reference(const CLI::App& app) const;

  CLI::App app_;
  Parsed parsed_;
  std::map<const CLI::Option*, ValueHint> hints_;
};

}  // namespace limitgauge::app
