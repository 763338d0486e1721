#pragma once

#include "app/cli/known_files.h"
#include "app/job/job.h"
#include "app/study/case_keys.h"

namespace limitgauge::app {

/// A case as it is read: its job, and what it is known by.
struct ReadCase {
  Job job;
  CaseKeys keys;
  std::string model;  ///< key of the engine's model of its surface
};

/// Throws InputError, ResourceError.
ReadCase read_case(const std::filesystem::path& file, std::span<const std::string> overrides,
                   KnownFiles& files);

}  // namespace limitgauge::app
