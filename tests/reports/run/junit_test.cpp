#include <pugixml.hpp>
#include <sstream>

#include "reports/run/report.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

std::string text_of(const RunResult& result) {
  std::ostringstream out;
  write_junit(result, out);
  return out.str();
}

pugi::xml_document parsed(const RunResult& result) {
  pugi::xml_document document;
  const std::string text = text_of(result);
  REQUIRE(document.load_string(text.c_str()));
  return document;
}

/// The totals as attributes say them, and as a count of the elements gives them.
void require_counts(const pugi::xml_node& node, int tests, int failures, int errors, int skipped) {
  CHECK(node.attribute("tests").as_int() == tests);
  CHECK(node.attribute("failures").as_int() == failures);
  CHECK(node.attribute("errors").as_int() == errors);
  CHECK(node.attribute("skipped").as_int() == skipped);
  CHECK(node.select_nodes(".//testcase").size() == std::size_t(tests));
  CHECK(node.select_nodes(".//failure").size() == std::size_t(failures));
  CHECK(node.select_nodes(".//error").size() == std::size_t(errors));
  CHECK(node.select_nodes(".//skipped").size() == std::size_t(skipped));
}

}  // namespace

TEST_CASE("a passed job has a case for each stage and figure", "[unit][junit]") {
  const pugi::xml_document document = parsed(sample_result(Outcome::passed));
  require_counts(document.child("testsuites"), 21, 0, 0, 3);
  CHECK(document.select_nodes("/testsuites/testsuite").size() == 3);
  CHECK(document.select_node("//testsuite[@name='finish']/testcase[@name='coverage']"));
}

TEST_CASE("a failed stage has failures, the stage after it is skipped", "[unit][junit]") {
  const pugi::xml_document document = parsed(sample_result(Outcome::failed));
  require_counts(document.child("testsuites"), 21, 4, 0, 9);
  const auto failure =
      document.select_node("//testsuite[@name='semi-finish']/testcase[@name='gouge']/failure");
  REQUIRE(failure);
  CHECK_THAT(failure.node().attribute("message").value(), ContainsSubstring("limit 50 µm"));
  CHECK_THAT(failure.node().attribute("message").value(), ContainsSubstring("patch "));
  require_counts(document.select_node("//testsuite[@name='finish']").node(), 7, 0, 0, 7);
}

TEST_CASE("an undecided figure is an error", "[unit][junit]") {
  const pugi::xml_document document = parsed(sample_result(Outcome::indeterminate));
  require_counts(document.child("testsuites"), 21, 0, 1, 3);
  CHECK(document.select_node("//testsuite[@name='finish']/testcase[@name='uncut']/error"));
}

TEST_CASE("a figure without a limit is skipped", "[unit][junit]") {
  RunResult result = sample_result(Outcome::passed);
  result.stages[0].limits.has_uncut = false;
  const pugi::xml_document document = parsed(result);
  require_counts(document.child("testsuites"), 21, 0, 0, 4);
  CHECK_THAT(document.select_node("//skipped").node().attribute("message").value(),
             ContainsSubstring("no limit stated"));
}

TEST_CASE("what is out of reach has a case of its own, gated or not", "[unit][junit]") {
  RunResult result = sample_result(Outcome::passed);
  StageResult& stage = result.stages[2];
  stage.ran->deviation->surface_area_mm2 = 300;
  stage.ran->deviation->proven_reach = {287.2, 12.3, 0.5};
  const auto message = [&](const std::string& outcome, const std::string& figure) {
    const pugi::xml_document document = parsed(result);
    const std::string path =
        "//testsuite[@name='finish']/testcase[@name='" + figure + "']/" + outcome;
    return std::string(document.select_node(path.c_str()).node().attribute("message").value());
  };
  CHECK_THAT(message("skipped", "unreachable"), ContainsSubstring("12.3 to 12.8 mm² (4.10 to"));
  CHECK_THAT(message("skipped", "unavoidable uncut"), ContainsSubstring("0.31"));
  stage.ran->deviation->proven_reach = {300, 0, 5.8e-21};  // what rounding left undecided
  CHECK_THAT(message("skipped", "unreachable"), ContainsSubstring("0 mm² (0 %)"));
  stage.ran->deviation->proven_reach = {287.2, 12.3, 0.5};
  stage.limits.has_unreachable = true, stage.limits.unreachable = 0.04;
  CHECK_THAT(message("failure", "unreachable"), ContainsSubstring(", limit 4 %"));
  stage.limits.unreachable = 0.042;
  CHECK_THAT(message("error", "unreachable"), ContainsSubstring(", limit 4.2 %"));
  stage.limits.unreachable_is_share = false, stage.limits.unreachable = 12.8;
  CHECK(message("failure", "unreachable").empty());
  CHECK(message("error", "unreachable").empty());
  stage.limits.has_unreachable = false;
  stage.ran->deviation->proven_reach = {0, 300, 0};
  stage.ran->deviation->reachable_area_mm2 = 0;
  CHECK_THAT(message("failure", "unreachable"), ContainsSubstring("300 mm² (100 %)"));
  stage.ran->deviation->missing_stock_mm = {0.5, 0.51};
  stage.ran->deviation->missing_stock = {stage.ran->deviation->uncuts.front()};
  CHECK_THAT(message("failure", "missing stock"), ContainsSubstring("; worst M1 "));
}

TEST_CASE("failures of the process name the worst move", "[unit][junit]") {
  const pugi::xml_document document = parsed(sample_result(Outcome::failed));
  const auto message = [&](const std::string& figure) {
    return std::string(document.select_node(("//testcase[@name='" + figure + "']/failure").c_str())
                           .node()
                           .attribute("message")
                           .value());
  };
  CHECK_THAT(message("rapid collisions"),
             ContainsSubstring("840 µm") || ContainsSubstring("0.840 mm"));
  CHECK_THAT(message("rapid collisions"),
             ContainsSubstring("line 423 of semi-finish/toolpath.ngc"));
  CHECK_THAT(message("holder collisions"), ContainsSubstring("line 1513"));
  CHECK_THAT(message("process faults"), ContainsSubstring("line 1612"));
}

TEST_CASE("a suite says what was asked for, and times that add up", "[unit][junit]") {
  const pugi::xml_document document = parsed(sample_result(Outcome::passed));
  const pugi::xml_node suite = document.select_node("//testsuite[@name='finish']").node();
  const auto property = [&](const char* name) {
    return std::string(suite.child("properties")
                           .find_child_by_attribute("property", "name", name)
                           .attribute("value")
                           .value());
  };
  CHECK(property("tool") == "ball3");
  CHECK(property("strategy") == "zigzag");
  CHECK(property("program") == "finish/toolpath.ngc");
  CHECK(property("verdict") == "pass");
  double seconds = 0;
  for (const pugi::xml_node test : suite.children("testcase"))
    seconds += test.attribute("time").as_double();
  CHECK(seconds == Approx(11.4 + 6.2));
  CHECK(seconds <= suite.attribute("time").as_double());
}

TEST_CASE("a verdict that no figure explains is kept", "[unit][junit]") {
  RunResult result = sample_result(Outcome::passed);
  result.stages[0].decision = {verifier::Verdict::fail, {"for a reason of its own"}};
  const pugi::xml_document document = parsed(result);
  require_counts(document.child("testsuites"), 22, 1, 0, 3);
  CHECK(document.select_node("//testcase[@name='verdict']/failure"));
}

TEST_CASE("hostile names leave the file well-formed", "[unit][junit]") {
  RunResult result = sample_result(Outcome::failed);
  const std::string hostile = "]]>&<a b=\"'\">\x01\x1F\xFE\xC3(";
  result.job = result.stages[0].name = result.stages[1].name = hostile;
  result.stages[1].decision.reasons = {hostile};
  const pugi::xml_document document = parsed(result);
  CHECK(document.child("testsuites").attribute("name").as_string() ==
        std::string("]]>&<a b=\"'\">\uFFFD\uFFFD\uFFFD\uFFFD("));
  for (const char c : text_of(result)) CHECK((static_cast<unsigned char>(c) >= 0x20 || c == '\n'));
}
