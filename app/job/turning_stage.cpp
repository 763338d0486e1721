#include "app/job/turning_stage.h"

#include "model/base/error.h"

namespace limitgauge::app {
namespace {

[[noreturn]] void refuse_beside_turns(const JobStage& stage, const std::string& what,
                                      const std::string& expected) {
  throw model::InputError(
      {stage.program.string(), 0, 0},
      "the tool turns in the part while stage \"" + stage.name + "\" cuts, and the job has " + what,
      expected);
}

}  // namespace

void require_turning_tool(const Job& job, const JobStage& stage) {
  if (job.tolerances)
    refuse_beside_turns(stage,
                        "[tolerances]: figures over tolerances are proven for tools that stand "
                        "upright",
                        "a job without [tolerances]");
  if (job.travel_mm)
    refuse_beside_turns(stage,
                        "\"travel\": where the machine's axes stand is not known of a path in the "
                        "part's frame",
                        "a job without \"travel\"");
  for (const JobFixture& fixture : job.fixtures)
    if (fixture.mount.kind != FixtureMount::Kind::part &&
        (!fixture.setup || *fixture.setup == stage.setup))
      refuse_beside_turns(stage,
                          "fixture \"" + fixture.name + "\", which does not turn with the part",
                          "fixtures that turn with the part alone");
}

}  // namespace limitgauge::app
