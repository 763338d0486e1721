#include <pugixml.hpp>
#include <random>
#include <sstream>

#include "reports/compare/report.h"
#include "reports/compare/run_comparison.h"
#include "tests/reports/compare/compare_support.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports::compare;
using reports::record::RunRecord;

namespace {

pugi::xml_document junit_of(const Comparison& comparison) {
  std::ostringstream out;
  write_junit(comparison, out);
  pugi::xml_document document;
  REQUIRE(document.load_string(out.str().c_str()));
  return document;
}

pugi::xml_document junit_of(const RunRecord& base, const RunRecord& now, const Options& options) {
  return junit_of(compare_runs(base, now, options));
}

/// The case of that name of the stage "finish".
pugi::xml_node case_named(const pugi::xml_document& document, const std::string& name) {
  const std::string path =
      "//testcase[@classname='limitgauge.compare.finish'][@name='" + name + "']";
  return document.select_node(path.c_str()).node();
}

int count(const pugi::xml_document& document, const char* attribute) {
  return document.child("testsuites").attribute(attribute).as_int();
}

}  // namespace

TEST_CASE("junit of a comparison: a run with itself has cases, and none has failed",
          "[unit][compare][junit]") {
  const pugi::xml_document document = junit_of(sample_run(), sample_run(), {});
  CHECK(document.select_nodes("//testsuite").size() == 2);
  CHECK(count(document, "failures") + count(document, "errors") == 0);
  for (const char* name : {"verdict", "gouge", "uncut", "coverage", "findings"}) {
    INFO(name);
    CHECK(case_named(document, name).child("system-out"));
  }
  // Without a limit the time is not judged, and is no pass.
  CHECK(case_named(document, "machining time").child("skipped"));
  CHECK_FALSE(case_named(document, "mean"));
}

TEST_CASE("junit of a comparison: what got worse has failed, with its reason and its place",
          "[unit][compare][junit]") {
  RunRecord now = sample_run();
  now.stages[0].measures->deviation->gouge_mm = {0.012, 0.013};
  now.stages[0].measures->deviation->gouges.push_back(place_at(7, 0.012, 12));
  now.stages[0].verdict = now.verdict = verifier::Verdict::fail;
  now.stages[0].limits.uncut_mm = 0.02;
  const pugi::xml_document document = junit_of(sample_run(), now, {});
  const std::string gouge =
      case_named(document, "gouge").child("failure").attribute("message").value();
  CHECK_THAT(gouge, ContainsSubstring("now [12") && ContainsSubstring("worse: proved"));
  CHECK(case_named(document, "verdict").child("failure"));
  CHECK(case_named(document, "gate").child("failure"));
  CHECK_THAT(case_named(document, "findings").child("failure").text().get(),
             ContainsSubstring("new gouge 12") && ContainsSubstring("line 12"));
  CHECK(case_named(document, "coverage").child("system-out"));
  CHECK(
      document.select_node("//testcase[@classname='limitgauge.compare'][@name='verdict']/failure"));
}

TEST_CASE("junit of a comparison: what is not asked for is skipped", "[unit][compare][junit]") {
  RunRecord now = sample_run();
  now.stages[0].measures->deviation->gouge_mm = {0.012, 0.013};
  const Options options{{}, {}, {"gouge_mm"}};
  const pugi::xml_document document = junit_of(sample_run(), now, options);
  CHECK(count(document, "failures") == 0);
  CHECK_THAT(case_named(document, "gouge").child("skipped").attribute("message").value(),
             ContainsSubstring("not asked for"));
}

TEST_CASE("junit of a comparison: a stage that one run lacks", "[unit][compare][junit]") {
  RunRecord more = sample_run();
  more.stages.push_back(more.stages[0]);
  more.stages[1].name = "polish";
  const char* at = "//testcase[@classname='limitgauge.compare.polish'][@name='stage']";
  const pugi::xml_document gone = junit_of(more, sample_run(), {});
  CHECK(gone.select_node(at).node().child("failure"));
  const pugi::xml_document come = junit_of(sample_run(), more, {});
  CHECK(come.select_node(at).node().child("skipped"));
  CHECK(count(come, "failures") == 0);
}

TEST_CASE("junit of a comparison: a case has failed exactly where it is worse",
          "[property][compare][junit]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0, 1);
  const auto any = [&] {
    RunRecord run = sample_run();
    auto& m = *run.stages[0].measures->deviation;
    // Often the same, so that either way comes up.
    if (share(random) < 0.2) m.gouge_mm = {0.004 * share(random), 0.004};
    if (share(random) < 0.2) m.coverage = share(random);
    if (share(random) < 0.2) m.rms_mm = 0.001 * share(random);
    if (share(random) < 0.2) run.stages[0].limits.uncut_mm = 0.02 * share(random);
    if (share(random) < 0.2) m.uncuts.push_back(place_at(7, 0.02, 12));
    if (share(random) < 0.2) run.stages[0].verdict = verifier::Verdict::indeterminate;
    return run;
  };
  int worse = 0;
  for (int i = 0; i < 300; ++i) {
    const Comparison comparison = compare_runs(any(), any(), {});
    const bool is_worse = comparison.judgement() == Judgement::worse;
    worse += is_worse ? 1 : 0;
    CHECK((count(junit_of(comparison), "failures") > 0) == is_worse);
  }
  CHECK((worse > 50 && worse < 250));
}
