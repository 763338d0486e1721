#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "app/cli/command.h"
#include "history/recorder.h"

namespace limitgauge::app {

/// The history that a run enters, if any. What can be wrong with it is said before the run.
class RunHistory {
 public:
  /// `output`: the run's folder, which is replaced as a whole and so cannot hold the history.
  /// Throws InputError, ResourceError.
  RunHistory(HistoryOptions options, const std::filesystem::path& output);

  bool is_kept() const { return recorder_.has_value(); }
  const std::filesystem::path& file() const { return options_.file; }
  /// Adds the run whose result.json stands in `folder`; returns its id in the history. Whatever
  /// goes wrong is a ResourceError that says that the result is there all the same.
  std::int64_t add(const std::filesystem::path& folder) const;

 private:
  HistoryOptions options_;
  std::optional<history::Recorder> recorder_;
};

}  // namespace limitgauge::app
