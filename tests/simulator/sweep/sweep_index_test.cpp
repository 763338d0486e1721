#include "simulator/sweep/sweep_index.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "model/base/error.h"
#include "tests/simulator/paths.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace simulator;

namespace {

model::Toolpath spiral(std::size_t moves) {
  model::Toolpath path;
  for (std::size_t i = 0; i < moves; ++i) {
    const double turn = 0.01 * static_cast<double>(i);
    path.moves.push_back({{0.01 * turn * std::cos(turn), 0.01 * turn * std::sin(turn), 0.1 * turn},
                          1000,
                          1,
                          model::MoveKind::feed});
  }
  return path;
}

}  // namespace

TEST_CASE("the tree over the moves is the same for any number of threads",
          "[property][sweep_index]") {
  const std::size_t moves = GENERATE(0, 1, 4, 5, 9, 1000, 200'003);
  const model::Toolpath path = spiral(moves);
  const SweepOrder one = order_moves(path, {1, nullptr, {}}),
                   five = order_moves(path, {5, nullptr, {}});
  CHECK(one.moves == five.moves);
  REQUIRE(one.nodes.size() == five.nodes.size());
  for (std::size_t i = 0; i < one.nodes.size(); ++i) {
    REQUIRE(one.nodes[i].first == five.nodes[i].first);
    REQUIRE(one.nodes[i].count == five.nodes[i].count);
  }
}

TEST_CASE("each move is in one leaf and each node below one other", "[property][sweep_index]") {
  const std::size_t moves = GENERATE(1, 5, 33, 70'001);
  const SweepOrder order = order_moves(spiral(moves), {2, nullptr, {}});
  std::vector<int> in_path(moves), in_leaf(moves), below(order.nodes.size());
  for (const std::uint32_t m : order.moves) ++in_path.at(m);
  for (const auto& node : order.nodes) {
    for (std::uint32_t s = node.first; s < node.first + node.count; ++s) ++in_leaf.at(s);
    if (node.count == 0) ++below.at(node.first), ++below.at(node.first + 1);
  }
  CHECK(below[0] == 0);
  CHECK(std::all_of(below.begin() + 1, below.end(), [](int n) { return n == 1; }));
  CHECK(std::all_of(in_path.begin(), in_path.end(), [](int n) { return n == 1; }));
  CHECK(std::all_of(in_leaf.begin(), in_leaf.end(), [](int n) { return n == 1; }));
}

TEST_CASE("building the tree stops when asked to", "[unit][sweep_index]") {
  const std::atomic<bool> stop = true;
  const Pass pass{test::cutter(model::CutterType::ball, 6, 20),
                  std::make_shared<const model::Toolpath>(spiral(10))};
  CHECK_THROWS_AS(SweepIndex(pass, {2, &stop, {}}), model::Interrupted);
}
