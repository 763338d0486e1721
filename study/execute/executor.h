#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace limitgauge::study {

/// A case that is to be run because no store has its result.
struct CaseRequest {
  std::size_t index = 0;  ///< of the case in its study
  std::string key;        ///< of its result
  /// Keys of its first 1, 2, ... stages: cases that share them do well to run one after the other.
  std::vector<std::string> prefixes;
  std::vector<std::string> overrides;  ///< `key=value`
};

/// How a case ended.
struct CaseOutcome {
  enum class Ending {
    done,   ///< the result is in the store
    error,  ///< the job cannot be run with these settings, or the machine could not carry it
    lost,   ///< whoever ran it died
  };
  std::size_t index = 0;
  Ending ending = Ending::lost;
  std::string reason;  ///< of anything but done, one line
  unsigned attempts = 1;
  double seconds = 0;  ///< of the last attempt, 0 where unknown
};

using ReportOutcome = std::function<void(const CaseOutcome&)>;

/// Whoever runs cases: workers put results into the store, the executor says how each case ended.
class Executor {
 public:
  Executor() = default;
  virtual ~Executor() = default;
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// Runs all of them in an order of its own and tells of each, once, as it ends; returns after
  /// the last. Once `stop` is set, ends what it started and throws model::Interrupted; results that
  /// are in the store stay there. Throws ResourceError where nothing can be run at all.
  virtual void run(const std::vector<CaseRequest>& requests, const ReportOutcome& report,
                   const std::atomic<bool>& stop) = 0;
};

}  // namespace limitgauge::study
