#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "study/execute/executor.h"

namespace limitgauge::study {

/// Positions in `requests` such that cases which share stages stand beside each other, those that
/// share most of them closest; else in their own order.
std::vector<std::size_t> order_by_stages(std::span<const CaseRequest> requests);

/// Hands cases out to workers. Each has a range of neighbours that share stages; who has done with
/// its own takes over a part of the longest one, cut where as few stages as possible are shared.
class CaseQueue {
 public:
  CaseQueue(std::span<const CaseRequest> requests, std::size_t workers);

  /// Position of the next case for a worker; nothing where all are handed out.
  std::optional<std::size_t> next(std::size_t worker);
  /// To be handed out once more.
  void again(std::size_t position) { again_.push_back(position); }

 private:
  struct Range {
    std::size_t begin = 0, end = 0;  ///< in order_
    std::size_t left() const { return end - begin; }
  };
  std::size_t shared_stages(std::size_t at) const;
  std::size_t best_cut(const Range& range) const;

  std::span<const CaseRequest> requests_;
  std::vector<std::size_t> order_, again_;
  std::vector<Range> ranges_;
};

/// The cases cut into batches of neighbours that share all stages but the last, at most `most` in
/// each; first batches of different stages come first.
std::vector<std::vector<std::size_t>> batches(std::span<const CaseRequest> requests,
                                              std::size_t most);

}  // namespace limitgauge::study
