#include "simulator/sweep_index.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace limitgauge::simulator {
namespace {

using model::Box3;
using model::Vec3;

constexpr std::uint32_t kLeafMoves = 4;
// A median split halves 2^32 moves in fewer levels than this, with one node waiting a level.
constexpr std::size_t kDeepest = 64;

Box3 tip_box(const SweptMove& m) {
  Box3 box;
  box.add(m.start);
  box.add(m.start + m.delta);
  return box;
}

int longest_axis(const Vec3& size) {
  int axis = size.y > size.x ? 1 : 0;
  return size.z > size[axis] ? 2 : axis;
}

std::vector<SweptMove> moves_of(const Pass& pass) {
  if (!pass.path) throw std::invalid_argument("a pass without a path");
  const model::Toolpath& path = *pass.path;
  if (path.moves.size() >= std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument("a path of 2^32 moves or more");
  std::vector<SweptMove> moves;
  moves.reserve(path.moves.size());
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (!is_finite(move_from(path, i)) || !is_finite(path.moves[i].to))
      throw std::invalid_argument("a path with a coordinate that is not finite");
    moves.emplace_back(move_from(path, i), path.moves[i].to, static_cast<std::uint32_t>(i));
  }
  return moves;
}

}  // namespace

SweepIndex::SweepIndex(const Pass& pass) : profile_(pass.cutter), moves_(moves_of(pass)) {
  if (moves_.empty()) return;
  nodes_.reserve(moves_.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(moves_.size()));
}

void SweepIndex::close_leaf(Node& node, std::uint32_t begin, std::uint32_t end) {
  node.first = begin;
  node.count = end - begin;
  node.least_index = moves_[begin].index;
  for (std::uint32_t s = begin; s < end; ++s) {
    node.tips.add(tip_box(moves_[s]));
    node.least_index = std::min(node.least_index, moves_[s].index);
  }
}

void SweepIndex::build(std::uint32_t at, std::uint32_t begin, std::uint32_t end) {
  if (end - begin <= kLeafMoves) return close_leaf(nodes_[at], begin, end);
  Box3 centres;
  for (std::uint32_t s = begin; s < end; ++s) centres.add(tip_box(moves_[s]).centre());
  const int axis = longest_axis(centres.size());
  const std::uint32_t middle = begin + (end - begin) / 2;
  // Ties by path index: the tree does not depend on how nth_element breaks them.
  const auto key = [axis](const SweptMove& m) {
    return std::pair(m.start[axis] + 0.5 * m.delta[axis], m.index);
  };
  std::nth_element(moves_.begin() + begin, moves_.begin() + middle, moves_.begin() + end,
                   [&](const SweptMove& a, const SweptMove& b) { return key(a) < key(b); });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  build(children, begin, middle);
  build(children + 1, middle, end);
  Node& node = nodes_[at];
  node.first = children;
  node.tips.add(nodes_[children].tips);
  node.tips.add(nodes_[children + 1].tips);
  node.least_index = std::min(nodes_[children].least_index, nodes_[children + 1].least_index);
}

double SweepIndex::lower_bound(const Node& node, const Vec3& p) const {
  const double dx = std::max({node.tips.low.x - p.x, 0.0, p.x - node.tips.high.x});
  const double dy = std::max({node.tips.low.y - p.y, 0.0, p.y - node.tips.high.y});
  return profile_.lower_bound(std::sqrt(dx * dx + dy * dy), p.z - node.tips.high.z,
                              p.z - node.tips.low.z);
}

std::optional<NearestMove> SweepIndex::nearest(const Vec3& p, double bound,
                                               std::uint32_t end) const {
  std::optional<NearestMove> best;
  if (nodes_.empty()) return best;
  std::array<std::pair<double, std::uint32_t>, kDeepest> stack;
  std::size_t depth = 0;
  stack[depth++] = {lower_bound(nodes_[0], p), 0};
  while (depth > 0) {
    const auto [low, at] = stack[--depth];
    const Node& node = nodes_[at];
    if (low >= bound || node.least_index >= end) continue;
    for (std::uint32_t s = node.first; s < node.first + node.count; ++s) {
      if (moves_[s].index >= end) continue;
      if (cannot_be_below(profile_, moves_[s], p, bound)) continue;
      const SweptSample d = distance(s, p);
      if (d.distance < bound) bound = d.distance, best = NearestMove{s, d};
    }
    if (node.count > 0) continue;
    std::pair near{lower_bound(nodes_[node.first], p), node.first};
    std::pair far{lower_bound(nodes_[node.first + 1], p), node.first + 1};
    if (far.first < near.first) std::swap(near, far);
    stack[depth++] = far;
    stack[depth++] = near;
  }
  return best;
}

void SweepIndex::gather(const Vec3& p, double limit, std::vector<std::uint32_t>& slots) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, kDeepest> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    if (lower_bound(node, p) > limit) continue;
    for (std::uint32_t s = node.first; s < node.first + node.count; ++s) slots.push_back(s);
    if (node.count > 0) continue;
    stack[depth++] = node.first + 1;
    stack[depth++] = node.first;
  }
}

std::size_t SweepIndex::memory_bytes() const {
  return moves_.capacity() * sizeof(SweptMove) + nodes_.capacity() * sizeof(Node);
}

}  // namespace limitgauge::simulator
