#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace limitgauge::app {

/// A regular file that is open for reading.
class OpenFile {
 public:
  /// Takes over an open descriptor.
  OpenFile(int descriptor, std::size_t bytes) : descriptor_(descriptor), bytes_(bytes) {}
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  std::size_t bytes() const { return bytes_; }
  /// Up to `length` bytes from `offset` on; fewer where the file ends, none where it cannot be
  /// read.
  std::string read(std::size_t offset, std::size_t length) const;

 private:
  int descriptor_;
  std::size_t bytes_;
};

/// The files below one folder, and nothing else: whoever asks from outside reaches no other place.
class FolderFiles {
 public:
  /// Throws InputError where `folder` cannot be opened.
  explicit FolderFiles(const std::filesystem::path& folder);
  ~FolderFiles();
  FolderFiles(const FolderFiles&) = delete;
  FolderFiles& operator=(const FolderFiles&) = delete;

  /// The file at `path`, names parted by slashes. Nothing for what is no regular file, for hidden
  /// names and for ".."; a symbolic link is never followed, wherever it leads. Throws ResourceError
  /// where the machine has no descriptor left.
  std::shared_ptr<const OpenFile> open(std::string_view path) const;

 private:
  int descriptor_;
};

/// The media type of a file of an output folder, by its name.
std::string media_type(std::string_view path);

}  // namespace limitgauge::app
