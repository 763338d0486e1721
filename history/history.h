#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "history/entry.h"

namespace limitgauge::history {

/// What is asked of a history; what is left empty asks for all.
struct Query {
  std::optional<std::string> job;
  std::string since;                ///< ISO 8601, UTC, or the beginning of it: "2026-11-22"
  std::optional<std::size_t> last;  ///< so many of those that are left, the newest
  std::vector<std::string> stages;  ///< figures of the whole run come with any
  std::vector<std::string> metrics;
};

/// A figure that occurs in a history, whatever run has it.
struct Series {
  std::string stage, metric;
  friend bool operator==(const Series&, const Series&) = default;
};

class Database;

/// A history as it stands whenever it is asked. Reading changes nothing, not even a file of an
/// older version.
class History {
 public:
  /// Throws InputError for a file that is missing, none of Limitgauge's, damaged, or newer than
  /// this program; ResourceError.
  explicit History(const std::filesystem::path& file);
  ~History();
  History(History&&) noexcept;
  History& operator=(History&&) noexcept;

  /// Runs, oldest first, with those of their figures that are asked for.
  std::vector<Entry> runs(const Query& query) const;
  /// How many there are, were it not for `last`.
  std::size_t count(const Query& query) const;
  /// By stage and metric.
  std::vector<Series> series() const;
  /// Names of the jobs, each once, sorted.
  std::vector<std::string> jobs() const;

 private:
  std::unique_ptr<Database> database_;
};

}  // namespace limitgauge::history
