#include "app/study/case_memory.h"

#include <algorithm>
#include <map>

#include "app/run/stage_planner.h"
#include "app/study/case_keys.h"
#include "app/study/case_runner.h"
#include "app/study/stage_prefix_cache.h"
#include "simulator/stock/stock_model.h"

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
constexpr double kGridShare = 3 + StagePrefixCache::kMostKept;

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

struct CaseForecast::Known {
  InputCache files;
  std::map<std::string, std::size_t> bytes;  ///< by key of the model and of the first stage
};

CaseForecast::CaseForecast() : known_(std::make_unique<Known>()) {}
CaseForecast::~CaseForecast() = default;
CaseForecast::CaseForecast(CaseForecast&&) noexcept = default;
CaseForecast& CaseForecast::operator=(CaseForecast&&) noexcept = default;

std::size_t CaseForecast::bytes(const std::filesystem::path& job,
                                std::span<const std::string> overrides) {
  const ReadCase asked = read_case(job, overrides, known_->files);
  const std::vector<std::string>& prefixes = asked.keys.prefixes;
  const std::string key = asked.model + (prefixes.empty() ? asked.keys.prefix : prefixes.front());
  const auto found = known_->bytes.find(key);
  if (found != known_->bytes.end()) return found->second;
  const std::size_t bytes =
      measure_case(asked.job, known_->files.surface(asked.job)).forecast_bytes();
  known_->bytes.emplace(key, bytes);
  return bytes;
}

}  // namespace limitgauge::app
