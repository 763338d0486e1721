#pragma once

#include <cstddef>

#include "app/inputs/run_inputs.h"
#include "app/job/job.h"
#include "engine/surface/finish_model.h"
#include "simulator/stock/stock_model.h"

namespace limitgauge::app {

/// What a run's memory goes with.
struct RunScale {
  double moves = 0;          ///< of all stages; those still to be planned as they are expected
  double swept = 0;          ///< moves times the bodies that the verifier follows along them
  double largest_moves = 0;  ///< of the stage that has most
  double text_bytes = 0;     ///< of the programs
  double model_bytes = 0;    ///< of the engine's model of the surface; 0 where no stage needs it
  /// Of the exact surface, and of the cells that the verifier makes of it; empty where nothing is
  /// measured against a design.
  std::optional<double> cells_bytes;
  double grid_bytes = 0;  ///< of the stock's level set, or of what stands for it tile by tile
  bool pictures = true;
  RunTerms terms;
};

/// The scale of a job, but for the model and the level set; `surface` is null for one without a
/// design.
RunScale scale_of(const Job& job, const verifier::ReferenceSurface* surface,
                  const std::vector<std::optional<ForeignPath>>& programs, const RunTerms& terms);

/// The whole of it, once the stock stands and, where a stage is planned, the model does.
RunScale scale_of(const Job& job, const RunInputs& inputs,
                  const std::optional<engine::surface::FinishModel>& built,
                  const simulator::StockModel& stock);

/// What the process takes at its peak, in bytes: the one forecast, of `run`, `verify` and a study's
/// workers. Measured figures; within a factor of 1.5 of the peak over the fixtures and over a
/// million moves (tests/e2e/memory/memory_test.cpp).
double forecast_bytes(const RunScale& scale);

/// What of the run's limit the stock model may take, its moves included. Throws ResourceError where
/// everything else leaves nothing.
std::size_t stock_limit_bytes(const RunScale& scale);

}  // namespace limitgauge::app
