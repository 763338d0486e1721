#include "app/share/shared_pieces.h"

#include <chrono>

#include "app/output/cache_folder.h"
#include "app/output/checksum.h"
#include "app/share/piece_store.h"
#include "app/study/case_keys.h"
#include "app/study/study_engine.h"
#include "model/base/error.h"

namespace limitgauge::app {
namespace {

/// Parts of a map or a field where nothing is said: each task reads the job's files and builds the
/// stage's scene again.
constexpr std::uint32_t kParts = 16;

std::vector<std::string> worker_words(const SharedPiecesOptions& options,
                                      const study::Store& store) {
  std::vector<std::string> words = {"run", options.job.string(), "--quiet", "--cache",
                                    store.folder().string()};
  for (const std::string& set : options.overrides) {
    words.push_back("--set");
    words.push_back(set);
  }
  return words;
}

}  // namespace

class SharedPieces::OfStage : public verifier::PieceWorkers {
 public:
  OfStage(SharedPieces& all, std::span<const model::Pass> passes) : all_(all) {
    SharedStage shared{all.job_key_, passes.size() - 1, {}, {}};
    for (const model::Pass& pass : passes) {
      shared.paths.push_back(pass.path);
      shared.axes.push_back(pass.axes);
    }
    stage_key_ = put(kStageKind, to_bytes(shared));
  }

  std::uint32_t parts() const override {
    return all_.options_.engine.jobs > 0 ? all_.options_.engine.jobs : kParts;
  }

  std::vector<std::string> work(std::span<const verifier::StagePiece> pieces,
                                const std::string& reach) override {
    const std::string reach_key = reach.empty() ? std::string() : put(kReachKind, reach);
    std::vector<std::string> keys;
    std::vector<study::CaseRequest> requests;
    for (const verifier::StagePiece& piece : pieces) {
      const PieceTask task{stage_key_, reach_key, piece};
      keys.push_back(piece_key(task));
      if (!all_.store_.get(kPieceKind, keys.back()))
        requests.push_back({keys.size() - 1, keys.back(), {}, words_of(task)});
    }
    run(requests);
    std::vector<std::string> outcomes;
    for (const std::string& key : keys) outcomes.push_back(come_to(key));
    return outcomes;
  }

 private:
  std::string put(const char* kind, const std::string& content) const {
    const std::string key = sha256_of(content);
    all_.store_.put(kind, key, content);
    return key;
  }

  void run(const std::vector<study::CaseRequest>& requests) {
    std::string failure;
    std::size_t ended = 0;
    const auto report = [&](const study::CaseOutcome& outcome) {
      all_.options_.progress(static_cast<double>(++ended) / static_cast<double>(requests.size()));
      if (outcome.ending != study::CaseOutcome::Ending::done && failure.empty())
        failure = outcome.reason;
    };
    all_.executor_->run(requests, report, *all_.options_.stop);
    if (!failure.empty())
      throw model::ResourceError("limitgauge: error: a piece was not worked out on Slurm: " +
                                 failure);
  }

  std::string come_to(const std::string& key) const {
    auto content = all_.store_.get(kPieceKind, key);
    if (!content)
      throw model::ResourceError(all_.store_.folder().string() +
                                 ": error: what a piece came to is not there; expected a folder "
                                 "that all nodes share");
    return std::move(*content);
  }

  SharedPieces& all_;
  std::string stage_key_;
};

SharedPieces::SharedPieces(SharedPiecesOptions options)
    : options_(std::move(options)),
      store_(cache_folder(options_.engine.cache), options_.engine.cache_limit_bytes),
      job_key_(case_keys(options_.job, options_.overrides).result),
      executor_(slurm_engine(options_.engine, worker_words(options_, store_), store_, options_.note,
                             options_.stop)) {
  store_.trim(std::filesystem::file_time_type::clock::now());
}

std::unique_ptr<verifier::PieceWorkers> SharedPieces::of_stage(
    std::span<const model::Pass> passes) {
  return std::make_unique<OfStage>(*this, passes);
}

}  // namespace limitgauge::app
