#include "simulator/process/finding.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include "simulator/sweep/move_runs.h"
#include "tests/simulator/process/process_bench.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using namespace limitgauge::simulator::test;
using simulator::Finding;
using simulator::FindingGroup;
using simulator::FindingKind;
using simulator::group_findings;

Finding finding(FindingKind kind, std::size_t move, double depth, const char* part = "cutter",
                const char* against = "stock") {
  return {kind, move, static_cast<std::uint32_t>(move + 10), {}, depth, part, against};
}

}  // namespace

TEST_CASE("findings on moves that follow each other are one group", "[unit][findings]") {
  using enum FindingKind;
  const std::vector<Finding> all = {finding(spindle_stopped, 3, 1),
                                    finding(near_miss, 3, -0.4, "holder"),
                                    finding(spindle_stopped, 4, 3),
                                    finding(near_miss, 4, -0.2, "holder"),
                                    finding(near_miss, 4, -0.1, "shank"),
                                    finding(spindle_stopped, 5, 3),
                                    finding(spindle_stopped, 7, 2),
                                    finding(fixture_touched, 8, 1, "cutter", "vice"),
                                    finding(fixture_touched, 9, 2, "cutter", "clamp")};
  const std::vector<FindingGroup> groups = group_findings(all);
  REQUIRE(groups.size() == 6);
  CHECK(groups[0].kind == spindle_stopped);
  CHECK(groups[0].count == 3);
  CHECK(groups[0].first_move == 3);
  CHECK(groups[0].last_move == 5);
  CHECK(groups[0].first_line == 13);
  CHECK(groups[0].last_line == 15);
  CHECK(groups[0].worst.move == 4);
  CHECK(groups[0].worst.depth_mm == 3);
  CHECK(groups[1].part == "holder");
  CHECK(groups[1].count == 2);
  CHECK(groups[1].worst.depth_mm == -0.2);
  CHECK(groups[2].part == "shank");
  CHECK(groups[3].first_move == 7);  // move 6 had none
  CHECK(groups[4].against == "vice");
  CHECK(groups[5].against == "clamp");
  CHECK(group_findings({}).empty());
}

TEST_CASE("a million findings are grouped in one go", "[unit][findings]") {
  std::vector<Finding> all;
  for (std::size_t i = 0; i < 1000000; ++i)
    all.push_back(finding(FindingKind::feed_missing, i + i / 1000, 0));
  const std::vector<FindingGroup> groups = group_findings(all);
  CHECK(groups.size() == 1000);
  CHECK(groups[7].count == 1000);
}

TEST_CASE("every kind has a name of its own, and near misses and slight contacts pass",
          "[unit][findings]") {
  std::vector<std::string> names;
  for (int k = 0; k <= static_cast<int>(FindingKind::near_miss); ++k) {
    const auto kind = static_cast<FindingKind>(k);
    CHECK(fails(kind) == (kind != FindingKind::near_miss && kind != FindingKind::slight_contact));
    names.emplace_back(name(kind));
  }
  CHECK(names.size() == 12);
  CHECK(names.front() == "rapid_through_stock");
  CHECK(names.back() == "near_miss");
  std::sort(names.begin(), names.end());
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
}

TEST_CASE("straight lines of one kind are runs", "[unit][findings]") {
  const auto pass = PathBuilder({0, 0, 0})
                        .rapid({1, 0, 0})
                        .rapid({1, 0, 0})  // of no length
                        .rapid({3, 0, 0})
                        .feed({4, 0, 0})  // of another kind
                        .feed({3, 0, 0})  // back
                        .feed({2, 0.01, 0})
                        .pass(ball4());
  const simulator::MoveRuns runs = simulator::straight_runs(*pass.path);
  const std::size_t begins[] = {0, 0, 0, 3, 4, 5}, ends[] = {3, 3, 3, 4, 5, 6};
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(runs.begin(i) == begins[i]);
    CHECK(runs.end(i) == ends[i]);
  }
  // Many small turns are no line: a circle of 3600 moves has runs of a few moves.
  PathBuilder circle({1, 0, 0});
  for (int i = 1; i <= 36000; ++i) {
    const double a = i * 3.14159265358979 / 18000;
    circle.feed({std::cos(a), std::sin(a), 0});
  }
  const auto round = circle.pass(ball4());
  const simulator::MoveRuns arcs = simulator::straight_runs(*round.path);
  for (std::size_t i = 0; i < 36000; i += 100) CHECK(arcs.end(i) - arcs.begin(i) <= 2);
}

TEST_CASE("series of neighbouring offenders", "[unit][findings]") {
  const bool offends[] = {false, true, true, false, true};
  const auto series = simulator::series_of(5, [&](std::size_t i) { return offends[i]; });
  CHECK(series.begin(1) == 1);
  CHECK(series.begin(2) == 1);
  CHECK(series.begin(4) == 4);
}

TEST_CASE("findings are the same for any number of threads", "[property][findings]") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<> x(-15, 15), z(-4, 4);
  PathBuilder b({0, 0, 20});
  for (int i = 0; i < 90; ++i) {
    const model::Vec3 to{x(random), x(random) / 2, z(random)};
    (random() % 3 == 0 ? b.rapid(to) : b.feed(to));
  }
  auto c = flat4(4);
  c.shank = {{4, 2}};
  c.holder = {{8, 10}};
  const simulator::Pass pass = changed(b.pass(c), [&](model::Toolpath& path) {
    for (model::Move& m : path.moves) {
      m.spindle_stopped = random() % 9 == 0;
      if (random() % 9 == 0) m.feed_mm_min = 0;
    }
  });
  simulator::ProcessLimits limits = plain_limits(0.5);
  limits.tolerance_mm = 0.05;
  limits.travel_mm = model::Box3{{-14, -7, -4}, {14, 7, 4}};
  limits.fixtures = {fixture("vice", box_mesh({{-20, -10, -10}, {20, -5, 1}})),
                     fixture("clamp", box_mesh({{9, -3, 0}, {12, 3, 3}}))};
  const auto one = check(block(), pass, limits, 1);
  CHECK(one.size() > 100);
  for (const unsigned threads : {2U, 3U}) {
    const auto other = check(block(), pass, limits, threads);
    REQUIRE(other.size() == one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      CHECK(one[i].kind == other[i].kind);
      CHECK(one[i].move == other[i].move);
      CHECK(one[i].point == other[i].point);
      CHECK(one[i].depth_mm == other[i].depth_mm);
      CHECK(one[i].part == other[i].part);
      CHECK(one[i].against == other[i].against);
    }
  }
  for (std::size_t i = 1; i < one.size(); ++i)
    CHECK(std::tuple(one[i - 1].move, one[i - 1].kind) <= std::tuple(one[i].move, one[i].kind));
}
