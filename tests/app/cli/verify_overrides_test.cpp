#include "app/verify/verify_job.h"

#include "model/base/error.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"

namespace limitgauge::app {
namespace {

/// As `verify` makes it of a program that loads two tools.
Job two_tools() {
  Job job;
  job.name = "plate";
  job.near_miss_mm = 0.5;
  job.design.emplace();
  for (const char* name : {"T1", "T2"}) {
    JobStage stage;
    stage.name = name;
    stage.allowance_mm = 0.1;
    job.stages.push_back(stage);
  }
  job.stages[1].limits.has_gouge = job.stages[1].limits.has_uncut = true;
  job.stages[1].limits.gouge_mm = 0.01, job.stages[1].limits.uncut_mm = 0.02;
  job.stages[1].limits.has_unreachable = true;
  job.stages[1].limits.unreachable_is_share = false;
  job.stages[1].limits.unreachable = 12.5;
  return job;
}

Job with(const std::vector<std::string>& overrides) {
  Job job = two_tools();
  apply_verify_overrides(job, overrides);
  return job;
}

std::string error_of(const std::string& override) {
  return tests::message_of<model::InputError>([&] { with({override}); });
}

}  // namespace

TEST_CASE("keys of a job replace what verify's options leave open", "[unit][cli]") {
  const Job job =
      with({"name=other", "simulation.voxel=0.2", "verification.resolution=0.0005",
            "report.pictures=false", "machine.rapid=8000", "program_frame.offset=[1, 2, 3]",
            "surface.transform.scale=2", "stage.T1.gate.uncut=2", "stage.T2.allowance=0",
            "stage.T2.gate.gouge=0.03", "stage.T2.gate.unreachable=0.05"});
  CHECK(job.name == "other");
  CHECK(job.voxel_mm == 0.2);
  CHECK(job.resolution_mm == 0.0005);
  CHECK_FALSE(job.pictures);
  CHECK(job.rapid_mm_min == 8000);
  CHECK(job.program_frame.translate_mm == model::Vec3{1, 2, 3});
  CHECK(job.design->placement.scale == 2);
  CHECK(job.stages[0].limits.has_uncut);
  CHECK(job.stages[0].limits.uncut_mm == 2);
  CHECK_FALSE(job.stages[0].limits.has_gouge);
  CHECK(job.stages[0].allowance_mm == 0.1);
  CHECK(job.stages[1].allowance_mm == 0);
  CHECK(job.stages[1].limits.gouge_mm == 0.03);
  CHECK(job.stages[1].limits.unreachable_is_share);
  CHECK(job.stages[1].limits.unreachable == 0.05);
}

TEST_CASE("what no override names stays as the options say", "[unit][cli]") {
  const Job job = with({"simulation.voxel=0.2"});
  CHECK(job.name == "plate");
  CHECK(job.near_miss_mm == 0.5);
  CHECK(job.stages[1].limits.gouge_mm == 0.01);
  CHECK(job.stages[1].limits.uncut_mm == 0.02);
  CHECK(job.stages[1].limits.unreachable == 12.5);
  CHECK_FALSE(job.stages[1].limits.unreachable_is_share);
  CHECK_FALSE(job.stages[0].limits.has_gouge);
}

TEST_CASE("an override that verify cannot take is refused by its own words", "[unit][cli]") {
  CHECK(error_of("simulation.vox=1") ==
        "--set simulation.vox=1: error: unknown key \"vox\" in [simulation]; expected \"voxel\" or "
        "another known key");
  CHECK_THAT(error_of("speed=1"), ContainsSubstring("unknown key \"speed\" in the job"));
  CHECK_THAT(error_of("stage.T3.gate.uncut=1"), ContainsSubstring("no stage is called \"T3\""));
  CHECK_THAT(error_of("stage.T2.gate.uncut=a"), ContainsSubstring("--set stage.T2.gate.uncut=a"));
  CHECK_THAT(error_of("stage.T2.step=1"), ContainsSubstring("unknown key \"step\""));
  CHECK_THAT(error_of("stage.T2.name=x"), ContainsSubstring("names its stages itself"));
  CHECK_THAT(error_of("name=a/b"), ContainsSubstring("cannot name a folder"));
  CHECK_THAT(error_of("surface.cage=a.obj"), ContainsSubstring("expected --cage"));
  CHECK_THAT(error_of("stock.shape=box"), ContainsSubstring("expected --stock"));
  CHECK_THAT(error_of("stage.T1.program=p.ngc"), ContainsSubstring("expected --program"));
}

}  // namespace limitgauge::app
