#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace limitgauge::fuzz {

/// Memory that has a path, and is gone with the last process that has it.
class MemoryFile {
 public:
  MemoryFile();
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  void write(std::span<const std::uint8_t> bytes) const;
  std::string read() const;
  std::filesystem::path path() const;

 private:
  int descriptor_;
};

/// Reads one .vdb after the other as read_vdb_stock() does, but in one process for many files: to
/// start one takes ten times as long as to read a small file with sanitizers. A new one is started
/// when it breaks down, and now and then.
class VdbProcess {
 public:
  explicit VdbProcess(std::size_t memory_limit_bytes) : memory_limit_bytes_(memory_limit_bytes) {}
  ~VdbProcess() { end(); }
  VdbProcess(const VdbProcess&) = delete;
  VdbProcess& operator=(const VdbProcess&) = delete;

  /// What it answers about a file; none where it breaks down or takes too long.
  std::optional<std::string> answer(const MemoryFile& file);

 private:
  void start(const MemoryFile& file);
  void end();
  [[noreturn]] void serve(const MemoryFile& file, int requests) const;

  std::size_t memory_limit_bytes_;
  MemoryFile answer_;
  int requests_ = -1;
  pid_t process_ = -1;
  int answered_ = 0;  ///< by this process
};

}  // namespace limitgauge::fuzz
