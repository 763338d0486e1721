#include "app/case_memory.h"

#include <algorithm>

#include "app/case_reading.h"
#include "app/case_runner.h"
#include "app/prefix_shelf.h"
#include "app/stage_planner.h"
#include "simulator/stock_model.h"

namespace limitgauge::app {
namespace {

/// What a process takes that has run the smallest of jobs. This and the shares are measured, with
/// reserve: the forecast is 1.1 times the peak of the quick dome (94 MB), and 1.3 times those of
/// the valley (88 MB) and of the paper's aircraft (795 MB).
constexpr double kProcessBytes = 60e6;
/// The model beside what building it and cutting it take.
constexpr double kModelShare = 1.5;
/// Level sets of the stock: the one that is cut, those of the stages kept, which are larger than
/// the raw stock's, the readings of the stock's surface, and the verifier's cells and samples,
/// whose number goes with it as well.
constexpr double kGridShare = 3 + PrefixShelf::kMostKept;

}  // namespace

CaseMemory measure_case(const Job& job, const JobSurface& surface) {
  const Settings settings = choose_settings(job, surface.surface.bounding_box());
  CaseMemory memory;
  memory.grid_bytes =
      simulator::StockModel(job.stock, settings.voxel_mm, settings.memory_limit_bytes)
          .memory_bytes();
  const auto planned = [](const JobStage& stage) { return stage.plan.has_value(); };
  if (std::any_of(job.stages.begin(), job.stages.end(), planned))
    memory.model_bytes =
        engine::surface::FinishModel(surface.cage, model_request(job), {}).figures().memory_bytes;
  return memory;
}

std::size_t CaseMemory::forecast_bytes() const {
  return static_cast<std::size_t>(kProcessBytes + kModelShare * static_cast<double>(model_bytes) +
                                  kGridShare * static_cast<double>(grid_bytes));
}

std::size_t forecast_bytes(const std::filesystem::path& job,
                           std::span<const std::string> overrides) {
  KnownFiles files;
  const ReadCase asked = read_case(job, overrides, files);
  return measure_case(asked.job, files.surface(asked.job)).forecast_bytes();
}

}  // namespace limitgauge::app
