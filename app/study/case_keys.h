#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "app/inputs/input_cache.h"
#include "app/job/job.h"

namespace limitgauge::app {

/// What a case is known by: SHA-256 in 64 lower-case hexadecimal digits each, of the job with its
/// overrides, of the content of every file that it names, and of the running program.
struct CaseKeys {
  /// Cases of one key have one result.json but for times, memory, threads and the date.
  std::string result;
  /// Of all stages but the last: cases that share it differ in their last stage only.
  std::string prefix;
  /// Of the first 1, 2, ... stages, all but the last; the last of these is `prefix`.
  std::vector<std::string> prefixes;
};

/// Makes keys of many cases: what the files hold is looked at once for each state of a file (path,
/// size, times), so that a case costs little more than reading its job. Not to be used from two
/// threads at a time.
class CaseKeyMaker {
 public:
  CaseKeyMaker();
  ~CaseKeyMaker();
  CaseKeyMaker(CaseKeyMaker&&) noexcept;
  CaseKeyMaker& operator=(CaseKeyMaker&&) noexcept;

  /// Throws InputError for a job that cannot be read, ResourceError.
  CaseKeys keys(const std::filesystem::path& job, std::span<const std::string> overrides);

 private:
  struct Known;
  std::unique_ptr<Known> known_;
};

/// The same for one case.
CaseKeys case_keys(const std::filesystem::path& job, std::span<const std::string> overrides);

/// A case as it is read: its job, and what it is known by.
struct ReadCase {
  Job job;
  CaseKeys keys;
  std::string model;  ///< key of the engine's model of its surface
};

/// Throws InputError, ResourceError.
ReadCase read_case(const std::filesystem::path& file, std::span<const std::string> overrides,
                   InputCache& files);

}  // namespace limitgauge::app
