#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace limitgauge::history {

/// One figure of one run.
struct Value {
  std::string stage;         ///< empty: of the whole run
  std::string metric;        ///< id as in reports/record/metrics.h, with its unit: "gouge_mm"
  double low = 0, high = 0;  ///< the same twice where it is no certified interval

  friend bool operator==(const Value&, const Value&) = default;
};

/// What became of one stage of a run.
struct StageVerdict {
  std::string stage;
  std::string verdict;  ///< pass, fail, indeterminate, not_run

  friend bool operator==(const StageVerdict&, const StageVerdict&) = default;
};

/// One run as the history keeps it.
struct Entry {
  std::int64_t id = 0;  ///< given by the file, rising
  std::string created;  ///< ISO 8601, UTC
  std::string job;
  std::string version;  ///< of Limitgauge
  std::string commit;   ///< of what was verified, as the user's version control calls it; or empty
  std::string label;    ///< the user's own; or empty
  std::string verdict;  ///< pass, fail, indeterminate
  /// Of the result that the figures are from, limitgauge.result/N: what their names mean.
  int result_schema = 2;
  std::vector<StageVerdict> stages;  ///< in the order of the job
  std::vector<Value> values;

  friend bool operator==(const Entry&, const Entry&) = default;
};

/// A label or a commit is a name, no document: longest that is kept, bytes.
constexpr std::size_t kLongestName = 200;

}  // namespace limitgauge::history
