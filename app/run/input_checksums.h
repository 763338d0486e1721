#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/job/job.h"
#include "reports/run/run_result.h"

namespace limitgauge::app {

/// SHA-256 of what is put in piece by piece. Throws ResourceError where the library fails.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;
  void add(std::string_view bytes);
  /// 64 lower-case hexadecimal digits; nothing can be put in afterwards.
  std::string digits();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// Length and SHA-256 of the rest of a stream, read piece by piece.
struct Checksum {
  std::uint64_t bytes = 0;
  std::string sha256;  ///< 64 lower-case hexadecimal digits
};
/// Throws ResourceError where the stream breaks.
Checksum checksum(std::istream& in);
/// Of a whole file. Throws InputError where it cannot be read.
Checksum file_checksum(const std::filesystem::path& file);
using FileChecksum = std::function<Checksum(const std::filesystem::path& file)>;

/// Every file that the job names and that makes its result: the job file, the cage, the stock,
/// programs, fixtures, the tool table; each once, named as stated. Of a path from the root only the
/// file's name is told: the folders of one machine mean nothing elsewhere. Pipes are left out.
/// Throws InputError for a file that cannot be read.
std::vector<reports::InputFile> input_checksums(const Job& job,
                                                const FileChecksum& sum_of = file_checksum);

}  // namespace limitgauge::app
