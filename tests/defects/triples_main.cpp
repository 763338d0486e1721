// Random triples of surface, cutters and paths, certified and held against the oracle; one line
// each.
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>

#include "model/base/run_control.h"
#include "tests/defects/triples.h"

int main(int count, char** words) {
  using namespace limitgauge;
  if (count != 3 && count != 4) {
    std::fprintf(stderr, "usage: limitgauge_triples FIRST END [THREADS]\n");
    return 2;
  }
  const auto first = static_cast<unsigned>(std::atoi(words[1])),
             end = static_cast<unsigned>(std::atoi(words[2]));
  const auto threads = static_cast<unsigned>(count == 4 ? std::atoi(words[3]) : 2);
  std::atomic<int> wrong = 0;
  std::mutex printing;
  model::parallel_for(end - first, threads, [&](std::size_t k) {
    const auto seed = first + static_cast<unsigned>(k);
    const auto r = tests::defects::hold_against_oracle(tests::defects::random_triple(seed));
    const std::lock_guard lock(printing);
    std::printf(
        "%u\tgouge %.6f in [%.6f, %.6f]\tuncut %.6f in [%.6f, %.6f]\tmissing %.6f in [%.6f, "
        "%.6f]\toracle %.2f s\tverifier %.2f s\n",
        seed, r.gouge.sure_mm, r.gouge.certified.low, r.gouge.certified.high, r.uncut.sure_mm,
        r.uncut.certified.low, r.uncut.certified.high, r.missing.sure_mm, r.missing.certified.low,
        r.missing.certified.high, r.oracle_seconds, r.verifier_seconds);
    for (const std::string& what : r.contradictions)
      std::printf("%u\tCONTRADICTION %s\n", seed, what.c_str());
    std::fflush(stdout);
    wrong += !r.contradictions.empty();
  });
  std::printf("%u triples, %d with a contradiction\n", end - first, wrong.load());
  return wrong > 0 ? 1 : 0;
}
