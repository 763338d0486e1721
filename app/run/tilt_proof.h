#pragma once

#include <optional>
#include <string>

#include "app/inputs/run_inputs.h"
#include "app/job/job.h"
#include "app/run/run_watch.h"
#include "app/run/stage_program.h"
#include "simulator/stock/stock_model.h"
#include "verifier/cells/surface_cells.h"

namespace limitgauge::app {

/// Whether a stage whose tool leans may be cut as it was planned: the verifier's certificate of
/// what flutes, shank and holder take of the part, and the simulator's check of the process on the
/// stock as it stands before the stage. All of it must outlive this.
class TiltProof {
 public:
  /// `at_setup` and `inputs` are those of the stage's setup, in whose frame `stock` lies.
  TiltProof(const Job& at_setup, const RunInputs& inputs, std::size_t stage,
            const simulator::StockModel& stock, const StageWatch& watch);

  /// Nothing where the part is proven to lose no more than the stage's gate of gouge allows,
  /// without one its tolerance, and nothing that fails was found in the process.
  std::optional<std::string> against(const StageToCut& planned) const;

 private:
  std::optional<std::string> against_part(const model::Pass& pass) const;
  std::optional<std::string> against_process(const model::Pass& pass) const;

  const Job& job_;
  const RunInputs& inputs_;
  const JobStage& stage_;
  const simulator::StockModel& stock_;
  StageWatch watch_;
  double resolution_mm_, gouge_mm_;
  verifier::SurfaceCells cells_;
};

}  // namespace limitgauge::app
