#include <algorithm>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

using std::chrono::milliseconds;

TEST_CASE("an interrupted run leaves nothing that looks finished", "[e2e][stop]") {
  const Scratch scratch;
  // The aircraft takes a minute and more: after a second it is at work, early or late.
  for (const milliseconds after : {milliseconds(1000), milliseconds(6000)}) {
    const Outcome outcome = limitgauge(
        scratch, {"run", fixture("jobs/aircraft.toml"), "--no-pictures"}, {after, std::nullopt});
    CHECK(outcome.exit_code == 4);
    CHECK_THAT(outcome.errors, ContainsSubstring("interrupted"));
    CHECK(scratch.entries().empty());
  }
}

TEST_CASE("a full disk is said, and what was finished is kept as incomplete", "[e2e][stop]") {
  const Scratch scratch;
  constexpr std::size_t kTooSmall = 2000;
  const Outcome outcome =
      limitgauge(scratch, {"run", fixture("jobs/quick-dome.toml"), "-o", "out", "--no-pictures"},
                 {std::nullopt, kTooSmall});
  CHECK(outcome.exit_code == 4);
  CHECK_THAT(outcome.errors, ContainsSubstring("toolpath.ngc") && ContainsSubstring("incomplete"));
  CHECK(scratch.entries() == std::vector<std::string>{"out.incomplete"});
  CHECK(std::filesystem::exists(scratch / "out.incomplete/INCOMPLETE.txt"));
  CHECK_FALSE(std::filesystem::exists(scratch / "out.incomplete/result.json"));
}

}  // namespace
}  // namespace limitgauge::e2e
