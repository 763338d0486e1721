// No certified interval may contradict what looking everywhere finds.
#include "tests/defects/triples.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace limitgauge::tests::defects {
namespace {

void hold(unsigned from, unsigned to) {
  for (unsigned seed = from; seed < to; ++seed) {
    const TripleResult result = hold_against_oracle(random_triple(seed));
    CAPTURE(seed);
    for (const std::string& what : result.contradictions)
      FAIL_CHECK("triple " << seed << ": " << what);
  }
}

}  // namespace

TEST_CASE("certified intervals hold what the oracle finds: random triples", "[slow][triples]") {
  hold(0, static_cast<unsigned>(tests::by_effort(5, 12)));
}

TEST_CASE("certified intervals hold what the oracle finds: further random triples",
          "[.][triples]") {
  // Ten minutes of processor time: by hand, or by limitgauge_triples.
  hold(12, 310);
}

}  // namespace limitgauge::tests::defects
