#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/base/error.h"
#include "study/plan/plan.h"

namespace limitgauge::app {

/// Reads a study file (TOML, see docs/study.md) and what it needs of the job that it names, after
/// `overrides` of that job's keys. Everything is checked before it returns but for the settings
/// themselves: a job that refuses one is a case that ends with an error. InputError names file,
/// line and column.
study::Plan read_study(const std::filesystem::path& file,
                       std::span<const std::string> overrides = {});

/// A study as its file states it, with the places to name where the job does not agree.
struct StudyFile {
  study::Plan plan;
  std::vector<model::SourcePlace> keys;  ///< of the variables
  model::SourcePlace method, cost, search_cost, accuracy;
};

/// The same for a text without the job: plan.variables have the bases that are stated there. Paths
/// in it are taken against `folder`.
StudyFile read_study_text(const std::string& text, const std::string& name_in_errors,
                          const std::filesystem::path& folder);

/// Holds a study against the text of its job: fills in the bases that the study leaves to the job,
/// and refuses keys that the job cannot have, figures that its stages do not give, and a job that
/// is not in order as it stands.
void relate_to_job(StudyFile& file, const std::string& job_text,
                   std::span<const std::string> overrides);

}  // namespace limitgauge::app
