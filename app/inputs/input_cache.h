#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "app/inputs/input_checksums.h"
#include "app/inputs/run_inputs.h"
#include "app/inputs/stock_file.h"

namespace limitgauge::app {

/// What a file is recognised by without reading it.
struct FileState {
  std::uint64_t device = 0, number = 0, bytes = 0;
  std::int64_t changed_ns = 0, written_ns = 0;
  friend bool operator==(const FileState&, const FileState&) = default;
};
/// Throws InputError where there is no regular file.
FileState file_state(const std::filesystem::path& file);

/// What the files of many jobs hold: each is read once as long as its state stays the same, so that
/// the next job that names it need not read it again. Of stocks and surfaces, which take memory,
/// the last few are kept.
class InputCache {
 public:
  /// Throws InputError.
  Checksum checksum(const std::filesystem::path& file);
  /// Readers that keep what they read here; this must outlive them.
  StockReaders stock_readers();
  /// The cage of the job's design and its reference surface; empty where it has none. Throws
  /// InputError.
  std::optional<JobSurface> surface(const Job& job);

 private:
  struct CachedStock {
    std::filesystem::path file;
    std::string as_stated;
    MeshPlace place;
    FileState state;
    StockFile stock;
  };
  struct CachedSurface {
    DesignKind kind = DesignKind::cage;
    std::filesystem::path file;
    model::Placement placement;
    FileState state;
    JobSurface surface;
  };
  template <class Read>
  StockFile stock(const std::filesystem::path& file, const std::string& as_stated,
                  const MeshPlace& place, const Read& read);

  std::map<std::filesystem::path, std::pair<FileState, Checksum>> sums_;
  std::vector<CachedStock> stocks_;  ///< the last asked for first
  std::vector<CachedSurface> surfaces_;
};

}  // namespace limitgauge::app
