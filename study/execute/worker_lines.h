#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace limitgauge::study {

/// What a worker is told and what it answers: a line each, its fields between tabs.
struct WorkerTask {
  std::size_t index = 0;
  std::string key;
  std::vector<std::string> overrides;
};

struct WorkerAnswer {
  enum class Kind {
    done,   ///< the result is in the store
    error,  ///< would come out the same however often it is tried
    again,  ///< the machine could not carry it: may go better another time
  };
  std::size_t index = 0;
  Kind kind = Kind::done;
  double seconds = 0;
  std::uint64_t peak_bytes = 0;  ///< of the process while it ran this case
  std::string reason;
};

std::string to_line(const WorkerTask& task);      ///< with its end of line
std::string to_line(const WorkerAnswer& answer);  ///< likewise
/// Without an end of line; nothing for a line that is none, a half one among others.
std::optional<WorkerTask> task_of_line(const std::string& line);
std::optional<WorkerAnswer> answer_of_line(const std::string& line);

}  // namespace limitgauge::study
