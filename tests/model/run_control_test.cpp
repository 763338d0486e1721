#include "model/base/run_control.h"

#include <numeric>
#include <stdexcept>
#include <vector>

#include "model/base/error.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;

TEST_CASE("every index is visited once, for any number of threads", "[unit][run_control]") {
  for (const unsigned threads : {0U, 1U, 2U, 7U}) {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{1000}}) {
      std::vector<int> visits(count, 0);
      parallel_for(count, threads, [&](std::size_t i) { ++visits[i]; });
      CHECK(visits == std::vector<int>(count, 1));
    }
  }
}

TEST_CASE("an exception of a worker reaches the caller", "[unit][run_control]") {
  for (const unsigned threads : {1U, 4U}) {
    const auto body = [](std::size_t i) {
      if (i == 500) throw std::runtime_error("five hundred");
    };
    CHECK_THROWS_WITH(parallel_for(1000, threads, body), "five hundred");
  }
}

TEST_CASE("a stop that was asked for interrupts at the next check", "[unit][run_control]") {
  std::atomic<bool> stop{false};
  const RunControl control{1, &stop};
  CHECK_NOTHROW(control.check());
  CHECK_NOTHROW(RunControl{}.check());
  stop = true;
  CHECK_THROWS_AS(control.check(), Interrupted);
}

TEST_CASE("progress goes to whoever listens", "[unit][run_control]") {
  double seen = 0;
  const RunControl control{1, nullptr, [&](double fraction) { seen = fraction; }};
  control.report(0.5);
  RunControl{}.report(0.7);
  CHECK(seen == 0.5);
}
