#include "app/job/job_reader.h"

#include "model/base/error.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"

namespace limitgauge::app {
namespace {

using namespace engine::strategy;

struct BadJob {
  std::string from, to, error;
};

TEST_CASE("a job is read with its defaults stated", "[unit][job]") {
  const Job job = read(good_job());
  CHECK(job.name == "dome");
  CHECK(job.design->file == tests::fixtures() / "cages/quick-dome.obj");
  CHECK(std::get<model::BoxStock>(job.stock).size_mm == model::Vec3{26, 26, 9});
  REQUIRE(job.stages.size() == 1);
  const JobStage& stage = job.stages[0];
  CHECK(stage.cutter.corner_radius_mm == 3);
  CHECK(stage.cutter.flute_length_mm == 24);
  CHECK(stage.plan->cut.strategy == Strategy::zigzag);
  CHECK(stage.plan->cut.step_mm == 0.1);
  CHECK(stage.plan->cut.plunge_feed_mm_min == Approx(500));
  CHECK_FALSE(stage.plan->floor_z_mm.has_value());
  CHECK(stage.limits.has_gouge);
  CHECK_FALSE(stage.limits.has_uncut);
  CHECK_FALSE(job.voxel_mm.has_value());
  CHECK_FALSE(job.resolution_mm.has_value());
  CHECK(job.pictures);
  CHECK(job.stock_surface == reports::StockSurfaceFile::cut);
  CHECK_FALSE(job.acceleration_mm_s2.has_value());
  CHECK(job.post.dialect == model::Dialect::linuxcnc);
  CHECK(job.post.decimals == 4);
  CHECK_FALSE(job.post.arc_tolerance_mm.has_value());
  CHECK_FALSE(job.post.line_numbers);
  CHECK_FALSE(job.post.cl_data);
  // precision, rapid, clearance, flutes, the stage's cut, allowance, programs: seven were left
  // open.
  CHECK(job.defaulted.size() == 7);
}

TEST_CASE("every key of a job is taken over", "[unit][job]") {
  const Job job = read(R"(name = "all"
[surface]
cage = "cages/quick-dome.obj"
precision = 0.02
transform = { scale = 2.0, rotate_z = 90, translate = [1, 2, 3] }
[stock]
shape = "cylinder"
diameter = 50
height = 20
base = [1, 2, -5]
[machine]
rapid = 8000
clearance = 3
acceleration = 400
junction_deviation = 0.02
[post]
dialect = "fanuc"
decimals = 4
arcs = 0.003
line_numbers = true
cl_data = true
[[tool]]
id = "t"
type = "taper"
diameter = 1
corner_radius = 0.4
angle = 5
flute_length = 12
shank = { diameter = 6, length = 40 }
holder = [ { diameter = 20, length = 10 }, { diameter = 40, length = 30 } ]
[[stage]]
name = "s"
tool = "t"
strategy = "contour"
step = 0.5
allowance = 0.1
tolerance = 0.03
feed = 900
plunge_feed = 200
link_feed = 700
direction = "conventional"
entry = "helix"
ramp_angle = 5
floor = -1.5
[stage.gate]
gouge = 0.04
uncut = 0.05
coverage = 0.9
[simulation]
voxel = 0.2
[verification]
resolution = 0.002
[report]
pictures = false
stock = "none"
)");
  CHECK(job.design->precision_mm == 0.02);
  CHECK(job.design->placement.scale == 2);
  CHECK(job.design->placement.rotate_z_deg == 90);
  CHECK(job.design->placement.translate_mm == model::Vec3{1, 2, 3});
  const auto& stock = std::get<model::CylinderStock>(job.stock);
  CHECK(stock.diameter_mm == 50);
  CHECK(stock.height_mm == 20);
  CHECK(stock.base_mm == model::Vec3{1, 2, -5});
  CHECK(job.rapid_mm_min == 8000);
  CHECK(job.clearance_mm == 3);
  CHECK(job.acceleration_mm_s2 == 400);
  CHECK(job.junction_deviation_mm == 0.02);
  CHECK(job.post.dialect == model::Dialect::fanuc);
  CHECK(job.post.decimals == 4);
  CHECK(job.post.arc_tolerance_mm == 0.003);
  CHECK(job.post.line_numbers);
  CHECK(job.post.cl_data);
  const JobStage& stage = job.stages.at(0);
  CHECK(stage.cutter.type == model::CutterType::taper);
  CHECK(stage.cutter.taper_angle_deg == 5);
  CHECK(stage.cutter.corner_radius_mm == 0.4);
  CHECK(stage.cutter.flute_length_mm == 12);
  CHECK(stage.cutter.shank.size() == 1);
  REQUIRE(stage.cutter.holder.size() == 2);
  CHECK(stage.cutter.holder[1].diameter_mm == 40);
  CHECK(stage.plan->cut.strategy == Strategy::contour);
  CHECK(stage.plan->floor_z_mm == -1.5);
  CHECK(stage.plan->cut.plunge_feed_mm_min == 200);
  CHECK(stage.plan->cut.link_feed_mm_min == 700);
  CHECK(stage.plan->cut.direction == CutDirection::conventional);
  CHECK(stage.plan->cut.entry == Entry::helix);
  CHECK(stage.plan->cut.ramp_angle_deg == 5);
  CHECK(stage.allowance_mm == 0.1);
  CHECK(stage.limits.coverage == 0.9);
  CHECK(stage.limits.uncut_mm == 0.05);
  CHECK(job.voxel_mm == 0.2);
  CHECK(job.resolution_mm == 0.002);
  CHECK_FALSE(job.pictures);
  CHECK(job.stock_surface == reports::StockSurfaceFile::none);
  CHECK(job.defaulted.empty());
}

TEST_CASE("a bad job is refused with its place and what was expected", "[unit][job]") {
  const std::vector<BadJob> table = {
      {"step = 0.1", "stpe = 0.1",
       "job.toml:16:1: error: unknown key \"stpe\" in [[stage]]; expected \"step\" or another "
       "known "
       "key"},
      {"[surface]", "[surfaces]\na = 1\n[surface]",
       "job.toml:2:2: error: unknown key \"surfaces\" in the job; expected \"surface\" or another "
       "known key"},
      {"size = [26, 26, 9]", "size = [26, 26]",
       "job.toml:6:8: error: \"size\" in [stock] has 2 entries; expected an array of three "
       "numbers"},
      {"size = [26, 26, 9]", "size = [26, -26, 9]",
       "job.toml:6:8: error: a size of the stock is -26 mm, not above zero; expected three lengths "
       "from 1e-6 mm on"},
      {"size = [26, 26, 9]", "size = [26, \"26\", 9]",
       "job.toml:6:8: error: \"size\" in [stock] has an entry that is no finite number: '26'; "
       "expected an array of three numbers"},
      {"shape = \"box\"", "shape = \"bax\"",
       "job.toml:5:9: error: \"shape\" in [stock] is \"bax\"; expected one of \"box\", "
       "\"cylinder\", "
       "\"mesh\", \"vdb\""},
      {"diameter = 6", "diameter = 0",
       "job.toml:11:12: error: \"diameter\" in [[tool]] is 0; expected a number above zero"},
      {"diameter = 6", "diameter = nan",
       "job.toml:11:12: error: \"diameter\" in [[tool]] is nan; expected a finite number"},
      {"diameter = 6", "diameter = \"6\"",
       "job.toml:11:12: error: \"diameter\" in [[tool]] is of type string: '6'; expected a number"},
      {"diameter = 6", "diameter = 6\ncorner_radius = 1",
       "job.toml:12:17: error: a ball cutter has no corner_radius; expected no such key, or type "
       "\"bull\", \"taper\" or \"apt\""},
      {"tool = \"ball3\"", "tool = \"ball4\"",
       "job.toml:14:8: error: no tool has the id \"ball4\"; expected \"ball3\" or another id of a "
       "[[tool]]"},
      {"strategy = \"zigzag\"", "strategy = \"spiral\"",
       "job.toml:15:12: error: \"strategy\" in [[stage]] is \"spiral\"; expected one of "
       "\"contour\", \"zigzag\", \"steep_shallow\", \"rest\""},
      {"strategy = \"zigzag\"", "strategy = \"zigzag\"\nsteep_angle = 30",
       "job.toml:16:15: error: \"steep_angle\" changes nothing of strategy \"zigzag\"; expected a "
       "key that this strategy uses"},
      {"strategy = \"zigzag\"", "strategy = \"zigzag\"\nprogram = \"a.ngc\"",
       "job.toml:16:11: error: stage \"finish\" has both strategy and program; expected one of the "
       "two"},
      {"strategy = \"zigzag\"\n", "",
       "job.toml:12:1: error: stage \"finish\" has neither strategy nor program; expected one of "
       "the "
       "two"},
      {"feed = 1500\n", "",
       "job.toml:12:1: error: missing key \"feed\" in [[stage]]; expected the key to be stated"},
      {"step = 0.1", "step = -0.1",
       "job.toml:16:8: error: \"step\" in [[stage]] is -0.1; expected a number above zero"},
      {"gouge = 0.01", "gouge = 0",
       "job.toml:20:9: error: \"gouge\" in [stage.gate] is 0; expected a number above zero"},
      {"gouge = 0.01", "coverage = 0.9",
       "job.toml:20:12: error: without a limit of gouge or uncut all of the surface is within; "
       "expected one of the two to be stated beside it"},
      {"gouge = 0.01", "coverage = 1.5",
       "job.toml:20:12: error: \"coverage\" in [stage.gate] is 1.5; expected a share from 0 to 1"},
      {"gouge = 0.01", "unreachable = \"12 cm2\"",
       "job.toml:20:15: error: \"unreachable\" in [stage.gate] is \"12 cm2\"; expected a share "
       "from 0 to 1, or an area as \"12.5 mm2\""},
      {"gouge = 0.01", "unreachable = 1.5",
       "job.toml:20:15: error: \"unreachable\" in [stage.gate] is 1.5; expected a share from 0 to "
       "1"},
      {"gouge = 0.01", "unavoidable = -0.1",
       "job.toml:20:15: error: \"unavoidable\" in [stage.gate] is -0.1; expected a number that is "
       "not negative"},
      {"gouge = 0.01", "gouges = 0.01",
       "job.toml:20:1: error: unknown key \"gouges\" in [stage.gate]; expected \"gouge\" or "
       "another "
       "known key"},
      {"name = \"finish\"", "name = \"fi/nish\"",
       "job.toml:13:8: error: \"fi/nish\" cannot name a folder; expected letters, digits, '.', "
       "'_', "
       "'-'"},
      {"cages/quick-dome.obj", "cages/no-such-cage.obj",
       "job.toml:3:8: error: no file \"cages/no-such-cage.obj\"; expected a cage as OBJ"},
      {"name = \"dome\"\n", "",
       "job.toml:1:1: error: missing key \"name\" in the job; expected the key to be stated"},
  };
  for (const BadJob& bad : table) {
    CAPTURE(bad.to);
    CHECK(error_of(with(good_job(), bad.from, bad.to)) == bad.error);
  }
}

TEST_CASE("what is no TOML is refused with its place", "[unit][job]") {
  CHECK_THAT(error_of(with(good_job(), "[stock]", "[stock")),
             ContainsSubstring("job.toml:4:") && ContainsSubstring("error: "));
  CHECK_THAT(error_of(good_job() + "name = \"twice\"\nname = \"twice\"\n"),
             ContainsSubstring("job.toml:22:"));
}

TEST_CASE("names of stages and tools must differ", "[unit][job]") {
  const std::string stage = good_job().substr(good_job().find("[[stage]]"));
  CHECK(error_of(good_job() + stage) ==
        "job.toml:22:8: error: a second stage \"finish\"; expected names that differ");
  const std::string tool = "[[tool]]\nid = \"ball3\"\ntype = \"ball\"\ndiameter = 4\n[[stage]]";
  CHECK(error_of(with(good_job(), "[[stage]]", tool)) ==
        "job.toml:13:6: error: a second tool \"ball3\"; expected ids that differ");
}

TEST_CASE("a rest stage needs a stage before it", "[unit][job]") {
  const std::string rest = with(good_job(), "strategy = \"zigzag\"", "strategy = \"rest\"");
  CHECK_THAT(error_of(rest),
             ContainsSubstring("job.toml:15:") && ContainsSubstring("nothing was cut before it"));
}

TEST_CASE("a stage with a program takes no figures of a plan", "[unit][job]") {
  const std::string text = with(good_job(), "strategy = \"zigzag\"", "program = \"a.ngc\"");
  CHECK(error_of(text) ==
        "job.toml:16:8: error: \"step\" beside \"program\" would change nothing; expected it only "
        "beside \"strategy\"");
}

TEST_CASE("overrides count as if they stood in the file", "[unit][job]") {
  const Job job = read(
      good_job(), {"stage.finish.step=0.25", "tool.ball3.diameter=4", "simulation.voxel=0.3",
                   "stage.finish.gate.uncut=0.02", "name=other", "verification.resolution=auto"});
  CHECK(job.stages[0].plan->cut.step_mm == 0.25);
  CHECK(job.stages[0].cutter.diameter_mm == 4);
  CHECK(job.stages[0].limits.uncut_mm == 0.02);
  CHECK(job.stages[0].limits.gouge_mm == 0.01);
  CHECK(job.voxel_mm == 0.3);
  CHECK(job.name == "other");
  CHECK_FALSE(job.resolution_mm.has_value());
}

TEST_CASE("a bad override is refused by its own text", "[unit][job]") {
  const std::vector<std::array<std::string, 2>> table = {
      {"stage.finish.stpe=0.2",
       "--set stage.finish.stpe=0.2: error: unknown key \"stpe\" in [[stage]]; expected \"step\" "
       "or "
       "another known key"},
      {"stage.finish.step=0",
       "--set stage.finish.step=0: error: \"step\" in [[stage]] is 0; expected a number above "
       "zero"},
      {"stage.finish.step=wide",
       "--set stage.finish.step=wide: error: \"step\" in [[stage]] is of type string: 'wide'; "
       "expected a number"},
      {"stage.rough.step=1",
       "--set stage.rough.step=1: error: no stage is called \"rough\"; expected one of the job's"},
      {"stage.finish=1",
       "--set stage.finish=1: error: no key after the stage; expected stage.NAME.KEY=value"},
      {"name.x=1", "--set name.x=1: error: \"name\" is no table; expected a key of a table"},
      {"nonsense", "--set nonsense: error: no '=' in it; expected key=value"},
      {"a..b=1",
       "--set a..b=1: error: an empty name in the key; expected dotted names, as "
       "stage.rough.step"},
      {"name=",
       "--set name=: error: the value cannot be read; expected a number, true, false, text "
       "or [list]"},
  };
  for (const auto& [override, error] : table) {
    CHECK(error_of(good_job(), {override}) == error);
  }
}

TEST_CASE("travel limits, fixtures and clearances are read as they stand", "[unit][job]") {
  const Job job = read(good_job() + R"(
[machine]
travel = { x = [-20, 20.5], z = [0, 50] }
[[fixture]]
name = "clamp"
file = "findings/clamp.obj"
translate = [1, 2, 3]
[simulation]
near_miss = 2
contact_tolerance = 0.05
)");
  REQUIRE(job.travel_mm);
  CHECK(job.travel_mm->low.x == -20);
  CHECK(job.travel_mm->high.x == 20.5);
  CHECK(std::isinf(job.travel_mm->low.y));
  CHECK(job.travel_mm->high.z == 50);
  REQUIRE(job.fixtures.size() == 1);
  CHECK(job.fixtures[0].name == "clamp");
  CHECK(job.fixtures[0].translate_mm == model::Vec3{1, 2, 3});
  CHECK(job.near_miss_mm == 2);
  CHECK(job.contact_tolerance_mm == 0.05);

  const auto wrong = [](const std::string& more) { return error_of(good_job() + more); };
  CHECK_THAT(wrong("[machine]\ntravel = { x = [5, 5] }\n"),
             ContainsSubstring("is no pair of ascending numbers"));
  CHECK_THAT(wrong("[machine]\ntravel = { w = [0, 5] }\n"), ContainsSubstring("\"w\""));
  CHECK_THAT(wrong("[[fixture]]\nname = \"a\"\nfile = \"none.stl\"\n"),
             ContainsSubstring("no file \"none.stl\""));
  const std::string clamp = "[[fixture]]\nname = \"a\"\nfile = \"findings/clamp.obj\"\n";
  CHECK_THAT(wrong(clamp + clamp), ContainsSubstring("a second fixture \"a\""));
  CHECK_THAT(wrong("[simulation]\nnear_miss = 0\n"), ContainsSubstring("above zero"));
}

TEST_CASE("the jobs that ship are in order", "[unit][job]") {
  for (const char* name : {"aircraft", "quick-dome"}) {
    const Job job = read_job(tests::fixtures().string() + "/jobs/" + name + ".toml");
    CHECK(job.name == name);
    // They show every figure; only the finish floors are chosen, from the surface.
    CHECK(job.defaulted.empty());
  }
}

TEST_CASE("published figures of a job are read as they stand", "[unit][job]") {
  const std::string text = good_job() + R"(
[published]
source = "a paper, Table 1"
patches = 29
depth = [7, 10]
seconds = 71.5
[[published.stage]]
name = "finish"
planes = 872
memory_mb = 21.8
)";
  const Job job = read(text);
  REQUIRE(job.published);
  CHECK(job.published->source == "a paper, Table 1");
  CHECK(job.published->patches == 29);
  CHECK(job.published->depth == std::pair(7, 10));
  CHECK_FALSE(job.published->sampling_interval);
  CHECK(job.published->seconds == 71.5);
  REQUIRE(job.published->stages.size() == 1);
  CHECK(job.published->stages[0].planes == 872);
  CHECK_FALSE(job.published->stages[0].seconds);
  CHECK(job.published->stages[0].memory_mb == 21.8);
  CHECK_THAT(error_of(good_job() + "[published]\nsource = \"x\"\ndepth = [9, 7]\n"),
             ContainsSubstring("is no pair of ascending whole numbers"));
  CHECK_THAT(error_of(good_job() + "[published]\nsource = \"x\"\npatches = 2.5\n"),
             ContainsSubstring("is no whole number"));
}

}  // namespace
}  // namespace limitgauge::app
