#include "study/execute/case_order.h"

#include <algorithm>
#include <ctime>
#include <set>

#include "tests/support/catch.h"

namespace limitgauge::study {
namespace {

/// Cases over three settings; a stage depends on the first, the next on the first two.
std::vector<CaseRequest> cases_of(std::size_t first, std::size_t second, std::size_t third) {
  std::vector<CaseRequest> requests;
  for (std::size_t c = 0; c < third; ++c)
    for (std::size_t b = 0; b < second; ++b)
      for (std::size_t a = 0; a < first; ++a) {
        CaseRequest request;
        request.index = requests.size();
        // Hashes sort in no order that means anything.
        const std::string stage = std::to_string((a * 7919) % 104729);
        request.prefixes = {stage, stage + "/" + std::to_string((b * 6007) % 9973)};
        requests.push_back(std::move(request));
      }
  return requests;
}

/// Prefixes that are worked out when one worker after the other runs what it was given.
std::size_t stages_made(const std::vector<CaseRequest>& requests,
                        const std::vector<std::vector<std::size_t>>& work) {
  std::size_t made = 0;
  for (const std::vector<std::size_t>& one : work) {
    const CaseRequest* before = nullptr;
    for (const std::size_t position : one) {
      const CaseRequest& now = requests[position];
      for (std::size_t i = 0; i < now.prefixes.size(); ++i)
        made += before == nullptr || before->prefixes[i] != now.prefixes[i];
      before = &now;
    }
  }
  return made;
}

/// Workers that all take the same time for a case.
std::vector<std::vector<std::size_t>> share_out(const std::vector<CaseRequest>& requests,
                                                std::size_t workers) {
  CaseQueue queue(requests, workers);
  std::vector<std::vector<std::size_t>> work(workers);
  for (bool any = true; any;) {
    any = false;
    for (std::size_t worker = 0; worker < workers; ++worker) {
      if (const auto position = queue.next(worker)) {
        work[worker].push_back(*position);
        any = true;
      }
    }
  }
  return work;
}

TEST_CASE("cases that share stages stand beside each other", "[unit][study]") {
  const std::vector<CaseRequest> requests = cases_of(3, 4, 5);
  const std::vector<std::size_t> order = order_by_stages(requests);
  CHECK(std::set<std::size_t>(order.begin(), order.end()).size() == requests.size());
  CHECK(order.front() == 0);
  // Three first stages, four second ones on each: none twice.
  CHECK(stages_made(requests, {order}) == 3 + 3 * 4);
}

TEST_CASE("every case is handed out once, and workers end together", "[unit][study]") {
  for (const std::size_t workers : {1, 2, 3, 7, 64, 200}) {
    for (const auto& requests : {cases_of(3, 4, 5), cases_of(1, 1, 1), cases_of(60, 1, 1)}) {
      const auto work = share_out(requests, workers);
      std::set<std::size_t> seen;
      std::size_t most = 0, sum = 0;
      for (const auto& one : work) {
        seen.insert(one.begin(), one.end());
        sum += one.size();
        most = std::max(most, one.size());
      }
      CHECK(seen.size() == requests.size());
      CHECK(sum == requests.size());
      CHECK(most <= (requests.size() + workers - 1) / workers);
    }
  }
}

TEST_CASE("two workers make few stages twice", "[unit][study]") {
  // Four first stages: two for each worker.
  CHECK(stages_made(cases_of(4, 1, 15), share_out(cases_of(4, 1, 15), 2)) == 8);
  // One alone: both need it.
  CHECK(stages_made(cases_of(1, 1, 60), share_out(cases_of(1, 1, 60), 2)) == 4);
}

TEST_CASE("a lost case is handed out once more", "[unit][study]") {
  const std::vector<CaseRequest> requests = cases_of(2, 1, 1);
  CaseQueue queue(requests, 1);
  CHECK(queue.next(0) == std::size_t{0});
  queue.again(0);
  CHECK(queue.next(0) == std::size_t{0});
  CHECK(queue.next(0) == std::size_t{1});
  CHECK_FALSE(queue.next(0));
}

TEST_CASE("batches share their stages; first ones of different stages come first",
          "[unit][study]") {
  const std::vector<CaseRequest> requests = cases_of(3, 1, 5);
  const auto all = batches(requests, 2);
  REQUIRE(all.size() == 9);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(requests[all[i].front()].prefixes[0] == requests[i].prefixes[0]);
  std::size_t cases = 0;
  for (const auto& batch : all) {
    CHECK(batch.size() <= 2);
    cases += batch.size();
    for (const std::size_t position : batch)
      CHECK(requests[position].prefixes == requests[batch.front()].prefixes);
  }
  CHECK(cases == requests.size());
}

TEST_CASE("ten times the cases take about ten times as long to share out", "[unit][study]") {
  const auto seconds = [](std::size_t first, std::size_t second) {
    const std::vector<CaseRequest> requests = cases_of(first, second, 10);
    const std::clock_t began = std::clock();  // of the processor: others do not count
    const std::size_t number = batches(requests, 25).size() + share_out(requests, 16).size();
    CHECK(number > 0);
    return static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC;
  };
  const double few = seconds(20, 50), many = seconds(100, 100);
  // A quadratic step would make it a hundred.
  CHECK(many < 40 * few + 0.2);
}

}  // namespace
}  // namespace limitgauge::study
