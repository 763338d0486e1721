#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace limitgauge::app {

/// Tells others that a folder is being worked in, until the process ends, however it ends.
class FolderLock {
 public:
  /// Locks `folder`, which was made just now; nothing where another process took it for a leftover
  /// in this very moment. Throws ResourceError.
  static std::optional<FolderLock> take(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(FolderLock&& other) noexcept;
  FolderLock& operator=(FolderLock&& other) noexcept;

  /// Takes the lock's file out of the folder.
  void leave() const;

 private:
  FolderLock(std::filesystem::path file, int descriptor);
  std::filesystem::path file_;
  int descriptor_;  ///< -1: moved from
};

/// `name`, or its beginning where nothing could be put about it any more.
std::string shortened_name(const std::string& name);
/// A name for a working folder of results that are to be called `name`; no other has it.
std::string working_name(const std::string& name);

/// Removes working folders in `parent` whose processes have ended before their results had a name.
/// Those of living processes stay, on whatever machine they run, and so does all that cannot be
/// told for certain. Does not throw.
void remove_leftovers(const std::filesystem::path& parent);

}  // namespace limitgauge::app
