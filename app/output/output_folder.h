#pragma once

#include <filesystem>
#include <string>

namespace limitgauge::app {

/// The folder of one run's results. Work goes into a hidden sibling, which takes the name only in
/// finish(): an interrupted run leaves nothing that looks finished. Without finish() or keep() the
/// destructor removes what was written.
class OutputFolder {
 public:
  /// Throws InputError where `target` holds files already and `force` is not given, or where it
  /// holds files that are none of Limitgauge's. Nothing is written before prepare().
  OutputFolder(std::filesystem::path target, bool force);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Makes the working folder. Throws InputError where it cannot be made, ResourceError where the
  /// disk is full.
  void prepare();
  /// Where to write until finish().
  const std::filesystem::path& working() const { return working_; }
  const std::filesystem::path& target() const { return target_; }
  /// Gives the results their name; what stood there before is replaced. Throws ResourceError.
  void finish();
  /// Keeps what was written as `target`.incomplete with a note in INCOMPLETE.txt, as far as the
  /// disk allows, and returns that folder. Does not throw.
  std::filesystem::path keep_incomplete(const std::string& note);

 private:
  std::filesystem::path target_, working_, created_parent_;
};

}  // namespace limitgauge::app
