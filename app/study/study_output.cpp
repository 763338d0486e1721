#include "app/study/study_output.h"

#include <algorithm>
#include <initializer_list>
#include <map>
#include <ostream>
#include <sstream>

#include "app/output/time_left.h"
#include "model/base/output_file.h"
#include "reports/study/study_report.h"
#include "reports/text/text.h"

namespace limitgauge::app {
namespace {

namespace fs = std::filesystem;
using study::Status;

constexpr std::size_t kMostReasons = 5;

reports::study_report::About about(const study::Plan& plan, const StudyOutcome& outcome) {
  reports::study_report::About about;
  about.version = LIMITGAUGE_VERSION;
  about.created = outcome.created;
  about.engine = outcome.engine;
  about.seconds = outcome.seconds;
  about.job_path = plan.job.lexically_normal().string();
  for (const study::Variable& variable : plan.variables) {
    if (!variable.base) return about.own.clear(), about;
    about.own.push_back(*variable.base);
  }
  return about;
}

std::size_t count(const study::Table& table, Status status) {
  return static_cast<std::size_t>(
      std::count_if(table.rows.begin(), table.rows.end(),
                    [status](const study::Row& row) { return row.status == status; }));
}

void print_counts(const StudyOutcome& outcome, std::ostream& out) {
  const study::Table& table = outcome.table;
  out << table.name << ": " << table.rows.size() << " cases";
  const char* before = ": ";
  for (const Status status :
       {Status::pass, Status::fail, Status::indeterminate, Status::error, Status::lost}) {
    const std::size_t number = count(table, status);
    if (number == 0) continue;
    out << before << number << " " << name(status);
    before = ", ";
  }
  out << "; " << outcome.progress.reused << " reused, " << outcome.progress.run << " run, "
      << clock_words(outcome.seconds) << '\n';
}

/// The same reason once, with one case that has it.
void print_reasons(const study::Table& table, std::ostream& out) {
  struct Group {
    const study::Row* first;
    std::size_t rows = 0;
  };
  std::map<std::string, Group> groups;
  for (const study::Row& row : table.rows) {
    if (row.status != Status::error && row.status != Status::lost) continue;
    ++groups.try_emplace(row.reason, Group{&row}).first->second.rows;
  }
  std::size_t printed = 0;
  for (const auto& [reason, group] : groups) {
    if (printed++ == kMostReasons) {
      out << "and " << groups.size() - kMostReasons << " other reasons: see the table\n";
      return;
    }
    out << name(group.first->status) << " (case " << group.first->asked.index;
    if (group.rows > 1) out << " and " << group.rows - 1 << " more";
    out << "): " << reports::clean_text(reason) << '\n';
  }
}

void print_recommendation(const StudyOutcome& outcome, std::ostream& out) {
  const study::Recommendation& recommended = outcome.analysis.recommendation;
  if (recommended.row) {
    const study::Row& row = outcome.table.rows[*recommended.row];
    out << "recommended: case " << row.asked.index << '\n';
    for (std::size_t i = 0; i < row.asked.settings.size(); ++i)
      out << "  " << outcome.table.keys[i] << " = " << row.asked.settings[i].toml << '\n';
  }
  for (const std::string& said : {recommended.reason, outcome.analysis.search_ending})
    if (!said.empty()) out << reports::clean_text(said) << '\n';
}

}  // namespace

void write_study(const study::Plan& plan, const StudyOutcome& outcome, const fs::path& folder) {
  using Writer = void (*)(const study::Plan&, const study::Table&, const study::Analysis&,
                          std::ostream&, const reports::study_report::About&);
  const reports::study_report::About said = about(plan, outcome);
  const auto write = [&](const char* file, Writer writer) {
    model::write_file(folder / file, [&](std::ostream& out) {
      writer(plan, outcome.table, outcome.analysis, out, said);
    });
  };
  model::write_file(folder / "study.csv", [&](std::ostream& out) {
    reports::study_report::write_study_csv(plan, outcome.table, outcome.analysis, out);
  });
  write("study.html", reports::study_report::write_study_html);
  // Last: what looks for a finished study looks for this file.
  write("study.json", reports::study_report::write_study_json);
}

void write_case(std::size_t index, const std::string& text, const fs::path& folder) {
  const fs::path file = folder / reports::study_report::result_path(index);
  model::make_folder(file.parent_path());
  model::write_file(file, [&text](std::ostream& out) { out << text; });
}

void print_study(const StudyOutcome& outcome, std::ostream& out) {
  print_counts(outcome, out);
  print_reasons(outcome.table, out);
  print_recommendation(outcome, out);
}

ExitCode exit_code(const StudyOutcome& outcome) {
  if (outcome.analysis.recommendation.row) return ExitCode::pass;
  const auto any = [&](std::initializer_list<study::Status> statuses) {
    return std::any_of(
        outcome.table.rows.begin(), outcome.table.rows.end(), [&](const study::Row& row) {
          return std::find(statuses.begin(), statuses.end(), row.status) != statuses.end();
        });
  };
  if (any({study::Status::indeterminate})) return ExitCode::indeterminate;
  if (any({study::Status::pass, study::Status::fail})) return ExitCode::fail;
  return any({study::Status::lost}) ? ExitCode::resources : ExitCode::fail;
}

}  // namespace limitgauge::app
