#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "simulator/grid/vdb_stock.h"

namespace limitgauge::simulator {

/// What is wrong with a file, and what was expected; the file's name is for the caller to say.
class VdbRefusal : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file as OpenVDB reads it, in this very process: OpenVDB 10 believes what a file says, and of a
/// damaged one may write beyond its buffers. For a process whose end hurts nobody.
class VdbReading {
 public:
  /// Throws VdbRefusal.
  explicit VdbReading(const std::filesystem::path& path);

  /// As read_vdb_stock() has it; that the mesh bounds a solid is for the caller to see. Throws
  /// VdbRefusal, ResourceError and std::bad_alloc.
  VdbStock stock(std::size_t memory_limit_bytes) const;

 private:
  struct Grid;
  std::shared_ptr<const Grid> grid_;
};

/// What read_vdb_answer() reads, in the process that reads the file. What was read outlives the
/// work in `kept`: taking it down again may wait for threads that such a process has not.
std::string vdb_answer_about(const std::filesystem::path& path, std::size_t memory_limit_bytes,
                             std::optional<VdbReading>& kept);

}  // namespace limitgauge::simulator
