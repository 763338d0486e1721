#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "app/run/pipeline.h"
#include "app/study/case_keys.h"
#include "model/base/memory.h"
#include "study/store/store.h"

namespace limitgauge::app {

/// Runs case after case of a study, without files of stages. A case goes on from the longest run of
/// first stages that it shares with an earlier one, which is kept in memory or was put into the
/// store by whatever process; nothing that is taken up again is planned or measured again. Not to
/// be used from two threads at a time.
class CaseRunner {
 public:
  /// Of the stages in memory the last few are kept, those last used, within `most_bytes_kept`: run
  /// cases that share stages one after the other. Where `options` say nothing of when a result was
  /// created, it is when its case began. All cases have the one memory limit, whatever is available
  /// when their turn comes. `store` must outlive this.
  CaseRunner(const study::Store& store, RunOptions options,
             std::size_t most_bytes_kept = std::size_t{1} << 30,
             std::size_t memory_limit_bytes = model::memory_limit_bytes());
  ~CaseRunner();
  CaseRunner(CaseRunner&&) noexcept;
  CaseRunner& operator=(CaseRunner&&) noexcept;

  /// The text of result.json that `limitgauge run` of this job would write, but for times, memory,
  /// `overrides`, which other ways of saying the same case do not have, and the figures of files
  /// that are not written. Puts no result into the store. Throws
  /// InputError, ResourceError, Interrupted, verifier::InstrumentDisagreement.
  std::string run(const std::filesystem::path& job, std::span<const std::string> overrides);

  /// Of the last case, as its files were when they were read: whoever puts its result into the
  /// store takes this key.
  const CaseKeys& last_keys() const;
  /// Stages of the last case that were taken up again: from memory, or from the store.
  struct Reuse {
    std::size_t stages = 0;
    bool from_store = false;
  };
  Reuse last_reuse() const;

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

/// Forecasts the memory of case after case. Stock and model of a first stage are built for it, a
/// second or two of work: cases that share the stage share the forecast.
class CaseForecast {
 public:
  /// `memory_limit_bytes` is what the workers' cases have. Once `stop` is set, bytes() throws
  /// Interrupted soon.
  explicit CaseForecast(std::size_t memory_limit_bytes = model::memory_limit_bytes(),
                        const std::atomic<bool>* stop = nullptr);
  ~CaseForecast();
  CaseForecast(CaseForecast&&) noexcept;
  CaseForecast& operator=(CaseForecast&&) noexcept;

  /// Memory that a process which runs this case, and then others like it, takes at its peak, about:
  /// to choose how many may run beside each other. Throws InputError, ResourceError.
  std::size_t bytes(const std::filesystem::path& job, std::span<const std::string> overrides);

 private:
  struct Known;
  std::unique_ptr<Known> known_;
};

}  // namespace limitgauge::app
