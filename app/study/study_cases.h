#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/study/case_keys.h"
#include "app/study/study_figures.h"
#include "study/execute/executor.h"
#include "study/plan/plan.h"
#include "study/store/store.h"

namespace limitgauge::app {

/// How far a study is.
struct StudyProgress {
  std::size_t cases = 0, ended = 0;             ///< asked for so far; with a row
  std::size_t reused = 0, run = 0, failed = 0;  ///< failed: errors and lost ones
};

/// What the cases of one study have in common.
struct StudyCasesOptions {
  std::filesystem::path job;  ///< absolute: results name the file alone then
  std::vector<std::string> overrides, keys;
  FigureScope scope;
  const std::atomic<bool>* stop = nullptr;
  /// Every result that there is, once: the text of result.json.
  std::function<void(std::size_t index, const std::string& text)> result;
  std::function<void(const StudyProgress&)> progress;
  /// Called once, before anything is run: what is known is known by then.
  std::function<void()> before_running = [] {};
};

/// Turns cases into rows: by results that the store has, and through an executor for the others.
class StudyCases {
 public:
  StudyCases(StudyCasesOptions options, const study::Store& store, study::Executor& executor)
      : options_(std::move(options)), store_(store), executor_(executor) {}

  /// A row for each case, in the same order, whatever became of it. Throws InputError where the
  /// job refuses the settings of every case that was ever asked for, Interrupted, ResourceError.
  std::vector<study::Row> rows(std::span<const study::Case> cases);
  const StudyProgress& progress() const { return progress_; }

 private:
  struct Asked;
  std::vector<std::string> overrides_of(const study::Case& asked) const;
  void know(Asked& all);
  void take_from_store(Asked& all);
  void run_others(Asked& all);
  bool fill(study::Row& row);
  void ended(const study::Row& row);

  StudyCasesOptions options_;
  const study::Store& store_;
  study::Executor& executor_;
  CaseKeyMaker keys_;
  StudyProgress progress_;
  bool any_accepted_ = false, any_run_ = false;
};

/// A message of several lines as one: its parts joined by "; ".
std::string single_line(std::string text);

}  // namespace limitgauge::app
