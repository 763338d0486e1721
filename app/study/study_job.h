#pragma once

#include <span>
#include <string>

#include "app/study/study_file.h"

namespace limitgauge::app {

/// Holds a study against the text of its job: fills in the bases that the study leaves to the job,
/// and refuses keys that the job cannot have, figures that its stages do not give, and a job that
/// is not in order as it stands.
void relate_to_job(StudyFile& file, const std::string& job_text,
                   std::span<const std::string> overrides);

}  // namespace limitgauge::app
