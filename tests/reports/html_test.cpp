#include <algorithm>
#include <regex>
#include <sstream>

#include "reports/html/charts.h"
#include "reports/html/markup.h"
#include "reports/report.h"
#include "reports/text.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

std::string page_of(const RunResult& result, bool pictures = false) {
  std::ostringstream out;
  RunResult shown = result;
  for (StageResult& stage : shown.stages) {
    stage.pictures.reset();
    if (pictures) stage.pictures = draw_pictures(stage);
  }
  write_html(shown, out);
  return out.str();
}

bool is_void(const std::string& name) {
  return name == "meta" || name == "img" || name == "br" || name == "!DOCTYPE";
}

/// The page's elements nest: every tag that opens closes, in order. By hand: std::regex recurses
/// once a character, and a picture's tag is long.
void require_nesting(const std::string& page) {
  std::vector<std::string> open;
  for (std::size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
    const std::size_t end = page.find('>', at);
    REQUIRE(end != std::string::npos);
    const bool closes = page[at + 1] == '/';
    const std::size_t from = at + (closes ? 2 : 1);
    const std::string name = page.substr(from, page.find_first_of(" />", from) - from);
    if (is_void(name) || page[end - 1] == '/') continue;
    if (!closes) {
      open.push_back(name);
      continue;
    }
    INFO("closing " << name << " at " << at);
    REQUIRE_FALSE(open.empty());
    REQUIRE(open.back() == name);
    open.pop_back();
  }
  CHECK(open.empty());
}

struct Rect {
  std::string css;
  double x = 0, y = 0, width = 0, height = 0;
};

std::vector<Rect> rects_of(const std::string& svg) {
  static const std::regex rect(
      R"re(<rect class="(\w+)" x="([-\d.]+)" y="([-\d.]+)" width="([-\d.]+)" height="([-\d.]+)"/>)re");
  std::vector<Rect> out;
  for (std::sregex_iterator it(svg.begin(), svg.end(), rect), end; it != end; ++it)
    out.push_back({(*it)[1], std::stod((*it)[2]), std::stod((*it)[3]), std::stod((*it)[4]),
                   std::stod((*it)[5])});
  return out;
}

double line_at(const std::string& svg, const std::string& css) {
  std::smatch match;
  REQUIRE(
      std::regex_search(svg, match, std::regex("<line class=\"" + css + "\" x1=\"([-\\d.]+)\"")));
  return std::stod(match[1]);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the page states the verdict first, then the stages", "[unit][html]") {
  const std::string page = page_of(sample_result(Outcome::failed));
  const auto verdict = page.find("Failed"), reason = page.find("at least 61.1 µm"),
             stages = page.find("<h2>Stages</h2>");
  CHECK(verdict < reason);
  CHECK(reason < stages);
  CHECK(contains(page, "Worst gouge: <strong>"));
  CHECK(contains(page, "program line "));
  CHECK(contains(page, "Not run"));
  CHECK(contains(page_of(sample_result(Outcome::passed)), "Every gate figure is proven"));
  CHECK(contains(page_of(sample_result(Outcome::indeterminate)), "Undecided"));
}

TEST_CASE("the page nests, loads nothing and runs nothing", "[slow][html]") {
  for (const Outcome outcome : {Outcome::passed, Outcome::failed, Outcome::indeterminate}) {
    const std::string page = page_of(sample_result(outcome, 5), true);
    require_nesting(page);
    for (const char* word :
         {"<script", "http:", "https:", "@import", "url(", "javascript:", "onload"})
      CHECK_FALSE(contains(page, word));
    CHECK(contains(page, "default-src 'none'"));
    for (std::size_t at = 0; (at = page.find(" src=\"", at)) != std::string::npos; ++at)
      CHECK(page.compare(at + 6, 15, "data:image/png;") == 0);
  }
}

TEST_CASE("text from files is shown as text", "[unit][html]") {
  RunResult r = sample_result(Outcome::failed, 3);
  const std::string hostile = "\"><script>alert('x')</script><img src=x onerror=y>&amp;\x01";
  r.job = r.created = r.version = r.surface.cage = hostile;
  r.assumptions = {hostile};
  for (StageResult& s : r.stages) {
    s.name = s.tool = s.strategy = hostile;
    s.decision.reasons = {hostile};
    if (!s.ran) continue;
    s.ran->ignored_words = {hostile};
    s.ran->deviation.budget[0].source = hostile;
    for (simulator::Finding& f : s.ran->process) f.part = f.against = hostile;
  }
  r.stages[0].program = hostile;
  const std::string page = page_of(r);
  require_nesting(page);
  CHECK_FALSE(contains(page, "<script"));
  CHECK_FALSE(contains(page, "<img"));
  CHECK(contains(page, "<h1>&quot;&gt;&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt;"));
  CHECK_FALSE(contains(page, "\x01"));
}

TEST_CASE("a page without pictures has none, and the same result gives the same page",
          "[unit][html]") {
  const RunResult result = sample_result(Outcome::passed, 5);
  CHECK_FALSE(contains(page_of(result), "<img"));
  const std::string page = page_of(result, true);
  CHECK(contains(page, "<img"));
  CHECK(page == page_of(sample_result(Outcome::passed, 5), true));
}

TEST_CASE("a ratio of limit to interval below 4 : 1 is marked", "[unit][html]") {
  // Its interval of 3.1 µm against 10 µm is 3.2 : 1.
  CHECK(
      contains(page_of(sample_result(Outcome::indeterminate)), "3.23 : 1 <strong class=\"warn\">"));
  CHECK_FALSE(contains(page_of(sample_result(Outcome::passed)), "class=\"warn\""));
}

TEST_CASE("findings stand in the table with place, patch, parameters and line", "[unit][html]") {
  const RunResult result = sample_result(Outcome::failed);
  const verifier::Finding& f = result.stages[1].ran->deviation.gouges.front();
  const std::string page = page_of(result);
  const auto row = page.find(">G1<", page.find("id=\"stage-2\""));
  REQUIRE(row != std::string::npos);
  const std::string text = page.substr(row, page.find("</tr>", row) - row);
  for (const std::string& cell :
       {measured_length(f.depth_mm), std::to_string(f.place.patch), fixed(f.place.u, 4),
        std::to_string(f.line), html::coordinates(f.place.point)})
    CHECK(contains(text, ">" + cell + "<"));
}

TEST_CASE("histogram bars are as high as their area and as wide as their bin", "[unit][html]") {
  verifier::StageDeviation d;
  d.histogram = {{-0.02, -0.01, 0, 0.01, 0.02}, {1, 0, 8, 4}};
  const verifier::GateLimits limits{true, true, false, 0.01, 0.01, 0};
  const std::string chart = html::histogram_chart(d, limits);
  const auto bars = rects_of(chart);
  REQUIRE(bars.size() == 3);  // the empty bin has none
  CHECK(bars[0].css == "gouge");
  CHECK(bars[1].css == "inside");
  CHECK(bars[2].css == "uncut");
  CHECK(bars[1].height == Approx(8 * bars[0].height));
  CHECK(bars[2].height == Approx(4 * bars[0].height));
  for (const Rect& bar : bars) {
    CHECK(bar.y + bar.height == Approx(100));
    CHECK(bar.width == Approx(bars[0].width).epsilon(1e-3));
  }
  // Positions are written to a thousandth of a percent.
  CHECK(line_at(chart, "zero") == Approx(bars[1].x).margin(2e-3));
  CHECK(bars[0].x + 2 * bars[0].width == Approx(bars[1].x).margin(4e-3));
  CHECK(line_at(chart, "limit") == Approx(bars[0].x + bars[0].width).margin(2e-3));
}

TEST_CASE("a limit far beyond the data is named, not drawn", "[unit][html]") {
  verifier::StageDeviation d;
  d.histogram = {{0, 0.0005, 0.001}, {3, 1}};
  const std::string chart = html::histogram_chart(d, {true, true, false, 1, 1, 0});
  CHECK_FALSE(contains(chart, "<line class=\"limit\""));
  CHECK(contains(chart, "← gouge limit 1 mm"));
  CHECK(contains(chart, "uncut limit 1 mm →"));
  CHECK(html::histogram_chart({}, {}).empty());
}

TEST_CASE("an interval is drawn against its limit to scale", "[unit][html]") {
  const std::string chart = html::interval_chart({0.004, 0.006}, true, 0.01);
  const auto rects = rects_of(chart);
  REQUIRE(rects.size() == 3);  // track, what is allowed, the interval
  CHECK(rects[2].css == "pass");
  const double limit = line_at(chart, "limit");
  CHECK(rects[2].x == Approx(0.4 * limit).epsilon(1e-3));
  CHECK(rects[2].width == Approx(0.2 * limit).epsilon(1e-3));
  CHECK(rects_of(html::interval_chart({0.004, 0.02}, true, 0.01))[2].css == "open");
  CHECK(rects_of(html::interval_chart({0.014, 0.02}, true, 0.01))[2].css == "fail");
  CHECK(rects_of(html::interval_chart({0.014, 0.02}, false, 0))[1].css == "none");
}

TEST_CASE("numbers are set as numbers", "[unit][html]") {
  CHECK(html::typeset("-1.25") == "−1.25");
  CHECK(html::typeset("8.10e-08") == "8.10 × 10<sup>−8</sup>");
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
  require_nesting(page);
  for (const std::string shown :
       {"A &lt;paper&gt;, Tables 1 and 3", "7 to 10", "277 MB", "1.66 MB"})
    CHECK(contains(page, shown));
}
