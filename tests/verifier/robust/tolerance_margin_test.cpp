#include "verifier/robust/tolerance_margin.h"

#include <algorithm>
#include <cmath>

#include "tests/support/catch.h"

namespace limitgauge::verifier {
namespace {

using Figure = std::function<double(double factor)>;

/// A stand-in for certificates: a figure of several witnesses, each growing with the box, of which
/// the first that exceeds the limit is shown, as a search that ends early does.
class Stand {
 public:
  Stand(double limit_mm, std::vector<Figure> witnesses)
      : limit_mm_(limit_mm), witnesses_(std::move(witnesses)) {}

  double worst(double factor) const {
    double worst = 0;
    for (const Figure& f : witnesses_) worst = std::max(worst, f(factor));
    return worst;
  }
  /// By how much the proof is above what witnesses show.
  double gap_mm = 0;
  /// No cutter has a larger box.
  double largest = 1e9;

  ToleranceMargin margin() {
    const Interval none{worst(0), worst(0)}, whole{worst(1), worst(1) + gap_mm};
    return find_margin(none, whole, limit_mm_, [&](double factor) { return tried(factor); });
  }
  int tries = 0;

 private:
  std::optional<BoxTrial> tried(double factor) {
    ++tries;
    CHECK(factor <= kLargestFactor);
    if (factor >= largest) return std::nullopt;
    for (const Figure& f : witnesses_)
      if (f(factor) > limit_mm_) return BoxTrial{BoxTrial::Is::beyond, f};
    if (worst(factor) + gap_mm > limit_mm_) return BoxTrial{BoxTrial::Is::undecided, {}};
    return BoxTrial{BoxTrial::Is::within, {}};
  }

  double limit_mm_;
  std::vector<Figure> witnesses_;
};

Figure line(double at_none, double slope) {
  return [=](double factor) { return at_none + slope * factor; };
}

/// Both ends within a thousandth of where the limit is reached, on their own sides.
void check_around(const ToleranceMargin& margin, double factor) {
  REQUIRE(margin.proven);
  REQUIRE(margin.refuted);
  CHECK(*margin.proven <= factor);
  CHECK(*margin.refuted >= factor);
  CHECK(*margin.proven >= factor * (1 - 1e-3));
  CHECK(*margin.refuted <= factor * (1 + 1e-3));
}

}  // namespace

TEST_CASE("a margin lies where the figure reaches its limit", "[unit]") {
  SECTION("beyond the stated box") {
    Stand stand(0.01, {line(0.002, 0.003)});
    check_around(stand.margin(), 8.0 / 3);
    CHECK(stand.tries <= 4);
  }
  SECTION("within the stated box") {
    Stand stand(0.01, {line(0.002, 0.1)});
    check_around(stand.margin(), 0.08);
    CHECK(stand.tries <= 4);
  }
  SECTION("with a bend, where the line through two boxes is wrong") {
    Stand stand(0.01, {[](double factor) { return 1e-4 * factor * factor * factor; }});
    check_around(stand.margin(), std::cbrt(100.0));
  }
  SECTION("with a corner: nothing, then steep") {
    Stand stand(0.01, {[](double factor) { return std::max(0.0, factor - 7); }});
    check_around(stand.margin(), 7.01);
  }
}

TEST_CASE("of many witnesses the worst decides a margin, whichever is seen first", "[unit]") {
  std::vector<Figure> witnesses;
  for (int k = 0; k < 200; ++k) witnesses.push_back(line(0.001, 0.001 * (1 + 0.02 * k)));
  Stand stand(0.01, witnesses);
  check_around(stand.margin(), 0.009 / (0.001 * (1 + 0.02 * 199)));
}

TEST_CASE("what no witness reaches and no proof excludes is left open in a margin", "[unit]") {
  Stand stand(0.01, {line(0.002, 0.002)});
  stand.gap_mm = 0.0005;
  const ToleranceMargin margin = stand.margin();
  REQUIRE(margin.proven);
  REQUIRE(margin.refuted);
  CHECK(*margin.proven <= 3.75);
  CHECK(*margin.proven >= 3.75 * (1 - 1e-3));
  CHECK(*margin.refuted >= 4);
  CHECK(*margin.refuted <= 4 * (1 + 1e-3));
}

TEST_CASE("stated values that fail have no margin", "[unit]") {
  Stand stand(0.01, {line(0.02, 0.001)});
  const ToleranceMargin margin = stand.margin();
  CHECK_FALSE(margin.proven);
  CHECK(margin.refuted == 0);
}

TEST_CASE("a margin ends at the largest box, and where there is no cutter", "[unit]") {
  SECTION("the largest box passes") {
    Stand stand(0.01, {line(0.001, 1e-6)});
    const ToleranceMargin margin = stand.margin();
    CHECK(margin.proven == kLargestFactor);
    CHECK_FALSE(margin.refuted);
  }
  SECTION("no cutter is so small") {
    Stand stand(0.01, {line(0.001, 1e-6)});
    stand.largest = 5;
    const ToleranceMargin margin = stand.margin();
    REQUIRE(margin.proven);
    CHECK(*margin.proven < 5);
    CHECK(*margin.proven > 5 * (1 - 2e-3));
    CHECK_FALSE(margin.refuted);
  }
}

}  // namespace limitgauge::verifier
