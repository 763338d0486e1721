#include "app/study/case_runner.h"

#include <optional>
#include <sstream>

#include "app/run/stage_prefix.h"
#include "app/study/case_keys.h"
#include "app/study/case_memory.h"
#include "app/study/stage_prefix_cache.h"
#include "model/base/clock.h"
#include "model/base/error.h"
#include "reports/run/report.h"

namespace limitgauge::app {
namespace {

constexpr const char* kKind = "stages";

RunOptions without_files(RunOptions options) {
  options.stage_files = false;
  return options;
}

/// The passes of the stages that were taken up.
std::vector<verifier::Pass> passes_of(const StagePrefix& prefix, const Job& job) {
  std::vector<verifier::Pass> passes;
  for (std::size_t i = 0; i < prefix.stages.size(); ++i)
    passes.push_back(
        {job.stages[i].cutter, prefix.stages[i].path, {}, false, prefix.stages[i].axes});
  return passes;
}

}  // namespace

struct CaseRunner::Kept {
  Kept(const study::Store& to, RunOptions asked, std::size_t most_bytes, std::size_t limit_bytes)
      : store(to),
        options(without_files(std::move(asked))),
        memory_limit_bytes(limit_bytes),
        prefixes(most_bytes) {}

  std::string run(const std::filesystem::path& file, std::span<const std::string> overrides);
  RunInputs read_inputs(const ReadCase& asked, const std::filesystem::path& file,
                        std::span<const std::string> overrides);
  std::shared_ptr<const StagePrefix> longest(const ReadCase& asked, const RunInputs& inputs);
  std::shared_ptr<const StagePrefix> from_store(const std::string& key, std::size_t stages,
                                                const Job& job, const RunInputs& inputs) const;
  std::shared_ptr<const StagePrefix> with_model(std::shared_ptr<const StagePrefix> prefix,
                                                const ReadCase& asked) const;
  void take(const ReadCase& asked, const StagePrefix& state);

  const study::Store& store;
  RunOptions options;
  std::size_t memory_limit_bytes;
  InputCache files;
  StagePrefixCache prefixes;
  struct KnownModel {
    std::string key;
    engine::surface::FinishModel model;
  };
  std::optional<KnownModel> model;
  CaseKeys keys;
  Reuse reuse;
};

/// All that the job reads from files. What was known of them must still hold afterwards: figures of
/// one state may not come under the key of another.
RunInputs CaseRunner::Kept::read_inputs(const ReadCase& asked, const std::filesystem::path& file,
                                        std::span<const std::string> overrides) {
  RunInputs inputs =
      load_inputs(asked.job, case_terms(memory_limit_bytes), files.surface(asked.job));
  if (read_case(file, overrides, files).keys.result != asked.keys.result)
    throw model::ResourceError(file.string() + ": a file of the job changed while it was read");
  return inputs;
}

/// Its stock stands as the stored paths left it.
std::shared_ptr<const StagePrefix> CaseRunner::Kept::from_store(const std::string& key,
                                                                std::size_t stages, const Job& job,
                                                                const RunInputs& inputs) const {
  const std::optional<std::string> text = store.get(kKind, key);
  std::optional<StagePrefix> prefix;
  if (text) prefix = read_stage_prefix(*text);
  if (!prefix || prefix->stages.size() != stages) return nullptr;
  const StageWatch watch{options, stages, job.stages.size()};
  if (!prefix->over())
    prefix->stock = cut_again(uncut_stock(job, inputs.settings, watch), passes_of(*prefix, job),
                              inputs.settings, watch);
  return std::make_shared<const StagePrefix>(std::move(*prefix));
}

std::shared_ptr<const StagePrefix> CaseRunner::Kept::longest(const ReadCase& asked,
                                                             const RunInputs& inputs) {
  for (std::size_t stages = asked.keys.prefixes.size(); stages > 0; --stages) {
    const std::string& key = asked.keys.prefixes[stages - 1];
    if (auto known = prefixes.find(key)) {
      reuse = {stages, false};
      return known;
    }
    if (auto stored = from_store(key, stages, asked.job, inputs)) {
      reuse = {stages, true};
      prefixes.put(key, stored);
      return stored;
    }
  }
  return nullptr;
}

/// Model and stages are shared by other cases each: they are kept apart.
std::shared_ptr<const StagePrefix> CaseRunner::Kept::with_model(
    std::shared_ptr<const StagePrefix> prefix, const ReadCase& asked) const {
  if (!model || model->key != asked.model) return prefix;
  auto all = prefix ? std::make_shared<StagePrefix>(*prefix) : std::make_shared<StagePrefix>();
  all->model = model->model;
  return all;
}

void CaseRunner::Kept::take(const ReadCase& asked, const StagePrefix& state) {
  if (state.model) model.emplace(KnownModel{asked.model, *state.model});
  if (state.stages.size() > asked.keys.prefixes.size()) return;
  const std::string& key = asked.keys.prefixes[state.stages.size() - 1];
  store.put(kKind, key, to_text(state));
  auto kept = std::make_shared<StagePrefix>(state);
  kept->model.reset();
  if (kept->over()) kept->stock.reset();
  prefixes.put(key, std::move(kept));
}

std::string CaseRunner::Kept::run(const std::filesystem::path& file,
                                  std::span<const std::string> overrides) {
  reuse = {};
  const ReadCase asked = read_case(file, overrides, files);
  keys = asked.keys;
  const RunInputs inputs = read_inputs(asked, file, overrides);
  Resumption resumption;
  // What stands after a stage of a setup is kept for none: it would lie otherwise in the next.
  if (!has_setups(asked.job))
    resumption = {with_model(longest(asked, inputs), asked),
                  [&](const StagePrefix& state) { take(asked, state); }};
  std::ostringstream out;
  RunOptions now = options;
  if (now.created.empty()) now.created = model::now_utc();
  write_result_json(run_job(asked.job, inputs, {}, now, resumption), out);
  return std::move(out).str();
}

CaseRunner::CaseRunner(const study::Store& store, RunOptions options, std::size_t most_bytes_kept,
                       std::size_t memory_limit_bytes)
    : kept_(
          std::make_unique<Kept>(store, std::move(options), most_bytes_kept, memory_limit_bytes)) {}
CaseRunner::~CaseRunner() = default;
CaseRunner::CaseRunner(CaseRunner&&) noexcept = default;
CaseRunner& CaseRunner::operator=(CaseRunner&&) noexcept = default;

std::string CaseRunner::run(const std::filesystem::path& job,
                            std::span<const std::string> overrides) {
  return kept_->run(job, overrides);
}

const CaseKeys& CaseRunner::last_keys() const {
  return kept_->keys;
}

CaseRunner::Reuse CaseRunner::last_reuse() const {
  return kept_->reuse;
}

}  // namespace limitgauge::app
