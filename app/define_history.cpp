#include "app/command_definition.h"

namespace limitgauge::app {

void CommandDefinition::add_history_options(CLI::App& run) {
  HistoryOptions& history = parsed_.run.history;
  file(run.add_option("--history", history.file, "Add the run's figures to this history (SQLite)"),
       "sqlite");
  hint(run.add_option("--label", history.label, "Name of the run in the history"), "WORDS");
  hint(run.add_option("--commit", history.commit, "Commit of what is verified, for the history"),
       "COMMIT");
}

void CommandDefinition::add_history() {
  HistoryCommand& history = parsed_.history;
  CLI::App& sub = *app_.add_subcommand("history", "List and plot the figures of past runs");
  file(sub.add_option("FILE", history.file, "History that run --history wrote"), "sqlite")
      ->required();
  folder(sub.add_option("-o,--output", history.output,
                        "Folder for history.html (default: limitgauge-out/NAME of the file)"));
  add_common(sub);
  hide_unused(sub);
}

}  // namespace limitgauge::app
