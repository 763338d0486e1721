#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <memory>
#include <string>
#include <string_view>

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

/// Of a text that is at hand, likewise.
std::string sha256_of(std::string_view bytes);

/// Length and SHA-256 of the rest of a stream, read piece by piece.
struct Checksum {
  std::uint64_t bytes = 0;
  std::string sha256;  ///< 64 lower-case hexadecimal digits
};
/// Throws ResourceError where the stream breaks.
Checksum checksum(std::istream& in);
/// Of a whole file. Throws InputError where it cannot be read.
Checksum file_checksum(const std::filesystem::path& file);

}  // namespace limitgauge::app
