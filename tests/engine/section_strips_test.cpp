#include "engine/surface/section/section_strips.h"

#include <algorithm>
#include <atomic>

#include "tests/engine/lift_probe.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace engine::surface;

namespace {

constexpr int kAxis = 1;
using Points = std::vector<std::vector<Vec3>>;  ///< of the chains of a plane

/// Crumpled sheets and domes of different sizes that lie over each other along the axis.
std::vector<Grid> scattered_grids() {
  std::vector<Grid> grids;
  for (int i = 0; i < 24; ++i) {
    const int cells = 4 + i % 5 * 7;
    const auto dome = [](double x, double y) { return x * x + y * y; };
    Grid grid = i % 3 == 0 ? test::height_grid(cells, 3, dome)
                           : test::crumpled_grid(cells, 2, static_cast<std::uint32_t>(i));
    for (Vec3& p : grid.points) p = Vec3{p.x, p.z + i * 7 % 24, p.y};
    grids.push_back(std::move(grid));
  }
  return grids;
}

std::vector<SectionPiece> pieces_of(const std::vector<Grid>& grids,
                                    std::atomic<int>* made = nullptr) {
  std::vector<SectionPiece> pieces;
  for (const Grid& grid : grids)
    pieces.push_back({grid.points.size(), [&grid, made] {
                        if (made) ++*made;
                        return grid;
                      }});
  return pieces;
}

std::vector<SectionPiece> measured(const std::vector<Grid>& grids) {
  std::vector<SectionPiece> pieces = pieces_of(grids);
  measure_ranges(pieces, kAxis, {});
  return pieces;
}

std::vector<double> planes() {
  std::vector<double> values;
  for (int k = 0; k < 90; ++k) values.push_back(-4 + k * 0.37);
  return values;
}

struct Traced {
  std::vector<Points> chains;  ///< one a plane
  std::size_t held = 0;
};

Traced traced(const SectionStrips& strips, const std::vector<double>& values,
              const model::RunControl& control) {
  Traced found{std::vector<Points>(values.size())};
  found.held = strips.trace(values, control, [&](std::size_t k, std::vector<SectionChain>& chains) {
    for (SectionChain& chain : chains) found.chains[k].push_back(std::move(chain.points));
  });
  return found;
}

/// Plane by plane and grid by grid.
std::vector<Points> cut_by_itself(const std::vector<Grid>& grids,
                                  const std::vector<double>& values) {
  std::vector<Points> found(values.size());
  SectionScratch scratch;
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::vector<SectionChain> chains;
    for (const Grid& grid : grids) GridSection(grid, kAxis).cut(values[k], scratch, chains);
    for (SectionChain& chain : chains) found[k].push_back(std::move(chain.points));
  }
  return found;
}

}  // namespace

TEST_CASE("sections by strips are those of every plane by itself", "[property][section]") {
  const std::vector<Grid> grids = scattered_grids();
  const std::vector<double> values = planes();
  const std::vector<Points> expected = cut_by_itself(grids, values);
  REQUIRE(std::count_if(expected.begin(), expected.end(),
                        [](const Points& p) { return p.size() > 2; }) > 50);
  const std::size_t most =
      GENERATE(std::size_t{0}, std::size_t{2000}, std::size_t{5000}, std::size_t{1000000});
  model::RunControl control;
  control.threads = GENERATE(1U, 3U);
  const SectionStrips strips(measured(grids), kAxis, most, control);
  CHECK(traced(strips, values, control).chains == expected);
  CHECK(traced(strips, {values.begin() + 7, values.begin() + 8}, control).chains.front() ==
        expected[7]);
  CHECK(traced(strips, {}, control).chains.empty());
}

TEST_CASE("strips hold no more points than they may or one plane needs", "[unit][section]") {
  const std::vector<Grid> grids = scattered_grids();
  const std::vector<double> values = planes();
  const std::size_t most = GENERATE(std::size_t{0}, std::size_t{3000}, std::size_t{5000});
  const SectionStrips strips(measured(grids), kAxis, most, {});
  std::size_t worst = 0;
  for (const double value : values)
    worst = std::max(worst, strips.strips(std::vector{value}).front().points);
  REQUIRE(worst > 2000);
  REQUIRE(worst < 5000);
  const auto plan = strips.strips(values);
  std::size_t next = 0, largest = 0;
  for (const auto& strip : plan) {
    CHECK(strip.first == next);
    CHECK(strip.points <= std::max(most, worst));
    next = strip.last;
    largest = std::max(largest, strip.points);
  }
  CHECK(next == values.size());
  CHECK(plan.size() > 2);
  CHECK(plan.size() < values.size() / 2);
  // What is really held is what was planned.
  CHECK(traced(strips, values, {}).held == largest);
}

TEST_CASE("grids within the bound are made once, others as strips come to them",
          "[unit][section]") {
  const std::vector<Grid> grids = scattered_grids();
  std::atomic<int> made = 0;
  const auto trace_twice = [&](std::size_t most) {
    made = 0;
    std::vector<SectionPiece> pieces = pieces_of(grids, &made);
    const std::vector<SectionPiece> ranges = measured(grids);
    for (std::size_t g = 0; g < grids.size(); ++g) {
      pieces[g].low = ranges[g].low;
      pieces[g].high = ranges[g].high;
    }
    const SectionStrips strips(std::move(pieces), kAxis, most, {});
    traced(strips, planes(), {});
    traced(strips, planes(), {});
    return made.load();
  };
  const int count = static_cast<int>(grids.size());
  CHECK(trace_twice(1000000) == count);
  // What the next strip meets as well stays: each grid is made once a pass over the planes.
  CHECK(trace_twice(2000) == 2 * count);
}

TEST_CASE("a plane meets a grid that lies below it and reaches it", "[unit][section]") {
  const std::vector<Grid> grids = {test::height_grid(4, 1, [](double, double) { return 0; })};
  const SectionStrips strips(measured(grids), kAxis, 0, {});
  // Points in the plane count as above it: see AxisPlane.
  const auto met = [&](double value) { return strips.strips(std::vector{value}).front().points; };
  CHECK(met(-1) == 0);
  CHECK(met(-1 + 1e-12) == 25);
  CHECK(met(1) == 25);
  CHECK(met(1 + 1e-12) == 0);
  // Between two planes it is not made.
  CHECK(strips.strips(std::vector{-2.0, 2.0}).front().points == 0);
}

TEST_CASE("a range that is too narrow loses chains", "[unit][section]") {
  const std::vector<Grid> grids = scattered_grids();
  const std::vector<double> values = planes();
  const std::vector<Points> expected = cut_by_itself(grids, values);
  std::vector<SectionPiece> pieces = measured(grids);
  pieces[5].high -= 0.5 * (pieces[5].high - pieces[5].low);
  CHECK(traced(SectionStrips(std::move(pieces), kAxis, 0, {}), values, {}).chains != expected);
}
