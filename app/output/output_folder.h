#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/output/folder_lock.h"
#include "model/base/error.h"

namespace limitgauge::app {

/// Results are complete but could not get their name; what() says why and where they are.
class NotPublished : public model::ResourceError {
  using model::ResourceError::ResourceError;
};

/// The folder of one run's results. Work goes into a hidden sibling, which takes the name only in
/// finish(): an interrupted run leaves nothing that looks finished. Without finish() or keep() the
/// destructor removes what was written; what a killed process left is removed by the next that
/// works in the same place. Whatever stands under the name is replaced only where it is a folder of
/// results that its manifest proves to be ours, file by file, and where that was asked for.
class OutputFolder {
 public:
  /// Throws InputError where `target` holds files already and `force` is not given, or where it
  /// holds a file that is none of Limitgauge's. Nothing is written before prepare(). A symbolic
  /// link stays, and leads to the results afterwards.
  OutputFolder(const std::filesystem::path& target, bool force);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Makes the working folder. Throws InputError where it cannot be made, ResourceError where the
  /// disk is full.
  void prepare();
  /// Where to write until finish().
  const std::filesystem::path& working() const { return working_; }
  /// As it was stated, absolute.
  const std::filesystem::path& target() const { return target_; }
  /// Gives the results their name, at once and whole; the results that stood there when the work
  /// began are replaced. Throws ResourceError where the disk does not take them, NotPublished where
  /// something else stands there now: then they are kept as `target`.unpublished.
  void finish();
  /// prepare(), `work` and finish(). A ResourceError speaks of files as they would have been
  /// called.
  void fill(const std::function<void()>& work);
  /// `message` with files by the names that they would have had: the working folder's own name
  /// means nothing to anybody.
  std::string named(std::string message) const;
  /// Keeps what was written as `target`.incomplete with a note in INCOMPLETE.txt, as far as the
  /// disk allows, and returns that folder. Does not throw.
  std::filesystem::path keep_incomplete(const std::string& note);

 private:
  void publish();
  void replace();
  std::filesystem::path keep_as(const std::string& kind, bool replacing) noexcept;

  std::filesystem::path target_;  ///< as stated
  std::filesystem::path place_;   ///< behind all links
  std::filesystem::path working_, created_parent_;
  std::optional<std::string> replaced_;  ///< seal of the results that may be replaced
  std::optional<FolderLock> lock_;
};

/// result.json, stated as itself or as the folder of a finished run. Throws InputError for a folder
/// without one; whether the file can be read is its reader's business.
std::filesystem::path result_file(const std::filesystem::path& stated);

/// Throws InputError where `target` holds a run's results: what speaks of them must not take their
/// place, whatever is forced.
void require_no_result(const std::filesystem::path& target);

}  // namespace limitgauge::app
