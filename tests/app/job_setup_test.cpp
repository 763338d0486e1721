#include "engine/model/error.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

std::string with_machine(const std::string& keys) {
  return with(good_job(), "[[tool]]", "[machine]\n" + keys + "\n[[tool]]");
}

}  // namespace

TEST_CASE("the machine and the programs' frame as a job states them", "[unit][job]") {
  const Job job = read(
      with(with_machine("home = [0, 0, 150]\nsecond_home = [1, 2, 3]\n"
                        "work_offsets = { G54 = [100, 50, 7], \"G59.1\" = { origin = [1, 2, 3], "
                        "rotate_z = 30 } }"),
           "[[tool]]", "[program_frame]\noffset = [4, 5, 6]\nrotate_z = 90\n[[tool]]"));
  CHECK(job.machine.home_mm == model::Vec3{0, 0, 150});
  CHECK(job.machine.second_home_mm == model::Vec3{1, 2, 3});
  REQUIRE(job.machine.work_offsets[0]);
  CHECK(job.machine.work_offsets[0]->origin_mm == model::Vec3{100, 50, 7});
  CHECK(!job.machine.work_offsets[1]);
  REQUIRE(job.machine.work_offsets[6]);
  CHECK(job.machine.work_offsets[6]->rotation_deg == 30);
  CHECK(job.program_frame.translate_mm == model::Vec3{4, 5, 6});
  CHECK(job.program_frame.rotate_z_deg == 90);
  CHECK(!job.machine.assume_fresh_machine);
}

TEST_CASE("tools with numbers are the machine's tool table", "[unit][job]") {
  const Job job = read(with(good_job(), "diameter = 6", "diameter = 6\nnumber = 12\nlength = 80"));
  REQUIRE(job.machine.tools.size() == 1);
  CHECK(job.machine.tools[0].number == 12);
  CHECK(job.machine.tools[0].length_mm == 80.0);
  CHECK(job.machine.tools[0].diameter_mm == 6.0);
  CHECK(job.stages[0].tool_number == 12);
  CHECK(read(good_job()).machine.tools.empty());
}

TEST_CASE("setups that a job gets wrong", "[unit][job]") {
  CHECK_THAT(error_of(with_machine("work_offsets = { G60 = [0, 0, 0] }")),
             ContainsSubstring("unknown key \"G60\" in \"work_offsets\" of [machine]"));
  CHECK_THAT(error_of(with_machine("work_offsets = { G54 = [0, 0] }")), ContainsSubstring("G54"));
  CHECK_THAT(error_of(with_machine("work_offsets = { G54 = { rotate_z = 3 } }")),
             ContainsSubstring("origin"));
  CHECK_THAT(error_of(with(good_job(), "diameter = 6", "diameter = 6\nlength = 80")),
             ContainsSubstring("\"length\" of a tool without a number"));
  CHECK_THAT(error_of(with(good_job(), "[[stage]]",
                           "[[tool]]\nid = \"b\"\ntype = \"ball\"\ndiameter = 4\nnumber = 1\n"
                           "[[tool]]\nid = \"c\"\ntype = \"ball\"\ndiameter = 4\nnumber = 1\n"
                           "[[stage]]")),
             ContainsSubstring("a second tool T1"));
  CHECK_THAT(error_of(with(good_job(), "step = 0.1", "step = 0.1\nprogram_tool = 1")),
             ContainsSubstring("\"program_tool\" in a stage without a program"));
}

}  // namespace limitgauge::app
