// The oracle of definition 2 against closed forms: what is to judge the certificate must be right
// itself.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/defects/oracle.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/part_cages.h"
#include "tests/support/rasters.h"

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;

constexpr double kSpacing_mm = 0.15;
/// A climb ends within 1e-4 mm of a cusp, whose slope is under 1; marches end within 1e-5 mm.
constexpr double kClose_mm = 2e-4;

model::BoxStock block(const Vec3& low, const Vec3& high) {
  return {low, high - low};
}

simulator::Pass pass(const model::Cutter& cutter, model::Toolpath path) {
  return {cutter, shared(std::move(path))};
}

model::Toolpath along(const std::vector<Vec3>& tips) {
  model::Toolpath path;
  path.start = tips.front();
  for (std::size_t k = 1; k < tips.size(); ++k) feed_to(path, tips[k]);
  return path;
}

}  // namespace

TEST_CASE("oracle: cusps of a ball on a plane, from fine to coarse", "[unit]") {
  const Target plane(plane_cage(4, 0, 0), kSpacing_mm);
  for (const auto& [radius, step] :
       {std::pair{3.0, 0.25}, {3.0, 1.0}, {2.0, 2.5}, {2.0, 3.5}, {1.0, 1.9}}) {
    const double half = step * std::ceil(5 / step);  // rows lie at multiples of the step
    const simulator::Pass cut =
        pass(ball_cutter(radius), raster(half, step, 2 * half, [](double, double) { return 0.0; }));
    const RunOracle oracle(plane, block({-5, -5, -5}, {5, 5, 5}), {&cut, 1}, 0);
    const double cusp = radius - std::sqrt(radius * radius - step * step / 4);
    CAPTURE(radius, step, cusp);
    const Extreme found = oracle.surely_uncut({});
    // What is sure is so three quarters of a micrometre beside the cusp's line too.
    const double slope = step / 2 / std::sqrt(radius * radius - step * step / 4);
    CHECK(found.depth_mm >= cusp - kClose_mm - 1.1 * slope * 7.5e-4);
    CHECK(found.depth_mm <= cusp + 1e-8);
    CHECK(oracle.possibly_uncut(found.place) >= found.depth_mm);
    CHECK(oracle.possibly_uncut(found.place) <= cusp + 5e-5);
    CHECK(oracle.surely_gouged({}).depth_mm == 0);
  }
}

TEST_CASE("oracle: a fin between two flats stands with its height", "[unit]") {
  const Target plane(plane_cage(4, 0, 0), kSpacing_mm);
  for (const double thick : {0.002, 0.02, 0.099}) {
    const double x = 4 + thick / 2;
    const simulator::Pass cut =
        pass(flat_cutter(4),
             along({{-x, -9, 0}, {-x, 9, 0}, {-x, 9, 8}, {x, 9, 8}, {x, 9, 0}, {x, -9, 0}}));
    const RunOracle oracle(plane, block({-5, -5, -5}, {5, 5, 5}), {&cut, 1}, 0);
    CAPTURE(thick);
    // The nodes of the plane include its middle.
    // A march a quarter of a micrometre beside a wall ends with its steps.
    const double sure = oracle.surely_uncut({}).depth_mm;
    CHECK(sure >= (thick < 0.01 ? 4.9 : 5 - kClose_mm));
    CHECK(sure <= 5 + kClose_mm);
    CHECK(oracle.uncut({0, 0, 0}, {0, 0, 1}).possible_mm == Approx(5).margin(1e-4));
    CHECK(oracle.uncut({thick, 0, 0}, {0, 0, 1}).possible_mm == 0);
  }
}

TEST_CASE("oracle: a drilled hole is as deep as it was drilled", "[unit]") {
  const Target plane(plane_cage(4, 0, 0), kSpacing_mm);
  const simulator::Pass cut = pass(flat_cutter(0.04), along({{1, 1, 9}, {1, 1, -4}, {1, 1, 9}}));
  const RunOracle oracle(plane, block({-5, -5, -5}, {5, 5, 1}), {&cut, 1}, 0);
  CHECK(oracle.gouge({1, 1, 0}, {0, 0, 1}).sure_mm == Approx(4).margin(1e-5));
  CHECK(oracle.gouge({1, 1, 0}, {0, 0, 1}).possible_mm == Approx(4).margin(1e-4));
  CHECK(oracle.gouge({1.05, 1, 0}, {0, 0, 1}).possible_mm == 0);
  // Found from a hint: the hole is narrower than the samples are apart. (1, 1) is on a corner of
  // the cage's faces of 2 mm only by half of one: patch 2 + 4·2 from −4 mm.
  CHECK(oracle.surely_gouged({{10, 0.5, 0.5}}).depth_mm == Approx(4).margin(1e-5));
}

TEST_CASE("oracle: what lies outside the raw stock is missing, not gouged", "[unit]") {
  const Target plane(plane_cage(4, 0, 0), kSpacing_mm);
  const simulator::Pass cut = pass(flat_cutter(2), along({{-9, 0, 1}, {9, 0, 1}}));
  const RunOracle oracle(plane, block({-5, -5, -5}, {5, 5, -0.3}), {&cut, 1}, 0);
  CHECK(oracle.surely_gouged({}).depth_mm == 0);
  CHECK(oracle.surely_missing().depth_mm == Approx(0.3).margin(1e-5));
}

TEST_CASE("oracle: material over a sharp ridge, which a ball rides on and does not cut", "[unit]") {
  // Ridges of 90 degrees, 1 mm apart and 0.5 mm high, under a block 2 mm higher than they are.
  const Target ridges(ridge_cage({4, 1, 45}), kSpacing_mm);
  const simulator::Pass cut = pass(ball_cutter(3), along({{-20, -20, 9}, {-20, 20, 9}}));
  const RunOracle oracle(ridges, block({-5, -5, -5}, {5, 5, 2.5}), {&cut, 1}, 0);
  const Extreme found = oracle.surely_uncut({});
  // Along normals that lean by β over the ridge the run is 2 / cos β; β goes up to 45 degrees, and
  // a ball of 3 mm whose centre is that far aside meets the neighbour ridge: 1 mm on at the same
  // height, it leans by asin(0.5 / 3) at the most. The fan has steps of 90/8 degrees.
  const double most = 2 / std::cos(std::asin(0.5 / 3));
  CHECK(found.depth_mm >= 2 - kClose_mm);
  CHECK(found.depth_mm <= 2 / std::cos(std::numbers::pi / 4) + 1e-6);
  // The outermost ridges have a neighbour on one side only.
  const auto& edges = ridges.sharp.samples();
  const auto inner = *std::find_if(edges.begin(), edges.end(), [&](const Place& p) {
    const Vec3 at = ridges.samples.at(p).position;
    return at.z > 0.499 && std::abs(at.x) < 0.6 && std::abs(at.y) < 1;
  });
  CHECK(oracle.possibly_uncut(inner) >= 2);
  CHECK(oracle.possibly_uncut(inner) <= most + 1e-2);
}

TEST_CASE("oracle: runs end at the next crossing of the surface", "[unit]") {
  // A slot 3 mm wide and 2 mm deep that nobody cut counts with its width from the walls and with
  // its depth, and the block over it, from the floor.
  const Target slot(slot_cage({3, 2, 4, 6}), kSpacing_mm);
  const simulator::Pass cut = pass(flat_cutter(0.5), along({{-20, -20, 9}, {-20, 20, 9}}));
  const RunOracle oracle(slot, block({-6, -6, -6}, {6, 6, 0}), {&cut, 1}, 0);
  CHECK(oracle.uncut({-1.5, 0.3, -1}, {1, 0, 0}).sure_mm == Approx(3).margin(2e-5));
  CHECK(oracle.uncut({-1.5, 0.3, -1}, {1, 0, 0}).possible_mm == Approx(3).margin(5e-5));
  CHECK(oracle.uncut({0.2, 0.3, -2}, {0, 0, 1}).sure_mm == Approx(2).margin(2e-5));
}

TEST_CASE("oracle: which cutter reaches what", "[unit]") {
  const Target bowl(paraboloid_cage(4, 0.1),
                    kSpacing_mm);  // radius of curvature 5 mm at the middle
  const model::Cutter small[] = {ball_cutter(3)}, large[] = {ball_cutter(15)},
                      both[] = {ball_cutter(15), ball_cutter(3)};
  const Vec3 middle{0, 0, 0}, up{0, 0, 1};
  CHECK(ReachOracle(bowl.samples, small, 0).at(middle, up) == Reach::sure);
  CHECK(ReachOracle(bowl.samples, large, 0).at(middle, up) == Reach::no);
  CHECK(ReachOracle(bowl.samples, both, 0).at(middle, up) == Reach::sure);
  CHECK(ReachOracle(bowl.samples, both, 2.5).at(middle, up) == Reach::no);
}

}  // namespace limitgauge::tests::defects
