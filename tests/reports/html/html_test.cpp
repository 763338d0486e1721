#include <memory>
#include <set>
#include <sstream>

#include "reports/html/markup.h"
#include "reports/text/text.h"
#include "tests/reports/page/page_support.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

/// The texts of the cells of a row.
std::vector<std::string> cells_of(const pugi::xml_node& row) {
  std::vector<std::string> out;
  for (const pugi::xml_node cell : row.children("td")) out.push_back(text_of(cell));
  return out;
}

/// The body's rows of the table below `root`.
std::vector<pugi::xml_node> rows_of(const pugi::xml_node& root) {
  std::vector<pugi::xml_node> out;
  for_each_element(root, [&](const pugi::xml_node& node) {
    if (std::string(node.name()) == "tr" && node.child("td")) out.push_back(node);
  });
  return out;
}

}  // namespace

TEST_CASE("the page states the verdict first, then the stages", "[unit][html]") {
  const std::string page = page_of(sample_result(Outcome::failed));
  const auto verdict = page.find("<span aria-hidden=\"true\">✕</span> Failed"),
             reason = page.find("gouged beyond the limit"), stages = page.find("<h2>Stages</h2>");
  CHECK(verdict < reason);
  CHECK(reason < stages);
  CHECK(contains(page, "Not run"));
  CHECK(contains(page_of(sample_result(Outcome::passed)), "Every gate figure is proven"));
  CHECK(contains(page_of(sample_result(Outcome::indeterminate)), "Undecided"));
}

TEST_CASE("the header speaks of what is out of reach and of missing stock, whatever the verdict",
          "[unit][html]") {
  for (const Outcome outcome : {Outcome::passed, Outcome::failed}) {
    RunResult result = sample_result(outcome);
    verifier::StageDeviation& d = *result.stages[0].ran->deviation;
    d.surface_area_mm2 = 300;
    d.proven_reach = {287.2, 12.3, 0.5};
    d.unavoidable_uncut_mm = {0.1, 0.25};
    d.missing_stock_mm = {0.5, 0.51};
    d.missing_stock = {d.uncuts.front()};
    result.stages[0].decision.reasons.emplace_back("unreachable: said again");
    ParsedPage page;
    parse_page(page_of(result), page);
    const std::string text = text_of(page.tree.find_node(
        [](const pugi::xml_node& n) { return std::string(n.name()) == "header"; }));
    INFO(text);
    CHECK(contains(text,
                   "unreachable 12.3 to 12.8 mm² (4.10 to 4.27 %); unavoidable uncut [0.10, 0.25] "
                   "mm; missing stock [0.500, 0.510] mm, limit ≤ 0.05 mm: beyond"));
    CHECK_FALSE(contains(text, "said again"));
    const pugi::xml_node row = element_with(page.tree, "id", "stage-1-M1");
    CHECK(std::string(row.name()) == "tr");
    // The map knows gouges and leftovers only.
    CHECK_FALSE(row.attribute("data-finding"));
  }
}

TEST_CASE("headings are in order, ids are unique, links within the page lead somewhere",
          "[unit][html]") {
  for (const Outcome outcome : {Outcome::passed, Outcome::failed, Outcome::indeterminate}) {
    RunResult result = sample_result(outcome);
    // The sample's process findings name lines far beyond its own program.
    for (StageResult& stage : result.stages)
      if (stage.ran) stage.ran->program_text = std::make_shared<const std::string>(2000, '\n');
    ParsedPage page;
    parse_page(page_of(result), page);
    std::set<std::string> ids;
    std::vector<std::string> links;
    int level = 0;
    for_each_element(page.tree, [&](const pugi::xml_node& node) {
      const std::string name = node.name(), id = node.attribute("id").value();
      if (!id.empty()) CHECK(ids.insert(id).second);
      if (name == "a") links.emplace_back(node.attribute("href").value());
      if (name == "table") CHECK(std::string(node.first_child().name()) == "caption");
      if (name.size() != 2 || name[0] != 'h' || name[1] < '1' || name[1] > '6') return;
      CHECK(name[1] - '0' <= level + 1);
      level = name[1] - '0';
    });
    for (const std::string& link : links) {
      INFO(link);
      CHECK(ids.contains(link.substr(1)));
    }
  }
}

TEST_CASE("the script finds its places in the page", "[unit][html]") {
  ParsedPage page;
  parse_page(page_of(sample_result(Outcome::failed)), page);
  CHECK(page.tree.find_node([](const pugi::xml_node& n) { return n.attribute("data-view"); }));
  for (const char* stage : {"0", "1"}) {
    const pugi::xml_node section =
        element_with(page.tree, "id", "stage-" + std::to_string(std::stoi(stage) + 1));
    CHECK(section.attribute("data-stage").as_string() == std::string(stage));
    for (const char* css : {"histogram"})
      CHECK(element_with(section, "class", css).attribute("data-stage").as_string() ==
            std::string(stage));
    CHECK(element_with(section, "data-chart", "process").attribute("data-stage").as_string() ==
          std::string(stage));
  }
  for (const char* finding : {"1:G1", "1:U1", "1:P1"})
    CHECK(
        std::string(element_with(element_with(page.tree, "id", "stage-2"), "data-finding", finding)
                        .name()) == "tr");
}

TEST_CASE("the header of a failed job names the worst gouge, its depth, place and program line",
          "[unit][html]") {
  const RunResult result = sample_result(Outcome::failed);
  const verifier::Finding& f = result.stages[1].ran->deviation->gouges.front();
  ParsedPage page;
  parse_page(page_of(result), page);
  const pugi::xml_node header = page.tree.find_node(
      [](const pugi::xml_node& n) { return std::string(n.name()) == "header"; });
  const std::string text = text_of(header);
  CHECK(contains(text, "Worst gouge " + measured_length(f.depth_mm)));
  CHECK(contains(text, "X " + html::typeset(fixed(f.place.point.x, 3)) + ", Y " +
                           html::typeset(fixed(f.place.point.y, 3)) + ", Z " +
                           html::typeset(fixed(f.place.point.z, 3)) + " mm"));
  CHECK(contains(text, "line " + std::to_string(f.line) + " of semi-finish/toolpath.ngc"));
  // What stands on that line of the program.
  std::istringstream program(*result.stages[f.stage].ran->program_text);
  std::string line;
  for (std::uint32_t i = 0; i < f.line; ++i) std::getline(program, line);
  REQUIRE(line.starts_with("G1 X"));
  CHECK(contains(text, line));
  const pugi::xml_node link = element_with(header, "data-finding", "1:G1");
  CHECK(link.attribute("href").as_string() == std::string("#stage-2-G1"));
  // The deepest fault of the process.
  CHECK(contains(text, "≥ 1.38 mm"));
  CHECK(contains(text, "holder against stock"));
  CHECK(contains(text, "line 1513 of semi-finish/toolpath.ngc"));
}

TEST_CASE("the header of an undecided job names what is not decided", "[unit][html]") {
  RunResult result = sample_result(Outcome::indeterminate);
  verifier::StageDeviation& d = *result.stages[2].ran->deviation;
  const auto header_text = [&] {
    ParsedPage page;
    parse_page(page_of(result), page);
    return text_of(page.tree.find_node(
        [](const pugi::xml_node& n) { return std::string(n.name()) == "header"; }));
  };
  CHECK(contains(header_text(), "Most material left " + measured_length(d.uncuts[0].depth_mm)));
  CHECK(contains(header_text(), "limit 10 µm: undecided"));
  // Where nothing is proven to exceed a limit, no place may be listed: then a sample is named.
  d.uncuts.clear();
  CHECK(contains(header_text(),
                 "Most material left, of the samples " + measured_length(d.uncut_mm.low)));
  // A job that passed has nothing to name.
  result = sample_result(Outcome::passed);
  CHECK_FALSE(contains(header_text(), "Most material left"));
}

TEST_CASE("each patch has its row, the worst first", "[unit][html]") {
  RunResult result = sample_result(Outcome::failed, 9);
  result.surface->depths.assign(30, 5);
  result.surface->depths[20] = 7;
  result.stages[1].ran->sampling_intervals.assign(30, 4);
  ParsedPage page;
  parse_page(page_of(result), page);
  const pugi::xml_node patches =
      element_with(element_with(page.tree, "id", "stage-2"), "class", "patches");
  CHECK_FALSE(patches.attribute("open"));
  const std::vector<pugi::xml_node> rows = rows_of(patches);
  REQUIRE(rows.size() == 30);
  // The dent of the sample lies on patch 20, of 80 mm x 65 mm / 30, all of it in reach.
  const std::vector<std::string> worst = cells_of(rows[0]);
  CHECK(std::string(rows[0].attribute("data-patch").value()) == "20");
  CHECK(worst[0] == "20");
  CHECK(worst[1] == "7");
  CHECK(worst[2] == "4");
  CHECK(worst[3] + " µm" == measured_length(result.stages[1].ran->deviation->gouge_mm.low));
  CHECK(worst[5] == "173");
  CHECK(worst[6] == "0.00");
  CHECK(worst[7] == "81");
}

TEST_CASE("many patches are folded away", "[unit][html]") {
  RunResult result = sample_result(Outcome::passed, 3);
  verifier::DeviationField& field = result.stages[0].ran->deviation->field;
  const std::vector<verifier::DeviationField::Sample> samples = field.samples;
  for (const int more : {30, 500}) {
    for (verifier::DeviationField::Sample s : samples)
      s.place.patch += more, field.samples.push_back(s);
    ParsedPage page;
    parse_page(page_of(result), page);
    const pugi::xml_node patches =
        element_with(element_with(page.tree, "id", "stage-1"), "class", "patches");
    CHECK_FALSE(patches.attribute("open"));
    CHECK(rows_of(patches).size() == (more == 30 ? 60U : 90U));
  }
}

TEST_CASE("tools stand in all their measures, each once", "[unit][html]") {
  RunResult result = sample_result(Outcome::passed);
  result.stages[0].cutter.shank = {{8, 30}};
  result.stages[0].cutter.holder = {{40, 20}, {50, 30.5}};
  ParsedPage page;
  parse_page(page_of(result), page);
  const std::vector<pugi::xml_node> rows = rows_of(element_with(page.tree, "id", "tools"));
  REQUIRE(rows.size() == 2);  // ball3 is used in two stages
  CHECK(cells_of(rows[0]) == std::vector<std::string>{"flat8", "flat", "8", "–", "–", "–", "25",
                                                      "⌀8 × 30", "⌀40 × 20, ⌀50 × 30.5", "90",
                                                      "rough"});
  CHECK(cells_of(rows[1])[3] == "3");
  CHECK(cells_of(rows[1])[10] == "semi-finish, finish");
}

TEST_CASE("the page lists the files that were read with their checksums", "[unit][html]") {
  RunResult result = sample_result(Outcome::passed);
  result.inputs = {{"cage", "cages/a b.obj", 12345, std::string(64, 'a')}};
  ParsedPage page;
  parse_page(page_of(result), page);
  const pugi::xml_node inputs = element_with(page.tree, "id", "inputs");
  const std::vector<pugi::xml_node> rows = rows_of(inputs);
  CHECK(cells_of(rows.back()) ==
        std::vector<std::string>{"cage", "cages/a b.obj", "12\u202F345", std::string(64, 'a')});
}

TEST_CASE("a page without pictures has none, and the same result gives the same page",
          "[unit][html][slow]") {
  const RunResult result = sample_result(Outcome::passed, 5);
  CHECK_FALSE(contains(page_of(result), "<img"));
  const std::string page = page_of(result, true);
  CHECK(contains(page, "<img"));
  CHECK(page == page_of(sample_result(Outcome::passed, 5), true));
}

TEST_CASE("a ratio of limit to interval below 4 : 1 is marked", "[unit][html]") {
  // Its interval of 3.1 µm against 10 µm is 3.2 : 1.
  CHECK(contains(page_of(sample_result(Outcome::indeterminate)),
                 "3.23 : 1</span> <strong class=\"warn\">"));
  CHECK_FALSE(contains(page_of(sample_result(Outcome::passed)), "class=\"warn\""));
}

TEST_CASE("findings stand in the table with place, patch, parameters and line", "[unit][html]") {
  const RunResult result = sample_result(Outcome::failed);
  const verifier::Finding& f = result.stages[1].ran->deviation->gouges.front();
  ParsedPage page;
  parse_page(page_of(result), page);
  const std::vector<std::string> cells = cells_of(element_with(page.tree, "id", "stage-2-G1"));
  CHECK(cells[0] == "G1");
  CHECK(cells[1] + " µm" == measured_length(f.depth_mm));
  CHECK(cells[5] ==
        std::to_string(f.place.patch) + fixed(f.place.u, 4) + ", " + fixed(f.place.v, 4));
  CHECK(cells[6].starts_with(std::to_string(f.line) + "move "));
}

TEST_CASE("what passed and what is looked up is folded, what failed is open", "[unit][html]") {
  ParsedPage page;
  parse_page(page_of(sample_result(Outcome::failed)), page);
  const auto folded = [&](const char* id, const char* css) {
    const pugi::xml_node details = element_with(element_with(page.tree, "id", id), "class", css);
    CHECK(std::string(details.name()) == "details");
    return !details.attribute("open");
  };
  CHECK(folded("stage-1", "stage-body"));
  CHECK_FALSE(folded("stage-2", "stage-body"));
  for (const char* css : {"patches", "more", "budget"}) CHECK(folded("stage-2", css));
  CHECK(folded("inputs", "more"));
  // A stage that was not run has nothing to fold.
  CHECK_FALSE(contains(text_of(element_with(page.tree, "id", "stage-3")), "histogram"));
}

TEST_CASE("a failed card has the failing reasons alone", "[unit][html]") {
  RunResult result = sample_result(Outcome::failed);
  result.stages[1].ran->deviation->coverage = 0.98996;
  ParsedPage page;
  parse_page(page_of(result), page);
  const std::string text = text_of(element_with(page.tree, "class", "verdict fail"));
  INFO(text);
  CHECK(contains(text, "coverage 98.99 %, limit ≥ 99.00 %: beyond"));
  // Its uncut is within the limit, and the first stage passed.
  CHECK_FALSE(contains(text, "Most material left"));
  CHECK_FALSE(contains(text, "within"));
}

TEST_CASE("a column of the stages stands in one unit, and each figure once", "[unit][html]") {
  ParsedPage page;
  parse_page(page_of(sample_result(Outcome::passed)), page);
  const pugi::xml_node stages = element_with(page.tree, "id", "stages");
  const std::string text = text_of(stages);
  CHECK(contains(text, "Gouge, µm"));
  CHECK(contains(text, "Uncut, mm"));
  for (const pugi::xml_node& row : rows_of(stages))
    for (std::size_t i = 3; i < 6; ++i)
      for (const char* unit : {"mm", "µm", "%"}) CHECK_FALSE(contains(cells_of(row)[i], unit));
  // Of the words for a figure that is within its limit none is left.
  CHECK_FALSE(contains(page_of(sample_result(Outcome::passed)), "within the limit everywhere"));
}

TEST_CASE("numbers are set as numbers", "[unit][html]") {
  CHECK(html::typeset("-1.25") == "−1.25");
  CHECK(html::typeset("8.10e-08") == "8.10 × 10<sup>−8</sup>");
  CHECK(html::typeset("1.10e-05 µm") == "1.10 × 10<sup>−5</sup> µm");
  CHECK(html::png_uri("M") == "data:image/png;base64,TQ==");
  CHECK(html::png_uri("Man") == "data:image/png;base64,TWFu");
  CHECK(html::png_uri("Many") == "data:image/png;base64,TWFueQ==");
}

TEST_CASE("published figures stand beside the run's own", "[unit][html]") {
  RunResult result = sample_result(Outcome::passed);
  CHECK_FALSE(page_of(result).find("published") != std::string::npos);
  PublishedFigures published;
  published.source = "A <paper>, Tables 1 and 3";
  published.patches = 29;
  published.depth = {7, 10};
  published.memory_mb = 276.776;
  published.stages.push_back({result.stages[0].name, 90, 10.438, 1.657});
  result.published = published;
  const std::string page = page_of(result);
  for (const std::string shown :
       {"A &lt;paper&gt;, Tables 1 and 3", "7 to 10", "277", "1.66", "Memory, MB"})
    CHECK(contains(page, shown));
}
