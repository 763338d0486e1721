#include "app/study/study_file.h"

#include <set>

#include "model/base/text_file.h"
#include "study/plan/design.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "tests/support/messages.h"

namespace limitgauge::app {
namespace {

using study::Method;
using study::Plan;

const std::string kHead = "name = \"tune\"\njob = \"jobs/quick-dome.toml\"\n";
const std::string kVary = "[[vary]]\nkey = \"stage.finish.step\"\n";

Plan plan_of(const std::string& text, std::vector<std::string> overrides = {}) {
  StudyFile file = read_study_text(text, "study.toml", tests::fixtures());
  relate_to_job(file, model::read_text_file(file.plan.job), overrides);
  return file.plan;
}

/// What a text is refused with.
std::string refusal(const std::string& text) {
  return tests::message_of<model::InputError>([&] { plan_of(text); });
}

std::vector<std::string> texts(const std::vector<study::Setting>& settings) {
  std::vector<std::string> all;
  for (const study::Setting& setting : settings) all.push_back(setting.toml);
  return all;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("the fixture of a study is read, with the job's own settings", "[unit][study]") {
  const Plan plan = read_study(tests::fixtures().string() + "/studies/quick-dome.toml");
  CHECK(plan.name == "quick-dome-study");
  CHECK(model::is_file(plan.job));
  CHECK(plan.method == Method::grid);
  REQUIRE(plan.variables.size() == 2);
  CHECK(plan.variables[0].key == "stage.finish.step");
  CHECK(texts(plan.variables[0].values) == Texts{"0.3", "0.6", "0.9", "1.2"});
  CHECK(plan.variables[0].base == study::Setting{"0.3", 0.3});
  CHECK(plan.variables[1].base == study::Setting{"0.01", 0.01});
  CHECK(plan.cost == "machining_time_s");
  CHECK(plan.accuracy == Texts{"finish.uncut_mm.high", "finish.gouge_mm.high"});
  CHECK(design(plan).size() == 8);
}

TEST_CASE("any kind of setting is varied, in one way of writing each", "[unit][study]") {
  const Plan plan = plan_of(kHead + R"(
[[vary]]
key = "stage.finish.angle"
values = [90, 0.50, 1e1, -0.0]
[[vary]]
key = "stage.finish.pattern"
values = ["zigzag", 'one_way']
[[vary]]
key = "stage.finish.boundary_pass"
values = [true, false]
[[vary]]
key = "surface.transform.translate"
values = [[0, 0.10, 0], [1, 2, 3]]
[[vary]]
key = "stage.finish.gate"
values = [{ uncut = 0.1, gouge = 0.20 }]
[[vary]]
key = "tool.ball3.shank"
values = ["a\"b\\c\u0007"]
)");
  CHECK(texts(plan.variables[0].values) == Texts{"90", "0.5", "10", "0"});
  CHECK(plan.variables[0].values[1].number == 0.5);
  CHECK(texts(plan.variables[1].values) == Texts{"\"zigzag\"", "\"one_way\""});
  CHECK_FALSE(plan.variables[1].values[0].number);
  CHECK(texts(plan.variables[2].values) == Texts{"true", "false"});
  CHECK(texts(plan.variables[3].values) == Texts{"[0, 0.1, 0]", "[1, 2, 3]"});
  CHECK(texts(plan.variables[4].values) == Texts{"{ \"gouge\" = 0.2, \"uncut\" = 0.1 }"});
  CHECK(texts(plan.variables[5].values) == Texts{"\"a\\\"b\\\\c\\u0007\""});
  CHECK(plan.variables[1].base == study::Setting{"\"zigzag\"", {}});
  CHECK(plan.variables[2].base == study::Setting{"false", {}});
  CHECK_FALSE(plan.variables[3].base);
}

TEST_CASE("what a setting is written as, the job reads as it was meant", "[unit][study]") {
  const Plan plan = plan_of(kHead +
                            "[[vary]]\nkey = \"stage.finish.feed\"\nvalues = [1234.5]\n"
                            "[[vary]]\nkey = \"surface.transform\"\nvalues = "
                            "[{ scale = 1.5, translate = [1, 2.25, 3] }]\n");
  std::vector<std::string> overrides;
  for (const study::Variable& variable : plan.variables)
    overrides.push_back(variable.key + "=" + variable.values[0].toml);
  const Job job = read_job(plan.job, overrides);
  CHECK(job.stages[1].plan->cut.feed_mm_min == 1234.5);
  CHECK(job.design->placement.scale == 1.5);
  CHECK(job.design->placement.translate_mm[1] == 2.25);
}

TEST_CASE("each method reads its keys", "[unit][study]") {
  const Plan drawn = plan_of(kHead + "method = \"latin_hypercube\"\nsamples = 40\nseed = 3\n" +
                             kVary + "range = [0.1, 1]\nscale = \"log\"\n");
  CHECK(drawn.method == Method::latin_hypercube);
  CHECK(drawn.samples == 40);
  CHECK(drawn.seed == 3);
  CHECK(drawn.variables[0].range->logarithmic);
  CHECK(drawn.variables[0].range->steps == 0);

  const Plan around = plan_of(kHead + "method = \"one_at_a_time\"\n" + kVary +
                              "range = [0.1, 0.5]\nsteps = 5\nbase = 0.2\n");
  CHECK(around.variables[0].base->number == 0.2);
  CHECK(case_count(around) == 5);

  const Plan search = plan_of(kHead + "method = \"search\"\n" + kVary +
                              "range = [0.1, 1]\n[objectives]\ncost = "
                              "\"finish.machining_time_s\"\n[search]\nmost_cases = 30\n"
                              "accuracy = 0.02\nbatch = 2\n");
  CHECK(search.search.cost == "finish.machining_time_s");
  CHECK(search.search.most_cases == 30);
  CHECK(search.search.accuracy == 0.02);
  CHECK(search.search.batch == 2);
  CHECK(plan_of(kHead + kVary + "values = [1]\n").search.batch == study::Search().batch);
}

TEST_CASE("a list of cases, with keys in one piece or dotted", "[unit][study]") {
  const Plan plan = plan_of(kHead + R"(method = "list"
[[case]]
stage.finish.step = 0.2
"stage.finish.angle" = 0
[[case]]
"stage.finish.angle" = 45
"stage.finish.step" = 0.2
)");
  REQUIRE(plan.variables.size() == 2);
  CHECK(plan.variables[0].key == "stage.finish.step");
  CHECK(plan.variables[1].key == "stage.finish.angle");
  CHECK(texts(plan.variables[0].values) == Texts{"0.2"});
  REQUIRE(plan.listed.size() == 2);
  CHECK(texts(plan.listed[1]) == Texts{"0.2", "45"});
  CHECK(plan.variables[1].base->number == 90);
}

TEST_CASE("overrides change the job that a study starts from", "[unit][study]") {
  const Plan plan = plan_of(kHead + kVary + "values = [0.1]\n", {"stage.finish.step=0.25"});
  CHECK(plan.variables[0].base->number == 0.25);
}

TEST_CASE("study files that are refused say where and why", "[unit][study]") {
  const auto vary = [](const std::string& rest) { return kHead + kVary + rest + "\n"; };
  const std::pair<std::string, std::string> cases[] = {
      {"name = \"a b\"", "study.toml:1:8: error: \"a b\" cannot name a folder"},
      {"name = \"a\"", "missing key \"job\" in the study"},
      {"name = \"a\"\njob = \"none.toml\"", "study.toml:2:7: error: no file \"none.toml\""},
      {kHead, "missing key \"vary\""},
      {kHead + "metod = \"grid\"", "unknown key \"metod\" in the study; expected \"method\""},
      {kHead + "method = \"gird\"", "\"method\" in the study is \"gird\"; expected one of"},
      {kHead + "vary = []", "\"vary\" in the study is of type array"},
      {vary("value = [1]"),
       "study.toml:5:1: error: unknown key \"value\" in [[vary]]; expected \"values\""},
      {vary("values = []"), "study.toml:5:10: error: \"values\" in [[vary]] is no list"},
      {vary("values = 3"), "is no list with anything in it"},
      {vary("values = [0.1, nan]"),
       "study.toml:5:16: error: \"values\" in [[vary]] has a number that is not finite"},
      {vary("values = [0.1, 2, 0.10]"), "study.toml:5:19: error: the setting 0.1 a second time"},
      {vary("values = [2026-01-01]"), "has a date or time"},
      {vary(""), "[[vary]] has neither values nor range"},
      {vary("values = [1]\nrange = [0, 1]"), "[[vary]] has both values and range"},
      {vary("values = [1]\nsteps = 3"), "\"steps\" beside \"values\" changes nothing"},
      {vary("range = [1, 1]\nsteps = 3"),
       "study.toml:5:9: error: \"range\" in [[vary]] is no pair of ascending numbers"},
      {vary("range = [2, 1]\nsteps = 3"), "is no pair of ascending numbers"},
      {vary("range = [0.0625, -1.5]\nsteps = 3"),
       "is no pair of ascending numbers: [ 0.0625, -1.5 ]"},
      {vary("range = [1, nan]\nsteps = 3"), "is no pair of ascending numbers"},
      {vary("range = [1, 2]\nsteps = 1"), "study.toml:6:9: error: \"steps\" in [[vary]] is 1"},
      {vary("range = [1, 2]\nsteps = 2.5"), "is no whole number"},
      {vary("range = [1, 2]"), "a range without \"steps\""},
      {vary("range = [0, 2]\nsteps = 3\nscale = \"log\""), "a range on a log scale from 0"},
      {vary("range = [1, 2]\nsteps = 3\nscale = \"ln\""), "one of \"linear\", \"log\""},
      {vary("range = [1e9, 1000000001]\nsteps = 3"), "too wide or too narrow"},
      {vary("range = [-1e308, 1e308]\nsteps = 3"), "too wide or too narrow"},
      {vary("values = [1]\n" + kVary + "values = [2]"),
       "study.toml:7:7: error: the key \"stage.finish.step\" a second time"},
      {vary("values = [1]\n[[vary]]\nkey = \"stage.finish\"\nvalues = [2]"),
       "\"stage.finish\" beside \"stage.finish.step\""},
      {kHead + "[[vary]]\nkey = \"stage..step\"\nvalues = [1]",
       "study.toml:4:7: error: no key of a job: 'stage..step'"},
      {kHead + "[[vary]]\nkey = \"a=b\"\nvalues = [1]", "no key of a job: 'a=b'"},
      {kHead + "[[vary]]\nkey = \"stage.finish.stpe\"\nvalues = [1]",
       "study.toml:4:7: error: \"stage.finish.stpe\": unknown key \"stpe\" in [[stage]]; expected "
       "\"step\""},
      {kHead + "[[vary]]\nkey = \"stage.finsh.step\"\nvalues = [1]",
       "no stage is called \"finsh\""},
      {kHead + "[[vary]]\nkey = \"simulaton.voxel\"\nvalues = [1]",
       "unknown key \"simulaton\" in the job; expected \"simulation\""},
      {kHead + "samples = 3\n" + kVary + "values = [1]",
       "\"samples\" beside the method \"grid\" would change nothing"},
      {kHead + "method = \"random\"\n" + kVary + "values = [1]", "missing key \"samples\""},
      {kHead + "method = \"random\"\nsamples = 0\n" + kVary + "values = [1]",
       "study.toml:4:11: error: \"samples\" is 0"},
      {kHead + "method = \"random\"\nsamples = 3\n" + kVary + "values = [1, 2]",
       "\"samples\" is 3 of 2 combinations"},
      {kHead + "method = \"random\"\nsamples = 100001\n" + kVary + "range = [1, 2]",
       "the study has 100001 cases; expected 100000 at most"},
      {vary("range = [1, 2]\nsteps = 100000\n[[vary]]\nkey = \"stage.finish.tolerance\"\nvalues = "
            "[1, 2]"),
       "the study has 200000 cases"},
      {kHead + "method = \"one_at_a_time\"\n[[vary]]\nkey = \"stage.finish.scallop\"\nvalues = [1]",
       "study.toml:5:7: error: the job does not state \"stage.finish.scallop\""},
      {kHead + "method = \"list\"\n" + kVary + "values = [1]",
       "\"vary\" beside the method \"list\""},
      {kHead + "method = \"list\"\n[[case]]\na.b = 1\n[[case]]\n", "a [[case]] without \"a.b\""},
      {kHead + "method = \"list\"\n[[case]]\na.b = 1\n[[case]]\na.b = 2\nc = 3\n",
       "study.toml:8:1: error: \"c\", which the first [[case]] does not have"},
      {kHead + "method = \"list\"\n[[case]]\nstage.finish.step = 1\n[[case]]\nstage.finish.step = "
               "1.0\n",
       "a [[case]] that is there already"},
      {kHead + "method = \"list\"\n[[case]]\n", "a [[case]] with 0 keys"},
      {vary("values = [1]\n[objectives]\ncost = \"machining_time\""),
       "study.toml:7:8: error: no figure \"machining_time\" that is to be small; expected "
       "\"machining_time_s\""},
      {vary("values = [1]\n[objectives]\naccuracy = [\"finish.uncut_mm\"]"),
       "expected \"finish.uncut_mm.low\""},
      {vary("values = [1]\n[objectives]\naccuracy = [\"finish.coverage\"]"),
       "no figure \"finish.coverage\" that is to be small"},
      {vary("values = [1]\n[objectives]\naccuracy = []"), "\"accuracy\" is no list"},
      {vary("values = [1]\n[objectives]\naccuracy = [\"machining_time_s\"]"),
       "\"machining_time_s\" is the cost"},
      {vary("values = [1]\n[search]\nmost_cases = 3"), "\"search\" beside the method \"grid\""},
      {kHead + "method = \"search\"\n" + kVary + "range = [1, 2]\n[search]\nmost_cases = 1",
       "\"most_cases\" in [search] is 1"},
      {kHead + "method = \"search\"\n" + kVary + "range = [1, 2]\n[search]\naccuracy = 0",
       "\"accuracy\" in [search] is 0"},
      {kHead + "method = \"search\"\n" + kVary + "range = [1, 2]\n[search]\nbatch = 0",
       "\"batch\" in [search] is 0"},
  };
  for (const auto& [text, expected] : cases) {
    INFO(text);
    const std::string got = refusal(text);
    CAPTURE(got, expected);
    CHECK(got.find(expected) != std::string::npos);
    CHECK(got.starts_with("study.toml:"));
  }
}

TEST_CASE("a setting that the job refuses is a case's affair", "[unit][study]") {
  CHECK(plan_of(kHead + kVary + "values = [-1, 0.2]\n").variables[0].values.size() == 2);
  CHECK(plan_of(kHead + "[[vary]]\nkey = \"stage.finish.strategy\"\nvalues = [\"contour\"]\n")
            .variables.size() == 1);
}

TEST_CASE("a study may ask for the largest setting, and weigh a margin", "[unit][study]") {
  const std::string search = kHead + "method = \"search\"\n[[vary]]\nkey = \"tolerances.runout\"\n";
  const std::string asked = "[search]\nlargest = \"tolerances.runout\"\n";
  const Plan plan = plan_of(search + "range = [0.001, 0.05]\n" + asked);
  CHECK(plan.search.largest == "tolerances.runout");
  CHECK(plan.search.cost == study::kSearchedSetting);
  CHECK(plan.cost == study::kSearchedSetting);
  for (const auto& [text, wrong] : std::vector<std::pair<std::string, std::string>>{
           {search + "range = [0.001, 0.05]\n[search]\nlargest = \"tolerances.path\"",
            "\"tolerances.path\" is not the one key that is varied"},
           {search + "range = [0.001, 0.05]\n" + kVary + "range = [0.1, 1]\n" + asked,
            "is not the one key that is varied"},
           {search + "values = [0.001, \"wide\"]\n" + asked, "are no numbers"},
           {search + "range = [0.001, 0.05]\n" + asked + "cost = \"machining_time_s\"",
            "a cost is stated beside \"largest\""},
           {search + "range = [0.001, 0.05]\n" + asked + "[objectives]\ncost = \"gate_excess\"",
            "a cost is stated beside \"largest\""}}) {
    CAPTURE(text);
    CHECK_THAT(refusal(text), ContainsSubstring(wrong));
  }
  const std::string margin =
      kHead + kVary + "values = [0.3]\n[objectives]\naccuracy = [\"finish.margin.low\"]\n";
  CHECK_THAT(refusal(margin), ContainsSubstring("no figure \"finish.margin.low\""));
  CHECK(plan_of(margin, {"tolerances={runout=0.01}"}).accuracy == Texts{"finish.margin.low"});
}

}  // namespace limitgauge::app
