#include <algorithm>
#include <ostream>

#include "app/cli/commands.h"
#include "app/output/output_folder.h"
#include "history/history.h"
#include "model/base/error.h"
#include "model/base/output_file.h"
#include "model/text/clean_text.h"
#include "model/text/message_text.h"
#include "reports/history/history_report.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace {

namespace history_report = reports::history_report;
using Names = std::vector<std::string>;

/// What was asked for by name must occur: a mistyped one would look like an empty history.
void require_known(const fs::path& file, const std::string& option, const std::string& name,
                   const Names& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  const std::vector<std::string_view> views(known.begin(), known.end());
  const std::string nearest = model::nearest_word(name, views);
  throw model::InputError({file.string(), 0, 0},
                          "this history has no " + option + " \"" + name + "\"",
                          nearest.empty() ? "one that it has" : "\"" + nearest + "\" or another");
}

void require_names(const history::History& history, const HistoryCommand& command) {
  Names stages, metrics;
  for (const history::Series& one : history.series()) {
    if (!one.stage.empty()) stages.push_back(one.stage);
    metrics.push_back(one.metric);
  }
  if (!command.job.empty()) require_known(command.file, "job", command.job, history.jobs());
  for (const std::string& one : command.stages) require_known(command.file, "stage", one, stages);
  for (const std::string& one : command.metrics)
    require_known(command.file, "metric", one, metrics);
}

history::Query query_of(const history::History& history, const HistoryCommand& command,
                        const history_report::Choice& choice) {
  history::Query query;
  if (!command.job.empty()) query.job = command.job;
  query.since = command.since;
  query.last = static_cast<std::size_t>(command.last);
  query.stages = choice.stages;
  query.metrics = history_report::metrics_to_read(choice, history.series());
  return query;
}

history_report::Overview overview_of(const history::History& history,
                                     const HistoryCommand& command) {
  history_report::Overview overview;
  overview.file = command.file.filename().string();
  overview.version = LIMITGAUGE_VERSION;
  overview.choice = {command.stages, command.metrics};
  const history::Query query = query_of(history, command, overview.choice);
  overview.found = history.count(query);
  overview.jobs = history_report::job_histories(history.runs(query), overview.choice);
  return overview;
}

void write_files(const history_report::Overview& overview, const fs::path& folder) {
  using history_report::Overview;
  const auto put = [&](const char* name, void (*write)(const Overview&, std::ostream&)) {
    model::write_file(folder / name, [&](std::ostream& out) { write(overview, out); });
  };
  put("history.html", history_report::write_history_html);
  put("history.csv", history_report::write_history_csv);
  put("history.json", history_report::write_history_json);
}

fs::path folder_of(const HistoryCommand& command) {
  if (!command.output.empty()) return command.output;
  return fs::path("limitgauge-out") / command.file.stem();
}

void say_empty(const HistoryCommand& command, const Console& console) {
  const bool asked = !command.since.empty() || !command.job.empty();
  console.out << model::one_line(command.file.string())
              << (asked ? ": no run of those that are asked for; nothing was written"
                        : ": no runs yet; `limitgauge run JOB --history FILE` adds one")
              << std::endl;
}

}  // namespace

ExitCode execute(const HistoryCommand& command, const CommonOptions& common,
                 const Console& console) {
  const history::History history(command.file);
  require_names(history, command);
  const history_report::Overview overview = overview_of(history, command);
  if (overview.jobs.empty()) {
    say_empty(command, console);
    return ExitCode::pass;
  }
  const fs::path output = folder_of(command);
  require_no_result(output);
  OutputFolder folder(output, common.force);
  folder.fill([&] { write_files(overview, folder.working()); });
  if (common.quiet) return ExitCode::pass;
  console.out << history_report::history_table(overview, console.colour);
  if (overview.found > static_cast<std::size_t>(command.last))
    console.out << "the newest " << command.last << " of " << overview.found
                << " runs; --last shows more" << std::endl;
  console.out << "page: " << model::one_line((folder.target() / "history.html").string())
              << std::endl;
  return ExitCode::pass;
}

}  // namespace limitgauge::app
