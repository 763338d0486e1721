// Cutter locations against evaluators that know nothing of edges, facets, trees or convexity.
#include <random>

#include "engine/strategy/locations/cutter_locations.h"
#include "model/base/run_control.h"
#include "tests/engine/lift_probe.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using engine::strategy::CutterLocations;
using engine::surface::Grid;
using model::Vec3;

namespace {

constexpr double kError = limitgauge::engine::kHeightError_mm;
const char* const kCutters[] = {"flat:D=5", "ball:D=4", "bull:D=6,r=0.8",
                                "taper:D=1.5,r=0.5,angle=15,L=4", "taper:D=1,r=0.5,angle=50,L=2"};

struct Place {
  double x = 0, y = 0;
};

std::vector<Place> places(int count, double half, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> by(-half, half);
  std::vector<Place> all(count);
  for (Place& p : all) p.x = by(random), p.y = by(random);
  return all;
}

/// A move whose height changes by up to 2 mm, 0.5 to 6 mm long.
struct Way {
  Vec3 from, to;
};

std::vector<Way> ways(int count, double half, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> by(-half, half), up(-1, 1), turn(0, 6.2832), far(0.5, 6);
  std::vector<Way> all(count);
  for (Way& w : all) {
    w.from = {by(random), by(random), up(random)};
    const double angle = turn(random), length = far(random);
    w.to = w.from + Vec3{length * std::cos(angle), length * std::sin(angle), up(random)};
  }
  return all;
}

/// A grid for every triangle: its last corner twice.
std::vector<Grid> apart(const std::vector<Grid>& grids) {
  std::vector<Grid> single;
  for (const auto& t : test::triangles_of(grids))
    single.push_back({2, 2, {t[0], t[1], t[2], t[2]}});
  return single;
}

}  // namespace

TEST_CASE("tip heights are the greatest over every point of every triangle",
          "[property][cutter_locations]") {
  const int kind = GENERATE(range(0, 5));
  const double allowance = GENERATE(0.0, 0.3);
  const auto cutter = model::parse_cutter(kCutters[kind]);
  INFO(kCutters[kind] << " allowance " << allowance);
  const std::vector<Grid> grids = {test::crumpled_grid(3, 5, 11u + kind)};
  const auto triangles = test::triangles_of(grids);
  const CutterLocations locations(grids, cutter, allowance);
  for (const Place& p : places(4, 7, 5)) {
    const double brute = test::brute_height(cutter, allowance, triangles, p.x, p.y);
    const auto found = locations.tip_z(p.x, p.y);
    INFO("at " << p.x << " " << p.y);
    REQUIRE(found.has_value() == (brute > test::kNone));
    if (!found) continue;
    // Looks may stop short of the greatest at a kink of the function, never beyond it.
    CHECK(*found >= brute - 1e-9);
    CHECK(*found <= brute + 5e-4);
  }
}

TEST_CASE("the lift of a move is the greatest along it", "[property][cutter_locations]") {
  const int kind = GENERATE(range(0, 5));
  const double allowance = GENERATE(0.0, 0.3);
  const auto cutter = model::parse_cutter(kCutters[kind]);
  INFO(kCutters[kind] << " allowance " << allowance);
  const std::vector<Grid> grids = {test::crumpled_grid(4, 6, 23u + kind)};
  const CutterLocations locations(grids, cutter, allowance);
  // Over one triangle the lift is concave along the move, so looks find its greatest.
  std::vector<CutterLocations> singles;
  for (const Grid& g : apart(grids)) singles.emplace_back(std::vector{g}, cutter, allowance);
  for (const Way& w : ways(20, 6, 7)) {
    double brute = test::kNone;
    for (const auto& single : singles)
      brute = std::max(brute, test::greatest_along([&](double t) {
                         const Vec3 tip = lerp(w.from, w.to, t);
                         const auto z = single.tip_z(tip.x, tip.y);
                         return z ? *z - tip.z : test::kNone;
                       }));
    const auto found = locations.lift(w.from, w.to);
    REQUIRE(found.has_value() == (brute > test::kNone));
    if (!found) continue;
    // Both lie within the error above the truth; where the body's upright side just reaches an
    // edge, height is steep in t and the looks stop short.
    CHECK(*found >= brute - kError);
    CHECK(*found <= brute + 1e-4);
    const Vec3 up{0, 0, *found};
    CHECK(locations.clears(w.from + up, w.to + up, 0));
    CHECK(locations.clears(w.from + up, w.to + up, kError));
    const Vec3 sunk = up - Vec3{0, 0, 2e-6};
    CHECK_FALSE(locations.clears(w.from + sunk, w.to + sunk, 0));
  }
}

TEST_CASE("the lift of a long move holds at every place of it", "[property][cutter_locations]") {
  const int kind = GENERATE(range(0, 5));
  const auto cutter = model::parse_cutter(kCutters[kind]);
  std::vector<Grid> grids;
  for (int i = 0; i < 6; ++i) {
    grids.push_back(test::crumpled_grid(17, 6, 40u + i));
    for (Vec3& p : grids.back().points) p += Vec3{9.0 * (i % 3), 9.0 * (i / 3), 0.3 * i};
  }
  const CutterLocations locations(grids, cutter, 0.1);
  for (Way w : ways(12, 6, 9)) {
    w.to = w.from + (w.to - w.from) * 4;
    const auto lift = locations.lift(w.from, w.to);
    REQUIRE(lift.has_value());
    double sampled = test::kNone;
    for (int i = 0; i <= 1000; ++i) {
      const Vec3 tip = lerp(w.from, w.to, i / 1000.0);
      if (const auto z = locations.tip_z(tip.x, tip.y)) sampled = std::max(sampled, *z - tip.z);
    }
    CHECK(*lift >= sampled - kError);
    // A step is at most 0.024 mm; slopes of the surface are below 4 but beside upright sides.
    CHECK(*lift <= sampled + 0.1);
  }
}

TEST_CASE("a move straight up or down is as high as its lower end", "[unit][cutter_locations]") {
  const CutterLocations locations({test::crumpled_grid(5, 5, 3)}, model::parse_cutter("ball:D=4"),
                                  0);
  const double z = *locations.tip_z(0.5, 0.25);
  CHECK(*locations.lift({0.5, 0.25, 9}, {0.5, 0.25, 1}) == Approx(z - 1).margin(kError));
  CHECK(*locations.lift({0.5, 0.25, -1}, {0.5, 0.25, 9}) == Approx(z + 1).margin(kError));
  CHECK(locations.clears({0.5, 0.25, z}, {0.5, 0.25, 9}, 0));
  CHECK_FALSE(locations.clears({0.5, 0.25, z - 1e-5}, {0.5, 0.25, 9}, 0));
}

TEST_CASE("cutter locations are the same for any number of threads",
          "[property][cutter_locations]") {
  const CutterLocations locations({test::crumpled_grid(30, 15, 3)},
                                  model::parse_cutter("bull:D=6,r=1"), 0.1);
  const auto all = ways(500, 12, 31);
  const auto ask = [&](unsigned threads) {
    std::vector<double> lifts(all.size());
    model::parallel_for(all.size(), threads, [&](std::size_t i) {
      lifts[i] = locations.lift(all[i].from, all[i].to).value_or(-1);
    });
    return lifts;
  };
  CHECK(ask(1) == ask(3));
}
