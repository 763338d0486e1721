#include <algorithm>
#include <chrono>
#include <ostream>

#include "app/cli/commands.h"
#include "app/job/job_reader.h"
#include "app/output/cache_folder.h"
#include "app/output/output_folder.h"
#include "app/output/progress.h"
#include "app/study/study_cases.h"
#include "app/study/study_engine.h"
#include "app/study/study_figures.h"
#include "app/study/study_file.h"
#include "app/study/study_output.h"
#include "app/study/study_worker.h"
#include "model/base/absolute_path.h"
#include "model/base/clock.h"
#include "model/base/error.h"
#include "model/text/clean_text.h"
#include "study/plan/design.h"
#include "study/search/search.h"

namespace limitgauge::app {
namespace {

namespace fs = std::filesystem;

/// The clock of a file system may be a little behind.
constexpr std::chrono::seconds kClocks{5};

std::string progress_words(const StudyProgress& at) {
  std::string words = std::to_string(at.ended) + " of " + std::to_string(at.cases) + " cases";
  if (at.reused > 0) words += ", " + std::to_string(at.reused) + " reused";
  if (at.failed > 0) words += ", " + std::to_string(at.failed) + " without a result";
  return words;
}

/// One study from its plan to its table.
class StudyRun {
 public:
  StudyRun(const StudyCommand& command, const CommonOptions& common, const Console& console,
           study::Plan plan)
      : command_(command),
        common_(common),
        console_(console),
        plan_(std::move(plan)),
        job_(model::absolute_path(plan_.job).lexically_normal()),
        store_(cache_folder(command.cache), command.cache_limit_bytes),
        folder_(command.output.empty() ? fs::path("limitgauge-out") / plan_.name : command.output,
                common.force) {}

  StudyOutcome work();
  const OutputFolder& folder() const { return folder_; }

 private:
  std::vector<std::string> keys() const;
  std::vector<study::Figure> figures() const;
  std::vector<study::Row> searched_rows(StudyCases& cases,
                                        std::span<const study::Case> asked) const;
  StudyCasesOptions cases_options(ProgressLine& progress) const;
  void run_cases(StudyCases& cases, StudyOutcome& outcome) const;
  std::unique_ptr<study::Executor> engine_for(ProgressLine& progress) const;
  void run_watched(study::Executor& engine, StudyOutcome& outcome, ProgressLine& progress);
  [[noreturn]] void say_interrupted() const;

  const StudyCommand& command_;
  const CommonOptions& common_;
  const Console& console_;
  const study::Plan plan_;
  const fs::path job_;
  const study::Store store_;
  OutputFolder folder_;
  FigureScope scope_;
  const fs::file_time_type began_ = fs::file_time_type::clock::now() - kClocks;
};

std::vector<std::string> StudyRun::keys() const {
  std::vector<std::string> keys;
  for (const study::Variable& variable : plan_.variables) keys.push_back(variable.key);
  return keys;
}

/// With the setting that is to be large, where one is: a figure that no result has.
std::vector<study::Figure> StudyRun::figures() const {
  std::vector<study::Figure> all = study_figures(scope_);
  if (const auto& key = plan_.search.largest)
    all.push_back({study::kSearchedSetting, *key, "", false, true});
  return all;
}

std::vector<study::Row> StudyRun::searched_rows(StudyCases& cases,
                                                std::span<const study::Case> asked) const {
  std::vector<study::Row> rows = cases.rows(asked);
  if (plan_.search.largest)
    for (study::Row& row : rows) row.figures.push_back(row.asked.settings.front().number);
  return rows;
}

StudyCasesOptions StudyRun::cases_options(ProgressLine& progress) const {
  StudyCasesOptions options;
  options.job = job_;
  options.overrides = common_.overrides;
  options.keys = keys();
  options.scope = scope_;
  options.stop = console_.stop;
  options.result = [this](std::size_t index, const std::string& text) {
    write_case(index, text, folder_.working());
  };
  // A search asks as it goes: of how many in the end is known as a bound only.
  const std::size_t least = plan_.method == study::Method::search ? plan_.search.most_cases : 1;
  options.progress = [&progress, least](const StudyProgress& at) {
    progress.rename(progress_words(at));
    // What was known already says nothing of the time that the others take.
    const std::size_t others = std::max({at.cases, least, at.reused + 1}) - at.reused;
    progress.update(static_cast<double>(at.ended - at.reused) / static_cast<double>(others));
  };
  // Only now: the results that this study takes up again are the youngest.
  options.before_running = [this] { store_.trim(began_); };
  return options;
}

void StudyRun::run_cases(StudyCases& cases, StudyOutcome& outcome) const {
  if (plan_.method != study::Method::search) {
    outcome.table.rows = cases.rows(study::design(plan_));
    outcome.analysis = analyse(plan_, outcome.table);
    return;
  }
  study::SearchResult found = study::search(
      plan_, outcome.table.figures,
      [&](std::span<const study::Case> asked) { return searched_rows(cases, asked); },
      console_.stop);
  if (found.how == study::SearchResult::Ending::stopped) throw model::Interrupted();
  outcome.table.rows = std::move(found.rows);
  outcome.analysis = analyse(plan_, outcome.table);
  outcome.analysis.search_ending = std::move(found.ending);
}

void StudyRun::say_interrupted() const {
  throw model::ResourceError("limitgauge: interrupted; every finished case is kept in " +
                             store_.folder().string() +
                             ": run the same command again to go on from there");
}

std::unique_ptr<study::Executor> StudyRun::engine_for(ProgressLine& progress) const {
  const auto note = [&](const std::string& line) {
    if (common_.quiet) return;
    progress.clear();
    console_.errors << "limitgauge: " << line << std::endl;
  };
  return study_engine(command_, common_, job_, store_, note, console_.stop);
}

void StudyRun::run_watched(study::Executor& engine, StudyOutcome& outcome, ProgressLine& progress) {
  StudyCases cases(cases_options(progress), store_, engine);
  progress.phase({"looking for what is known already"});
  try {
    run_cases(cases, outcome);
  } catch (const model::Interrupted&) {
    say_interrupted();
  }
  outcome.progress = cases.progress();
}

StudyOutcome StudyRun::work() {
  const model::Stopwatch watch;
  StudyOutcome outcome;
  outcome.created = model::now_utc();
  outcome.engine = command_.engine;
  outcome.table.name = plan_.name;
  outcome.table.job = plan_.job_as_stated;
  outcome.table.keys = keys();
  scope_ = figure_scope(read_job(job_, common_.overrides), outcome.table.keys);
  outcome.table.figures = figures();
  ProgressSurroundings around;
  around.columns = console_.errors_columns;
  ProgressLine progress(console_.errors, console_.progress && !common_.quiet, std::move(around));
  const ProgressTicker ticker(progress);
  // Before anything is made: what runs the cases may not be there.
  const std::unique_ptr<study::Executor> engine = engine_for(progress);
  folder_.fill([&] {
    run_watched(*engine, outcome, progress);
    progress.phase({"writing the table"});
    store_.trim(began_);
    outcome.seconds = watch.seconds();
    write_study(plan_, outcome, folder_.working());
  });
  return outcome;
}

}  // namespace

ExitCode execute(const StudyCommand& command, const CommonOptions& common, const Console& console) {
  if (!command.worker.empty()) return run_study_worker(command, common, console);
  StudyRun run(command, common, console, read_study(command.study, common.overrides));
  const StudyOutcome outcome = run.work();
  if (!common.quiet) {
    print_study(outcome, console.out);
    console.out << "page: " << model::one_line((run.folder().target() / "study.html").string())
                << std::endl;
  }
  return exit_code(outcome);
}

}  // namespace limitgauge::app
