#pragma once

#include <cstdint>
#include <filesystem>

#include "history/entry.h"

namespace limitgauge::history {

/// Adds runs to a history: an SQLite file that any number of processes, on all machines that share
/// its folder, may add to and read at the same time, and be killed while they do.
class Recorder {
 public:
  /// Sees to it that runs can be added to `file`, which may not be there yet: reads all of it, adds
  /// a run and takes it back, so that nothing is changed. Throws InputError for a file that is none
  /// of Limitgauge's, is newer than this program or damaged anywhere, for a folder that is missing
  /// or a place that cannot be written; ResourceError where the disk fails or another process keeps
  /// the lock for a minute.
  explicit Recorder(std::filesystem::path file);

  /// All of the run or nothing; returns its id. Makes the file, and brings an older one to what
  /// this program writes. Throws as the constructor does, and std::invalid_argument for figures
  /// that are not finite or a name longer than kLongestName.
  std::int64_t append(const Entry& entry) const;

  const std::filesystem::path& file() const { return file_; }

 private:
  std::filesystem::path file_;
};

}  // namespace limitgauge::history
