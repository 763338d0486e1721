#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace limitgauge::study {

/// `content` as the file of an entry: a line that says of what key it is, how long and with what
/// checksum, and then the content, compressed.
std::string pack_entry(const std::string& content, const std::string& key);
/// The content; nothing where the file is not whole, of another key or of another version.
std::optional<std::string> unpack_entry(const std::string& file, const std::string& key);

/// Results by what they were made of: a folder that any number of processes, on any number of
/// machines that share it, may read, write and trim at the same time, and be killed while they do.
/// An entry is written beside its name and renamed; what is found under a name is whole, which a
/// checksum of its own proves, and one that does not agree counts as not there.
///
/// Entries lie two levels of 256 folders deep: KIND/ab/cd/REST.
class Store {
 public:
  /// Makes nothing before the first put(). `limit_bytes` is what trim() leaves at most.
  Store(std::filesystem::path folder, std::uint64_t limit_bytes);

  /// The entry `key` (64 lower-case hexadecimal digits) of `kind` (a word), marked as used now;
  /// nothing where there is none. Throws std::invalid_argument for another key.
  std::optional<std::string> get(const std::string& kind, const std::string& key) const;
  /// Without reading it.
  bool has(const std::string& kind, const std::string& key) const;
  /// Whoever puts first or last: the same key has the same content. Throws model::ResourceError.
  void put(const std::string& kind, const std::string& key, const std::string& content) const;

  struct Trimmed {
    std::uint64_t entries = 0, bytes = 0;            ///< let go
    std::uint64_t kept_entries = 0, kept_bytes = 0;  ///< what is there now
  };
  /// Lets go of what was not used for longest, until the limit is met. What was used since
  /// `keep_since` stays, whatever the limit.
  Trimmed trim(std::filesystem::file_time_type keep_since) const;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  std::uint64_t limit_bytes_;
};

}  // namespace limitgauge::study
