#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "study/execute/executor.h"

namespace limitgauge::study {

struct LocalPoolOptions {
  std::vector<std::string> worker;  ///< the command that starts one
  unsigned workers = 1;
  unsigned retries = 2;            ///< of a case that was lost or that the machine could not carry
  std::uint64_t memory_bytes = 0;  ///< that all workers together may take; one runs in any case
  std::function<std::uint64_t(const CaseRequest&)> forecast_bytes;  ///< of a worker with this case
  /// Told of what was not expected: a worker that died.
  std::function<void(const std::string&)> note = [](const std::string&) {};
};

/// Runs cases in processes of this machine that take one case after the other.
class LocalPool : public Executor {
 public:
  explicit LocalPool(LocalPoolOptions options) : options_(std::move(options)) {}
  void run(const std::vector<CaseRequest>& requests, const ReportOutcome& report,
           const std::atomic<bool>& stop) override;

 private:
  LocalPoolOptions options_;
};

}  // namespace limitgauge::study
