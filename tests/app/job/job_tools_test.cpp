#include <algorithm>

#include "model/base/error.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

/// A job whose one stage reads a program, cut with a tool of these lines (the first is line 11).
std::string job_with(const std::string& tool) {
  std::string job = with(good_job(), "type = \"ball\"\ndiameter = 6\n", tool);
  const std::size_t plan = job.find("strategy");
  // Any file will do: nothing of it is read here.
  return job.replace(plan, job.find("[stage.gate]") - plan, "program = \"cages/quick-dome.obj\"\n");
}

model::Cutter tool_of(const std::string& lines) {
  return read(job_with(lines)).stages.at(0).cutter;
}

bool says_plunge(const std::string& lines) {
  const auto said = read(job_with(lines)).defaulted;
  return std::find(said.begin(), said.end(), "tool ball3: taken to be able to plunge") !=
         said.end();
}

}  // namespace

TEST_CASE("drills and apt cutters of a job", "[unit][job]") {
  const model::Cutter drill =
      tool_of("type = \"drill\"\ndiameter = 6\npoint_angle = 118\nflute_length = 40\n");
  CHECK(to_text(drill) == "drill:D=6,angle=118,L=40");
  const std::string apt =
      "type = \"apt\"\ndiameter = 10\ncorner_radius = 1\ntip_angle = 0\nside_angle = 0\n";
  CHECK(to_text(tool_of(apt + "e = 4.005\nf = 1\n")) == "apt:D=10,r=1,L=40");
  CHECK(to_text(tool_of("type = \"apt\"\ndiameter = 10\ncorner_radius = 1\ntip_angle = 12\n"
                        "side_angle = -5\nmax_ramp_angle = 3\n")) ==
        "apt:D=10,r=1,a=12,b=-5,L=40,ramp=3");
}

TEST_CASE("drills and apt cutters that a job gets wrong", "[unit][job]") {
  const auto refused = [](const std::string& lines, const std::string& error) {
    CHECK_THAT(error_of(job_with(lines)), ContainsSubstring(error));
  };
  refused("type = \"drill\"\ndiameter = 6\n", "\"point_angle\"");
  refused("type = \"drill\"\ndiameter = 6\npoint_angle = 180\n", "job.toml:12:15: error: ");
  refused("type = \"drill\"\ndiameter = 6\npoint_angle = 90\ncorner_radius = 1\n",
          "job.toml:13:17: error: a drill cutter has no corner_radius; expected no such key, or "
          "type \"bull\", \"taper\" or \"apt\"");
  refused("type = \"flat\"\ndiameter = 6\ntip_angle = 3\n",
          "job.toml:12:13: error: a flat cutter has no tip_angle; expected no such key, or type "
          "\"apt\"");
  refused("type = \"apt\"\ndiameter = 10\ncorner_radius = 1\ntip_angle = 0\n", "\"side_angle\"");
  const std::string apt =
      "type = \"apt\"\ndiameter = 10\ncorner_radius = 1\ntip_angle = 0\nside_angle = ";
  refused(apt + "90\n", "tool \"ball3\": side angle must lie between -90 and 90 degrees");
  refused(apt + "0\ne = 3.9\n",
          "job.toml:15:5: error: tool \"ball3\": e is 3.9, but the other figures make it 4");
  refused(apt + "0\nf = 1.2\n", "f is 1.2, but the other figures make it 1");
}

TEST_CASE("how steeply a tool may go down", "[unit][job]") {
  const std::string flat = "type = \"flat\"\ndiameter = 6\n";
  CHECK(tool_of(flat).steepest_descent_deg == 90);
  CHECK(tool_of(flat + "plunge = true\n").steepest_descent_deg == 90);
  CHECK(tool_of(flat + "plunge = false\n").steepest_descent_deg == 0);
  CHECK(tool_of(flat + "plunge = false\nmax_ramp_angle = 3\n").steepest_descent_deg == 3);
  CHECK(tool_of(flat + "max_ramp_angle = 0\n").steepest_descent_deg == 0);
  CHECK(tool_of(flat + "plunge = true\nmax_ramp_angle = 90\n").steepest_descent_deg == 90);
  CHECK(says_plunge(flat));
  CHECK(says_plunge("type = \"bull\"\ndiameter = 6\ncorner_radius = 1\n"));
  CHECK_FALSE(says_plunge(flat + "plunge = true\n"));
  CHECK_FALSE(says_plunge(flat + "max_ramp_angle = 9\n"));
  CHECK_FALSE(says_plunge("type = \"ball\"\ndiameter = 6\n"));
  CHECK(
      error_of(job_with(flat + "plunge = true\nmax_ramp_angle = 3\n")) ==
      "job.toml:13:18: error: \"max_ramp_angle\" 3 contradicts plunge = true; expected one of the "
      "two keys");
  CHECK_THAT(error_of(job_with(flat + "plunge = false\nmax_ramp_angle = 90\n")),
             ContainsSubstring("contradicts plunge = false"));
  CHECK_THAT(error_of(job_with(flat + "max_ramp_angle = 91\n")),
             ContainsSubstring("job.toml:12:18: error: \"max_ramp_angle\" in [[tool]] is 91"));
}

TEST_CASE("strategies refuse drills and apt cutters at the stage's tool", "[unit][job]") {
  const auto job = [](const std::string& tool) {
    return with(good_job(), "type = \"ball\"\ndiameter = 6\n", tool);
  };
  CHECK(error_of(job("type = \"drill\"\ndiameter = 6\npoint_angle = 118\n")) ==
        "job.toml:15:8: error: strategy \"zigzag\" with the drill cutter \"ball3\"; expected "
        "flat, ball, bull or taper; a program takes any tool");
  CHECK_THAT(error_of(job("type = \"apt\"\ndiameter = 6\ncorner_radius = 1\ntip_angle = 0\n"
                          "side_angle = 0\n")),
             ContainsSubstring("with the apt cutter"));
}

}  // namespace limitgauge::app
