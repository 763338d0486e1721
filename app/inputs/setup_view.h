#pragma once

#include "app/inputs/run_inputs.h"

namespace limitgauge::app {

/// A job and what it reads as one of its setups has them: surface, raw stock and fixtures lie as
/// they do in the machine, and cutters stand along +Z. Stages keep their numbers; those of other
/// setups have no program here.
struct SetupView {
  Job job;
  RunInputs inputs;
};

/// The job in the frame of setup `setup`. Throws InputError for a stock that cannot be turned so.
Job in_setup(const Job& job, std::size_t setup);
/// Of the part's frame, as another has it: what is measured against is held against the witness
/// there too.
JobSurface turned(const JobSurface& surface, const model::Pose& from_part,
                  const model::RunControl& control);
/// A stage's own view of the job: the job itself and its inputs where it states no setups.
const Job& job_of_stage(const Job& job, const RunInputs& inputs, std::size_t stage);
const RunInputs& inputs_of_stage(const Job& job, const RunInputs& inputs, std::size_t stage);

/// load_inputs of a job that states setups; `design` in the part's frame.
RunInputs load_in_setups(const Job& job, const RunTerms& terms, std::optional<JobSurface> design,
                         const model::RunControl& control);

}  // namespace limitgauge::app
