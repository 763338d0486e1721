#include "app/study/case_memory.h"

#include <map>

#include "app/inputs/run_forecast.h"
#include "app/run/stage_planner.h"
#include "app/study/case_keys.h"
#include "app/study/case_runner.h"
#include "app/study/stage_prefix_cache.h"

namespace limitgauge::app {
RunTerms case_terms(std::size_t memory_limit_bytes) {
  return {memory_limit_bytes, false, StagePrefixCache::kMostKept};
}

double case_forecast_bytes(const Job& job, std::optional<JobSurface> surface,
                           std::size_t memory_limit_bytes, const std::atomic<bool>* stop) {
  const RunTerms terms = case_terms(memory_limit_bytes);
  const RunInputs inputs = load_inputs(job, terms, std::move(surface));
  RunOptions options;
  options.stop = stop;
  const StageWatch unwatched{options};
  const std::optional<engine::surface::FinishModel> built =
      StagePlanner(job, inputs).expected_model({options.threads, stop, {}});
  const CutStock stock = uncut_stock(job, inputs.settings, unwatched);
  return forecast_bytes(scale_of(job, inputs, built, stock.stock));
}

struct CaseForecast::Known {
  std::size_t memory_limit_bytes = 0;
  const std::atomic<bool>* stop = nullptr;
  InputCache files;
  std::map<std::string, std::size_t> bytes;  ///< by key of the model and of the first stage
};

CaseForecast::CaseForecast(std::size_t memory_limit_bytes, const std::atomic<bool>* stop)
    : known_(std::make_unique<Known>()) {
  known_->memory_limit_bytes = memory_limit_bytes;
  known_->stop = stop;
}

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
  const auto bytes = static_cast<std::size_t>(case_forecast_bytes(
      asked.job, known_->files.surface(asked.job), known_->memory_limit_bytes, known_->stop));
  known_->bytes.emplace(key, bytes);
  return bytes;
}

}  // namespace limitgauge::app
