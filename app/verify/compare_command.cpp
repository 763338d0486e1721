#include <algorithm>
#include <ostream>
#include <sstream>

#include "app/cli/commands.h"
#include "app/output/output_folder.h"
#include "model/base/error.h"
#include "model/base/output_file.h"
#include "model/base/text_file.h"
#include "model/text/clean_text.h"
#include "model/text/message_text.h"
#include "reports/compare/report.h"
#include "reports/compare/run_comparison.h"
#include "reports/record/record_reader.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace compare = reports::compare;
namespace {

void require_known(const std::vector<std::string>& names, const std::string& option) {
  const std::vector<std::string_view> known = compare::judged_ids();
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw UsageError(option + " " + name + ": nothing of that name is judged; did you mean " +
                     model::nearest_word(name, known) + "?");
  }
}

/// What is asked for is judged, or refused: a comparison that judges nothing of it would be green.
void require_judged(const CompareCommand& command) {
  for (const std::string& name : command.metrics) {
    if (std::find(command.ignored.begin(), command.ignored.end(), name) != command.ignored.end())
      throw UsageError("--metric " + name + " and --ignore " + name +
                       " contradict each other; expected one of them");
    if (name == "machining_time_s" && !command.time_limit_percent)
      throw UsageError("--metric " + name +
                       ": without a limit the time is not judged; expected --time-limit with it");
  }
}

compare::Options options_of(const CompareCommand& command) {
  require_known(command.metrics, "--metric");
  require_known(command.ignored, "--ignore");
  require_judged(command);
  return {command.time_limit_percent, command.metrics, command.ignored};
}

reports::record::RunRecord read_result(const fs::path& stated) {
  const fs::path file = result_file(stated);
  std::istringstream in(model::read_text_file(file));
  return reports::record::read_result_json(in, file.string());
}

void write_files(const compare::Comparison& comparison, OutputFolder& folder) {
  const auto write = [&](const char* name,
                         void (*writer)(const compare::Comparison&, std::ostream&)) {
    model::write_file(folder.working() / name, [&](std::ostream& out) { writer(comparison, out); });
  };
  folder.fill([&] {
    write("compare.html", compare::write_html);
    write("compare.md", compare::write_markdown);
    write("compare.json", compare::write_json);
    write("junit.xml", compare::write_junit);
  });
}

}  // namespace

ExitCode execute(const CompareCommand& command, const CommonOptions& common,
                 const Console& console) {
  const compare::Options options = options_of(command);
  std::optional<OutputFolder> folder;
  if (!command.output.empty()) {
    require_no_result(command.output);
    folder.emplace(command.output, common.force);
  }
  const reports::record::RunRecord base = read_result(command.base), now = read_result(command.now);
  compare::Comparison comparison = compare::compare_runs(base, now, options);
  compare::name_runs(comparison, base, command.base, now, command.now);
  if (folder) write_files(comparison, *folder);
  if (common.json) {
    compare::write_json(comparison, console.out);
    console.out << std::flush;
  } else if (!common.quiet) {
    console.out << compare::text_table(comparison, console.colour, console.out_columns,
                                       common.verbose);
    if (folder)
      console.out << "report: " << model::one_line((folder->target() / "compare.html").string())
                  << '\n';
    console.out << std::flush;
  }
  return comparison.judgement() == compare::Judgement::worse ? ExitCode::fail : ExitCode::pass;
}

}  // namespace limitgauge::app
