#include "model/base/error.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"
#include "tests/support/messages.h"

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

TEST_CASE("the control that programs are written for", "[unit][job]") {
  const Job extended = read(with_machine("work_offsets = { \"G54.1P12\" = [1, 2, 3] }"));
  CHECK(extended.machine.extended_offsets.at(12).origin_mm == model::Vec3{1, 2, 3});
  CHECK(read(with_machine("control = \"siemens\"")).machine.control == model::Control::siemens);
  CHECK(read(good_job()).machine.control == model::Control::linuxcnc);
  const auto error_of = [](const std::string& keys) {
    return tests::message_of<model::InputError>([&] { read(with_machine(keys)); });
  };
  CHECK_THAT(error_of("control = \"hass\""), ContainsSubstring("haas"));
  CHECK_THAT(error_of("subprograms = \"no-such-folder\""),
             ContainsSubstring("no folder \"no-such-folder\""));
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

TEST_CASE("where programs start, as a job states it", "[unit][job]") {
  CHECK(read(with_machine("start = [1, 2, 30]")).machine.start_mm == model::Vec3{1, 2, 30});
  CHECK(!read(good_job()).machine.start_mm);
  CHECK(read(good_job(), {"machine.start=[0, 0, 9]"}).machine.start_mm == model::Vec3{0, 0, 9});
  // The key stands in the second line of what with_machine puts before [[tool]], line 8.
  const auto wrong = [](const std::string& value) {
    return error_of(with_machine("start = " + value));
  };
  CHECK_THAT(wrong("[0, 0]"), ContainsSubstring("job.toml:9:9: error: \"start\" in [machine] has 2 "
                                                "entries; expected an array of three numbers"));
  CHECK_THAT(wrong("[0, nan, 0]"),
             ContainsSubstring("job.toml:9:9: error: \"start\" in [machine] has an entry that is "
                               "no finite number"));
  CHECK_THAT(wrong("\"above\""), ContainsSubstring("job.toml:9:9: error: \"start\""));
  CHECK_THAT(wrong("[0, 0, 10001]"),
             ContainsSubstring("job.toml:9:9: error: \"start\" in [machine] has z = 10001 mm; "
                               "expected at most 10000 mm (10 m) from zero"));
}

TEST_CASE("places of a job beyond 10 m", "[unit][job]") {
  CHECK_THAT(error_of(with_machine("work_offsets = { G54 = [0, -10001, 0] }")),
             ContainsSubstring("job.toml:9:24: error: \"G54\" in \"work_offsets\" of [machine] has "
                               "y = -10001 mm"));
  CHECK_THAT(error_of(with_machine("home = [1e6, 0, 0]")), ContainsSubstring("x = 1"));
  CHECK_THAT(error_of(with(good_job(), "[26, 26, 9]", "[26, 26, 10005]")),
             ContainsSubstring("job.toml:6:8: error: the stock reaches to z = 10001 mm"));
  CHECK_THAT(error_of(with(good_job(), "[-13, -13, -4]", "[-13, -13e3, -4]")),
             ContainsSubstring("job.toml:7:10: error: \"corner\" in [stock] has y = -13000 mm"));
  CHECK_THAT(
      error_of(with(good_job(), "diameter = 6", "diameter = 20001")),
      ContainsSubstring("\"diameter\" in [[tool]] is 20001 mm; expected a length from 1e-6 to "
                        "10000 mm"));
  CHECK_THAT(error_of(with(good_job(), "diameter = 6",
                           "diameter = 6\nholder = { diameter = 9, length = 1e5 }")),
             ContainsSubstring("\"length\" in holder of [[tool]] is 100000 mm"));
  CHECK_THAT(error_of(with(good_job(), "diameter = 6", "diameter = 6\nnumber = 1\nlength = 1e5")),
             ContainsSubstring("\"length\" in [[tool]] is "));
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
