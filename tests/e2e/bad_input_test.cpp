#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

struct BadInput {
  std::vector<std::string> arguments;
  std::string error;  ///< part of what is said
};

std::string job_with(const std::string& from, const std::string& to) {
  std::string text = read_text(fixture("jobs/quick-dome.toml"));
  text.replace(text.find("../cages"), 8, fixture("cages"));
  return text.replace(text.find(from), from.size(), to);
}

const std::string kQuad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_CASE("bad input is refused with exit code 3 and nothing written", "[e2e][bad_input]") {
  const Scratch scratch;
  write_text(scratch / "typo.toml", job_with("tolerance = 0.05", "tolernace = 0.05"));
  write_text(scratch / "named.toml", job_with("name = \"rough\"", "name = \"report.html\""));
  write_text(scratch / "rest.toml", job_with("\"contour\"", "\"rest\""));
  write_text(scratch / "no_cage.toml", job_with("quick-dome.obj", "no-such.obj"));
  write_text(scratch / "no_toml.toml", "name = \n");
  write_text(
      scratch / "program.toml",
      job_with("strategy = \"contour\"\nstep = 0.5\nallowance = 0.3\ntolerance = 0.05\nfeed = "
               "1200\nplunge_feed = 300\nlink_feed = 1200\ndirection = \"climb\"\nentry = "
               "\"ramp\"\nramp_angle = 3\nfloor = -0.5",
               "program = \"bad.ngc\""));
  write_text(scratch / "bad.ngc", "G21 G90\nG0 X0 Y0 Z10\nG777 X1\n");
  write_text(scratch / "good.ngc", "G21 G90\nG0 X0 Y0 Z10\nG1 X1 F100\nM30\n");
  write_text(scratch / "butterfly.obj",
             kQuad + "v 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\nf 2 3 4 1\n");
  write_text(scratch / "index.obj", kQuad + "f 1 2 3 9\n");
  write_text(scratch / "quad.obj", kQuad + "f 1 2 3 4\n");
  write_text(scratch / "point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3 4\n");
  write_text(scratch / "far.obj", kQuad + "v 1e6 0 0\nf 1 2 3 4\n");
  write_text(scratch / "far.ngc", "G21 G90\nG0 X0 Y0 Z10\nG1 X10000 F100\nG1 X10001\nM30\n");
  const std::vector<std::string> before = scratch.entries();
  const auto verify = [](const std::string& cage, const std::string& stock, const std::string& tool,
                         const std::string& program) {
    return std::vector<std::string>{"verify", "--cage", cage,        "--stock", stock,
                                    "--tool", tool,     "--program", program};
  };
  const std::string box = "box:4,4,4@-1,-1,-3", ball = "ball:D=6";
  const std::vector<BadInput> table = {
      {{"run", "typo.toml"}, "unknown key \"tolernace\" in [[stage]]; expected \"tolerance\""},
      {{"run", "rest.toml"}, "rest.toml:39:12: error: a rest stage is the first"},
      {{"run", "no_cage.toml"}, "no file"},
      {{"run", "no_toml.toml"}, "no_toml.toml:1:"},
      {{"run", "nowhere.toml"}, "nowhere.toml"},
      {{"run", "program.toml"}, "bad.ngc:3:"},
      {{"plan", "typo.toml"}, "typo.toml:42:1"},
      {{"run", "typo.toml", "--set", "nonsense"}, "--set nonsense: error"},
      {verify("butterfly.obj", box, ball, "good.ngc"), "butterfly.obj"},
      {verify("index.obj", box, ball, "good.ngc"), "index.obj:5:"},
      {verify("quad.obj", "box:4,4@0,0,0", ball, "good.ngc"), "--stock"},
      {verify("quad.obj", "mesh:a.stl", ball, "good.ngc"), "there is no such file"},
      {verify("quad.obj", box, "ball:D=-6", "good.ngc"), "--tool"},
      {verify("quad.obj", box, "cube:D=6", "good.ngc"), "--tool"},
      {verify("quad.obj", box, ball, "bad.ngc"), "bad.ngc:3:1"},
      {verify("point.obj", box, ball, "good.ngc"),
       "point.obj: error: the limit surface has no area"},
      {verify("far.obj", box, ball, "good.ngc"),
       "far.obj:5:1: error: the cage has a vertex at x = "},
      {verify("quad.obj", "box:4,4,20000@0,0,0", ball, "good.ngc"), "z = 20000 mm"},
      {verify("quad.obj", box, "ball:D=6,holder=9:10001", "good.ngc"), "10001 mm"},
      {verify("quad.obj", box, ball, "far.ngc"), "far.ngc:4: error: the tip moves to x = 10001 mm"},
      {{"inspect", "good.ngc", "--start", "1,2"}, "--start 1,2: 2 numbers; expected X,Y,Z"},
      {{"inspect", "index.obj"}, "index.obj:5:"},
      {{"inspect", "bad.ngc", "--moves"}, "bad.ngc:3:1"},
      {{"inspect", "quad.obj", "--samples", "3", "--csv", "no/such/folder.csv"}, "folder"},
      {{"inspect", "quad.obj", "--samples", "3", "--csv", "quad.obj"},
       "something else than samples"},
      {{"inspect", "quad.obj", "--samples", "3", "--csv", "typo.toml"},
       "something else than samples"},
      {{"run", "typo.toml", "-o", ""}, "is empty"},
      {{"run", "typo.toml", "--history", ""}, "is empty"},
      {{"plan", "named.toml"}, "\"report.html\" is a file of the results"},
      {{"run", fixture("jobs/quick-dome.toml"), "--jobs", "2"}, "limitgauge: error: --jobs"},
      {{"rnu", "a.toml"}, "'run'"},
      {{}, "error"},
  };
  for (const BadInput& bad : table) {
    CAPTURE(bad.arguments);
    const Outcome outcome = limitgauge(scratch, bad.arguments);
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.errors, ContainsSubstring(bad.error) && ContainsSubstring("error: "));
    CHECK(scratch.entries() == before);
  }
}

}  // namespace
}  // namespace limitgauge::e2e
