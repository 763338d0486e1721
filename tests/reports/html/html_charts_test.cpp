#include <regex>

#include "reports/html/charts.h"
#include "tests/reports/page/page_support.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

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

}  // namespace

TEST_CASE("histogram bars are as high as their area and as wide as their bin", "[unit][html]") {
  verifier::StageDeviation d;
  d.histogram = {{-0.02, -0.01, 0, 0.01, 0.02}, {1, 0, 8, 4}};
  const verifier::GateLimits limits{true, true, false, 0.01, 0.01, 0};
  const std::string chart = html::histogram_chart(d, limits, 0);
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
  const std::string chart = html::histogram_chart(d, {true, true, false, 1, 1, 0}, 0);
  CHECK_FALSE(contains(chart, "<line class=\"limit\""));
  CHECK(contains(chart, "← gouge limit 1 mm"));
  CHECK(contains(chart, "uncut limit 1 mm →"));
  CHECK(html::histogram_chart({}, {}, 0).empty());
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
