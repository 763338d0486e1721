#include "verifier/cutter/removed_space.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "model/part/cutter.h"
#include "tests/support/catch.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Cutter;
using model::Vec3;

/// Two passes along the same slope, the second lower: as semi-finish and finish lie.
struct Slopes {
  std::mt19937 random{20};
  double slope = 0.7;

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  Vec3 on_slope(double x, double y, double up) {
    return {x, y, slope * x + 0.05 * std::sin(y) + up};
  }
  Pass pass(const Cutter& cutter, double up, double step) {
    auto path = std::make_shared<model::Toolpath>();
    path->start = on_slope(0, 0, up);
    for (double x = 0; x <= 12; x += step)
      for (double y = 0; y <= 12; y += 0.7)
        path->moves.push_back({on_slope(x, y, up), 1000, 1, model::MoveKind::feed});
    return {cutter, path};
  }
  Vec3 point() { return on_slope(between(0, 12), between(0, 12), between(-1.0, 0.6)); }
};

std::vector<Pass> passes_of(Slopes& slopes) {
  return {slopes.pass(model::parse_cutter("flat:D=4,L=20"), 0.8, 1.1),
          slopes.pass(model::parse_cutter("bull:D=5,r=1,L=20"), 0.3, 0.6),
          slopes.pass(model::parse_cutter("ball:D=6,L=20"), 0, 0.4)};
}

RemovedSpace space_of(std::span<const Pass> passes) {
  return {model::BoxStock{{-5, -5, -20}, {22, 22, 60}}, passes};
}

}  // namespace

TEST_CASE("a tilted box bounds the distance to all its moves from below", "[property][removed]") {
  Slopes slopes;
  for (const char* text : {"ball:D=6,L=4", "flat:D=8,L=20", "bull:D=10,r=2,L=3"}) {
    const CutterProfile profile(model::parse_cutter(text));
    REQUIRE(TiltedBox::serves(profile));
    double closest = 1e300;
    for (int n = 0; n < 400; ++n) {
      std::vector<SweptBody> bodies;
      const double x = slopes.between(0, 10), y = slopes.between(0, 10);
      for (int k = 0; k <= n % 5; ++k)
        bodies.emplace_back(slopes.on_slope(x + slopes.between(0, 1), y + slopes.between(0, 1), 0),
                            slopes.on_slope(x + slopes.between(0, 1), y + slopes.between(0, 1), 0));
      const TiltedBox box(bodies);
      const Vec3 half{0.1, 0.2, n % 2 * 0.3};
      for (int m = 0; m < 20; ++m) {
        const Vec3 p{x + slopes.between(-9, 9), y + slopes.between(-9, 9), slopes.between(-9, 20)};
        const double bound = box.bound(profile, p), wider = box.bound(profile, p, half);
        for (const SweptBody& body : bodies) {
          CHECK(body_value(profile, body, p) >= bound);
          closest = std::min(closest, body_value(profile, body, p) - bound);
          const Vec3 aside{half.x * slopes.between(-1, 1), half.y * slopes.between(-1, 1),
                           half.z * slopes.between(-1, 1)};
          CHECK(body_value(profile, body, p + aside) >= wider);
        }
      }
    }
    // It is a bound that says something.
    CHECK(closest < 0.01);
  }
  CHECK_FALSE(TiltedBox::serves(CutterProfile(model::parse_cutter("drill:D=6,angle=118,L=40"))));
  CHECK_FALSE(TiltedBox::serves(CutterProfile(model::parse_cutter("taper:D=1,r=0.5,angle=5,L=9"))));
}

TEST_CASE("the nearest body is that of all bodies one by one", "[property][removed]") {
  Slopes slopes;
  const std::vector<Pass> passes = passes_of(slopes);
  const RemovedSpace space = space_of(passes);
  for (int n = 0; n < 300; ++n) {
    const Vec3 p = slopes.point();
    double least = space.stock_distance_mm(p);
    for (std::uint32_t pass = 0; pass < passes.size(); ++pass)
      for (std::uint32_t k = 0; k < passes[pass].path->moves.size(); ++k)
        least = std::min(least, space.distance({pass, k}, p).value);
    CHECK(space.nearest(p).distance.value == Approx(least).margin(kSameDistance_mm));
  }
}

TEST_CASE("the nearest of grown and of shrunk bodies is that of all bodies one by one",
          "[property][removed]") {
  Slopes slopes;
  std::vector<Pass> passes = passes_of(slopes);
  for (Pass& pass : passes) {
    auto path = std::make_shared<model::Toolpath>(*pass.path);
    path->chord_error_mm = 0.5;
    pass.path = path;
  }
  // Its faces run through what was swept.
  const RemovedSpace space(model::BoxStock{{1, 1, -20}, {9, 9, 60}}, passes);
  int differ = 0;
  for (int n = 0; n < 2000; ++n) {
    const Vec3 p = slopes.point();
    const double stock = space.stock_distance_mm(p);
    double grown = stock, shrunk = stock;
    for (std::uint32_t pass = 0; pass < passes.size(); ++pass)
      for (std::uint32_t k = 0; k < passes[pass].path->moves.size(); ++k) {
        const double d = space.distance({pass, k}, p).value;
        grown = std::min(grown, d - 0.5), shrunk = std::min(shrunk, d + 0.5);
      }
    const Nearest at = space.nearest(p), most = space.nearest_grown(p),
                  least = space.nearest_shrunk(p);
    CHECK(most.distance.value - space.error_mm(most.body) ==
          Approx(grown).margin(kSameDistance_mm));
    CHECK(least.distance.value + space.error_mm(least.body) ==
          Approx(shrunk).margin(kSameDistance_mm));
    differ += at.body != most.body || at.body != least.body;
  }
  CHECK(differ > 0);
}

TEST_CASE("what is known of far passes and of near bodies changes no answer",
          "[property][removed]") {
  Slopes slopes;
  const std::vector<Pass> passes = passes_of(slopes);
  const RemovedSpace space = space_of(passes);
  const auto lists_equal = [](std::vector<BodyRef> a, std::vector<BodyRef> b) {
    std::sort(a.begin(), a.end()), std::sort(b.begin(), b.end());
    return a == b;
  };
  const double steps_mm[] = {0.4, 0.1, 0.02, 0.004};
  for (int walk = 0; walk < 32; ++walk) {
    FarPasses far;
    Vec3 p = slopes.point();
    std::optional<BodyRef> hint;
    for (int n = 0; n < 60; ++n) {
      p += Vec3{slopes.between(-1, 1), slopes.between(-1, 1), slopes.between(-1, 1)} *
           steps_mm[walk % 4];
      const Nearest with = space.nearest(p, hint, &far), without = space.nearest(p);
      if (walk / 4 % 2 == 1) hint = with.body;
      CHECK(with.body == without.body);
      CHECK(with.distance.value == without.distance.value);
      std::vector<BodyRef> at_with, at_without;
      const double limit = without.distance.value + slopes.between(0, 0.1);
      space.within(p, limit, at_with, &far), space.within(p, limit, at_without);
      CHECK(at_with == at_without);
      const model::Box3 box{p - Vec3{0.1, 0.1, 0.1}, p + Vec3{0.1, 0.1, 0.1}};
      std::vector<BodyRef> near_with, near_without;
      space.within(box, 0.05, near_with, &far), space.within(box, 0.05, near_without);
      // A list may hold bodies that are not so near: those that are have to be in both.
      const auto is_far = [&](BodyRef b) {
        double least = 1e300;
        for (int k = 0; k < 27; ++k)
          least = std::min(
              least,
              space.distance(b, p + Vec3{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0} * 0.1).value);
        return least > 0.05;
      };
      std::erase_if(near_with, is_far), std::erase_if(near_without, is_far);
      CHECK(lists_equal(near_with, near_without));
      const Vec3 ray = normalized(Vec3{-slopes.slope, slopes.between(-1, 1), 1});
      const EndRule rule{kSkin_mm, kBeside_mm, kAlong};
      const auto met_with = space.first_met(p, ray, 30, rule, &far);
      const auto met_without = space.first_met(p, ray, 30, rule);
      CHECK(met_with.t_mm == met_without.t_mm);
      CHECK(met_with.body == met_without.body);
    }
  }
}

}  // namespace limitgauge::verifier
