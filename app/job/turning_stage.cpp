#include "app/job/turning_stage.h"

#include "model/base/error.h"
#include "model/gcode/turning/turning_program.h"

namespace limitgauge::app {
namespace {

[[noreturn]] void refuse_beside_turns(const JobStage& stage, const std::string& what,
                                      const std::string& expected) {
  throw model::InputError(
      stage.plan ? stage.plan->tilt_place : model::SourcePlace{stage.program.string(), 0, 0},
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
  if (job.travel_mm && !stage.piece && !stage.plan)
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

namespace {

void require(bool holds, const JobStage& stage, const std::string& wrong,
             const std::string& expected) {
  if (holds) return;
  throw model::InputError(stage.plan->tilt_place,
                          "the tool of stage \"" + stage.name + "\" is to lean, " + wrong,
                          expected);
}

/// What its program is written with.
void require_posted(const Job& job, const JobStage& stage) {
  const model::Control control = job.machine.control;
  require(model::has_tip_control(control), stage,
          "and control " + std::string(name(control)) + " has no words for it here",
          "control = \"fanuc\", \"haas\" or \"linuxcnc\" in [machine]");
  const std::string dialect = name(model::dialect_for(control));
  require(job.post.dialect == model::dialect_for(control), stage,
          "and [post] writes " + std::string(name(job.post.dialect)) + " for control " +
              std::string(name(control)),
          "dialect = \"" + dialect + "\" in [post]");
  require(job.machine.tools.empty() || stage.tool_number, stage,
          "and of the job's numbered tools it is none",
          "\"number\" of tool \"" + stage.cutter.id + "\"");
}

}  // namespace

void require_leaning_stages(const Job& job) {
  for (const JobStage& stage : job.stages) {
    if (!stage.plan || !stage.plan->cut.lean) continue;
    require(job.machine.kinematics.has_value(), stage, "and the machine has no axes for that",
            "kinematics and [[machine.axis]] in [machine]");
    require_posted(job, stage);
    require(!job.machine.kinematics->has_head() || stage.tool_length_mm, stage,
            "by a head, and how long it is is not stated",
            "\"length\" and \"number\" of tool \"" + stage.cutter.id + "\"");
    require(job.program_frame == model::RigidPlacement(), stage,
            "and [program_frame] is of programs of others", "a job without it");
    require_turning_tool(job, stage);
  }
}

}  // namespace limitgauge::app
