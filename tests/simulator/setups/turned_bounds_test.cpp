// What is said of whole cubes and blocks about turned passes, against places in them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "simulator/grid/block_cut.h"
#include "simulator/sweep/depth_bound.h"
#include "simulator/sweep/near_moves.h"
#include "simulator/sweep/pass_reach.h"
#include "tests/simulator/setups/turned_bench.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::Box3;
using model::Pose;
using model::Vec3;
using simulator::Cube;
using simulator::Pass;
using simulator::SweepIndex;
using simulator::SweptSample;
using namespace simulator::test;

constexpr double kBeyondAll = std::numeric_limits<double>::infinity();

/// Least distance over all moves, each asked in the frame of the path.
double least_of_all(const Pass& pass, const SweepIndex& index, const Vec3& p) {
  double least = kBeyondAll;
  for (std::size_t i = 0; i < pass.path->moves.size(); ++i) {
    const simulator::SweptMove move(move_from(*pass.path, i), pass.path->moves[i].to, 0);
    least = std::min(least,
                     swept_distance(index.own().profile(), move, pass.pose.point_back(p)).distance);
  }
  return least;
}

Box3 near_pass(const Pass& pass) {
  return pass.pose.box({{-12, -9, -7}, {12, 9, 4}});
}

}  // namespace

TEST_CASE("moves kept for a cube are all that matter in it, of turned passes too",
          "[property][setups]") {
  for (const TurnedCase& t : many_turned_cases()) {
    INFO(t.to.name << ", " << model::to_text(t.cutter));
    const Pass pass = placed(moves_of_all_kinds(t.cutter, t.seed), t.to.pose);
    const SweepIndex index(pass);
    PlaceDraw draw(near_pass(pass), t.seed);
    double worst = 0;
    for (int trial = 0; trial < 150; ++trial) {
      const Cube wide{draw(), draw.between(0.1, 4)};
      const double half = wide.half_edge_mm * draw.between(0.1, 0.6);
      const double room = wide.half_edge_mm - half;
      const Vec3 aside{draw.between(-room, room), draw.between(-room, room),
                       draw.between(-room, room)};
      const Cube narrow{wide.middle + aside, half};
      simulator::NearMoves outer, inner;
      outer.gather(index, wide, kBeyondAll);
      inner.narrow(index, outer, narrow, kBeyondAll);
      for (int i = 0; i < 20; ++i) {
        const Vec3 p = narrow.middle + Vec3{draw.between(-half, half), draw.between(-half, half),
                                            draw.between(-half, half)};
        const double exact = least_of_all(pass, index, p);
        const auto of_index = index.nearest(p, kBeyondAll),
                   of_outer = outer.nearest(index, p, kBeyondAll),
                   of_inner = inner.nearest(index, p, kBeyondAll);
        REQUIRE((of_index && of_outer && of_inner));
        for (const auto& found : {of_index, of_outer, of_inner})
          worst = std::max(worst, std::abs(found->at.distance - exact));
      }
    }
    CHECK(worst < 1e-9);
  }
}

TEST_CASE("a turned move's distance stays below its bound all over a block", "[property][setups]") {
  for (const TurnedCase& t : many_turned_cases()) {
    INFO(t.to.name << ", " << model::to_text(t.cutter));
    const Pass pass = placed(moves_of_all_kinds(t.cutter, t.seed), t.to.pose);
    const SweepIndex index(pass);
    PlaceDraw draw(near_pass(pass), t.seed + 100);
    double over = -kBeyondAll;
    for (int trial = 0; trial < 400; ++trial) {
      const Vec3 p = draw();
      const Vec3 half{draw.between(0, 2), draw.between(0, 1), draw.between(0, 0.5)};
      const auto slot =
          static_cast<std::uint32_t>(draw.between(0, static_cast<double>(index.size()) - 0.01));
      const SweptSample at = index.distance(slot, p);
      const double e = index.outside_bound(slot, p, at, half);
      for (int i = 0; i < 50; ++i) {
        const Vec3 d{draw.between(-half.x, half.x), draw.between(-half.y, half.y),
                     draw.between(-half.z, half.z)};
        const double bound = std::max(0.0, at.distance + dot(at.gradient, d) + e);
        over = std::max(over, index.distance(slot, p + d).distance - bound);
      }
    }
    CHECK(over < 1e-9);
  }
}

TEST_CASE("no place of a body in a block is deeper than the bound, beside turned passes",
          "[property][setups]") {
  for (const TurnedCase& t : many_turned_cases()) {
    INFO(t.to.name << ", " << model::to_text(t.cutter));
    const Pass before = placed(moves_of_all_kinds(t.cutter, t.seed), t.to.pose);
    const simulator::Material material =
        simulator::Material(simulator::RawStock(turned(setup_block(), t.to.pose)))
            .after(std::make_shared<const SweepIndex>(before));
    // An upright cutter of the setup at work.
    PlaceDraw draw(near_pass(before), t.seed + 200);
    const simulator::CutterProfile body(2, 9);
    const SweepIndex own(PathBuilder(draw()).feed(draw()).feed(draw()).pass(t.cutter));
    const simulator::MaterialAtMove at{&material, &own, 2};
    double over = -kBeyondAll;
    int in_body = 0, lowered = 0;
    for (int trial = 0; trial < 400; ++trial) {
      const simulator::SweptMove move(draw(), draw(), 0);
      const Vec3 middle = move.start + move.delta * 0.5 + Vec3{0, 0, draw.between(0, 3)};
      const Vec3 half{draw.between(0, 2), draw.between(0, 1), draw.between(0, 1.5)};
      const auto cover = cover_at(at, middle, {});
      const auto own_depth = depth_under(at, cover, middle, half);
      const auto at_middle = swept_distance(body, move, middle);
      // By one cover, and by whatever covers a corner besides: neither is exceeded.
      const Vec3 corner{draw.between(-1, 1) < 0 ? -half.x : half.x, half.y, half.z};
      const auto other = depth_under(at, cover_at(at, middle + corner, cover), middle, half);
      const double by_one = depth_bound(own_depth, at_middle, half),
                   bound = depth_bound(own_depth, other, at_middle, half);
      CHECK(bound <= by_one);
      lowered += bound < by_one - 1e-3 ? 1 : 0;
      for (int i = 0; i < 30; ++i) {
        const Vec3 p = middle + Vec3{draw.between(-half.x, half.x), draw.between(-half.y, half.y),
                                     draw.between(-half.z, half.z)};
        if (swept_distance(body, move, p).distance > 0) continue;
        ++in_body;
        const double depth = depth_under(at, cover_at(at, p, cover), p, {}).value;
        if (depth > 0) over = std::max(over, depth - bound);
      }
    }
    CHECK(in_body > 2000);
    CHECK(lowered > 5);
    CHECK(over < 1e-9);
  }
}

TEST_CASE("a turned pass reaches where it is said to", "[property][setups]") {
  for (const TurnedCase& t : many_turned_cases()) {
    INFO(t.to.name << ", " << model::to_text(t.cutter));
    const Pass pass = placed(moves_of_all_kinds(t.cutter, t.seed), t.to.pose);
    const SweepIndex index(pass);
    const simulator::Lattice lattice{near_pass(pass).low, 0.06};
    const double band = 3 * lattice.voxel_mm;
    constexpr int kEdge = simulator::kBlockEdge;
    const simulator::IndexBox box{{0, 0, 0}, {12 * kEdge, 9 * kEdge, 8 * kEdge}};
    const auto reach = pass_reach(index, lattice, band, box, {2});
    PlaceDraw draw({{0, 0, 0}, {1, 1, 1}}, t.seed);
    const auto voxel_in = [&](const simulator::Index3& corner, int edge) {
      simulator::Index3 i = corner;
      for (int& a : i) a += static_cast<int>(draw.between(0, edge - 0.01));
      return lattice.point(i);
    };
    for (const auto& block : reach.swallowed_blocks)
      CHECK(least_of_all(pass, index, voxel_in(block, kEdge)) < -band);
    int left_out = 0;
    each_cube(box, kEdge, [&](const simulator::Index3& block) {
      const auto names = [&](const auto& list) {
        return std::find(list.begin(), list.end(), block) != list.end();
      };
      if (names(reach.partly) || names(reach.swallowed_blocks)) return;
      const bool in_node = std::any_of(
          reach.swallowed_nodes.begin(), reach.swallowed_nodes.end(), [&](const auto& node) {
            return simulator::cube_at(node, simulator::kNodeEdge).contains(block);
          });
      if (in_node) return;
      ++left_out;
      CHECK(least_of_all(pass, index, voxel_in(block, kEdge)) > band);
    });
    CHECK(left_out > 0);
  }
}
