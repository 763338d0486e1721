#pragma once

#include "app/case_keys.h"
#include "app/job.h"
#include "app/known_files.h"

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
