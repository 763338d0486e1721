#include "study/execute/case_order.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

namespace limitgauge::study {
namespace {

std::size_t shared_by(const CaseRequest& a, const CaseRequest& b) {
  const std::size_t most = std::min(a.prefixes.size(), b.prefixes.size());
  std::size_t shared = 0;
  while (shared < most && a.prefixes[shared] == b.prefixes[shared]) ++shared;
  return shared;
}

}  // namespace

std::vector<std::size_t> order_by_stages(std::span<const CaseRequest> requests) {
  // Keys by the case that had them first: hashes would shuffle the study's own order.
  std::map<std::string, std::size_t> first_with;
  std::vector<std::vector<std::size_t>> rank(requests.size());
  for (std::size_t i = 0; i < requests.size(); ++i)
    for (const std::string& prefix : requests[i].prefixes)
      rank[i].push_back(first_with.try_emplace(prefix, i).first->second);
  std::vector<std::size_t> order(requests.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&rank](std::size_t a, std::size_t b) { return rank[a] < rank[b]; });
  return order;
}

CaseQueue::CaseQueue(std::span<const CaseRequest> requests, std::size_t workers)
    : requests_(requests), order_(order_by_stages(requests)), ranges_(workers) {
  if (!ranges_.empty()) ranges_.front().end = order_.size();
}

/// Stages that the case at this place of the order shares with the one before it.
std::size_t CaseQueue::shared_stages(std::size_t at) const {
  return shared_by(requests_[order_[at - 1]], requests_[order_[at]]);
}

/// The place nearest to the middle among those where least is shared; both parts keep at least a
/// quarter, so that no worker is idle soon again.
std::size_t CaseQueue::best_cut(const Range& range) const {
  const std::size_t middle = range.begin + (range.left() + 1) / 2;
  const std::size_t reach = range.left() / 4;
  std::size_t best = middle;
  for (std::size_t away = 0; away <= reach; ++away) {
    for (const std::size_t at : {middle - away, middle + away}) {
      if (at <= range.begin || at >= range.end) continue;
      if (shared_stages(at) < shared_stages(best)) best = at;
    }
  }
  return best;
}

std::optional<std::size_t> CaseQueue::next(std::size_t worker) {
  if (!again_.empty()) {
    const std::size_t position = again_.back();
    again_.pop_back();
    return position;
  }
  Range& own = ranges_[worker];
  if (own.left() == 0) {
    Range& longest =
        *std::max_element(ranges_.begin(), ranges_.end(),
                          [](const Range& a, const Range& b) { return a.left() < b.left(); });
    if (longest.left() == 0) return std::nullopt;
    // The last one may wait for a worker that is held back for lack of memory: take it all.
    const std::size_t cut = longest.left() == 1 ? longest.begin : best_cut(longest);
    own = {cut, longest.end};
    longest.end = cut;
  }
  return order_[own.begin++];
}

std::vector<std::vector<std::size_t>> batches(std::span<const CaseRequest> requests,
                                              std::size_t most) {
  struct Numbered {
    std::size_t of_group;
    std::vector<std::size_t> cases;
  };
  std::vector<Numbered> found;
  const CaseRequest* before = nullptr;
  for (const std::size_t position : order_by_stages(requests)) {
    const CaseRequest& now = requests[position];
    const bool neighbours = before != nullptr && before->prefixes == now.prefixes;
    if (!neighbours)
      found.push_back({0, {}});
    else if (found.back().cases.size() >= most)
      found.push_back({found.back().of_group + 1, {}});
    found.back().cases.push_back(position);
    before = &now;
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Numbered& a, const Numbered& b) { return a.of_group < b.of_group; });
  std::vector<std::vector<std::size_t>> result;
  for (Numbered& batch : found) result.push_back(std::move(batch.cases));
  return result;
}

}  // namespace limitgauge::study
