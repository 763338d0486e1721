#include <sstream>

#include "model/base/error.h"
#include "model/gcode/program.h"
#include "tests/model/gcode/flow/random_flow.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;
using namespace limitgauge::model::test;

namespace {

constexpr std::size_t kMostMoves = 300;

/// What the reader makes of it; its error where it refuses.
struct Reading {
  std::vector<FlowMove> moves;
  std::string error;
};

Reading read(const std::string& text) {
  Reading result;
  try {
    std::istringstream in(text);
    // All numbers of these programs are whole.
    for (const Motion& motion : read_program(in, "random.ngc").motions)
      result.moves.push_back({static_cast<int>(motion.line), static_cast<int>(motion.to.x),
                              static_cast<int>(motion.to.y)});
  } catch (const InputError& error) {
    result.error = error.what();
  }
  return result;
}

}  // namespace

TEST_CASE("random programs do what their statements do", "[property][program][flow]") {
  std::mt19937 random(61);
  const auto mixture = GENERATE(FlowMixture::while_loops, FlowMixture::do_loops,
                                FlowMixture::loops_without_jumps, FlowMixture::everything);
  const bool may_be_refused =
      mixture == FlowMixture::do_loops || mixture == FlowMixture::everything;
  int read_programs = 0, refused = 0;
  for (int round = 0; round < 600; ++round) {
    const RandomFlow program = random_flow(random, mixture);
    const std::vector<FlowMove> expected = moves_of(program, kMostMoves);
    if (expected.empty()) continue;
    const Reading found = read(program.text);
    CAPTURE(program.text, found.error);
    if (may_be_refused && found.error.find("LinuxCNC would") != std::string::npos) {
      ++refused;
      continue;
    }
    REQUIRE(found.error.empty());
    REQUIRE(found.moves == expected);
    ++read_programs;
  }
  CHECK(read_programs > 300);
  CHECK((refused > 0) == may_be_refused);
  CHECK(refused < read_programs / 3);
}
