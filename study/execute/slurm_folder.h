#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "study/execute/executor.h"
#include "study/execute/worker_lines.h"

namespace limitgauge::study {

/// Tasks of one array at most: with their answers and logs, less than a thousand files a folder.
inline constexpr std::size_t kMostTasksInFolder = 300;

/// The folder of one job array: the script, and for each task what it is to run (`7.tasks`), what
/// it answers (`7.out`) and what it says (`7.log`).
class ArrayFolder {
 public:
  /// Writes it. `batches` are positions in `requests`, one a task; `worker` is the command of a
  /// worker without its tasks. Throws model::ResourceError.
  ArrayFolder(std::filesystem::path folder, const std::vector<CaseRequest>& requests,
              const std::vector<std::vector<std::size_t>>& batches,
              const std::vector<std::string>& worker);

  std::filesystem::path script() const { return folder_ / "run.sh"; }
  std::filesystem::path log(std::size_t task) const;
  /// What a task has answered since it was asked last.
  std::vector<WorkerAnswer> new_answers(std::size_t task);

 private:
  std::filesystem::path folder_;
  std::vector<std::size_t> read_bytes_;  ///< of each task's answers
};

/// `text` as one word of a shell.
std::string shell_word(const std::string& text);

}  // namespace limitgauge::study
