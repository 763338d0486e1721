#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/job/foreign_programs.h"
#include "model/base/run_control.h"
#include "reports/run/run_result.h"
#include "verifier/surface/reference_surface.h"
#include "witness/agreement.h"

namespace limitgauge::app {

/// What a run is made within, as far as its memory goes by it.
struct RunTerms {
  std::size_t memory_limit_bytes = 0;  ///< model::memory_limit_bytes() when the run began
  bool files = true;                   ///< stages' files and reports are written
  std::size_t kept = 0;                ///< stages of other jobs that are held beside
};

/// The surface that a job is about.
struct JobSurface {
  model::Cage cage;  ///< placed; of a mesh, its faceted cage
  verifier::ReferenceSurface surface;
  witness::Agreement witness;               ///< on this cage: the two agree
  std::optional<reports::MeshDesign> mesh;  ///< where the design is one
};

struct SetupView;

/// Everything a job reads, read and checked before anything is computed or written.
struct RunInputs {
  std::optional<JobSurface> design;  ///< empty for a job without one
  Settings settings;
  RunTerms terms;
  std::vector<model::Fixture> fixtures;  ///< those that stay where the job puts them
  std::vector<model::Fixture> carried;  ///< those that go with the tool, in the gauge point's frame
  std::vector<std::optional<ForeignPath>> programs;  ///< a stage; empty for those planned here
  std::vector<reports::InputFile> files;             ///< what all of this was read from
  /// The same as each setup has it; empty where the job states none.
  std::vector<std::shared_ptr<const SetupView>> setups = {};
};

/// Of a job with a design. Throws InputError for a cage that cannot be used,
/// verifier::InstrumentDisagreement where the reference surface is not the one that the witness has
/// of the cage, Interrupted when told to stop.
JobSurface load_surface(const Job& job, const model::RunControl& control = {});

/// Throws InputError for a cage or program that cannot be used, and as load_surface does.
/// ResourceError where the moves alone are more than the limit lets the run take.
RunInputs load_inputs(const Job& job, const RunTerms& terms, const model::RunControl& control = {});
/// The same with the surface of the job's design, where it is at hand; empty for a job without one.
RunInputs load_inputs(const Job& job, const RunTerms& terms, std::optional<JobSurface> design);

}  // namespace limitgauge::app
