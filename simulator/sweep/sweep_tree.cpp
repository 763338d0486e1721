#include "simulator/sweep/sweep_tree.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "model/base/chunks.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr std::size_t kChunk = 1 << 14;
// A median split halves 2^32 moves in fewer levels than this, with one node waiting a level.
constexpr std::size_t kDeepest = 64;

SweptMove swept_move(const model::Toolpath& path, std::uint32_t i) {
  return {move_from(path, i), path.moves[i].to, i};
}

}  // namespace

void require_path(const Pass& pass) {
  if (!pass.path) throw std::invalid_argument("a pass without a path");
  const model::Toolpath& path = *pass.path;
  if (path.moves.size() >= std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument("a path of 2^32 moves or more");
  const bool finite =
      is_finite(path.start) && std::all_of(path.moves.begin(), path.moves.end(),
                                           [](const model::Move& m) { return is_finite(m.to); });
  if (!finite) throw std::invalid_argument("a path with a coordinate that is not finite");
  if (pass.axes) model::require_axes(path, *pass.axes);
}

SweepTree::SweepTree(const Pass& pass, const model::RunControl& control) : profile_(pass.cutter) {
  require_path(pass);
  if (!pass.axes) {
    build(*pass.path, {}, order_moves(*pass.path, control), control);
    return;
  }
  const TurningParts parts(pass);
  const SweepOrder order = order_moves(parts.path, control);
  build(parts.path, parts.of_move, order, control);
  add_turning(parts, order, control);
}

// Parts of a move keep its place in the path, and are found by it.
void SweepTree::build(const model::Toolpath& path, std::span<const std::uint32_t> of_move,
                      const SweepOrder& order, const model::RunControl& control) {
  moves_.resize(order.moves.size());
  model::parallel_chunks(moves_.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s) {
      moves_[s] = swept_move(path, order.moves[s]);
      if (!of_move.empty()) moves_[s].index = of_move[order.moves[s]];
    }
  });
  nodes_.resize(order.nodes.size());
  model::parallel_chunks(nodes_.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) set_leaf(nodes_[n], order.nodes[n]);
  });
  for (std::size_t n = nodes_.size(); n-- > 0;) add_children(nodes_[n]);
}

void SweepTree::add_turning(const TurningParts& parts, const SweepOrder& order,
                            const model::RunControl& control) {
  turns_.emplace(parts, profile_, order.moves, control);
  turning_nodes_.resize(nodes_.size());
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    const Node& node = nodes_[n];
    turning_nodes_[n] = node.count > 0 ? turns_->leaf(node.first, node.count)
                                       : TurningMoves::both(turning_nodes_[node.first],
                                                            turning_nodes_[node.first + 1]);
  }
}

void SweepTree::set_leaf(Node& node, const SweepOrder::Node& from) const {
  node.first = from.first;
  node.count = from.count;
  if (node.count > 0) node.least_index = moves_[node.first].index;
  for (std::uint32_t s = node.first; s < node.first + node.count; ++s) {
    node.tips.add(tip_box(moves_[s]));
    node.least_index = std::min(node.least_index, moves_[s].index);
  }
}

// Children lie behind their parents: from the back, both are there before they are needed.
void SweepTree::add_children(Node& node) const {
  if (node.count > 0) return;
  const Node &a = nodes_[node.first], &b = nodes_[node.first + 1];
  node.tips.add(a.tips);
  node.tips.add(b.tips);
  node.least_index = std::min(a.least_index, b.least_index);
}

double SweepTree::lower_bound(const Node& node, const Vec3& p) const {
  if (turns_)
    return turns_->lower_bound(profile_,
                               turning_nodes_[static_cast<std::size_t>(&node - nodes_.data())], p);
  const double dx = std::max({node.tips.low.x - p.x, 0.0, p.x - node.tips.high.x});
  const double dy = std::max({node.tips.low.y - p.y, 0.0, p.y - node.tips.high.y});
  return profile_.lower_bound(std::sqrt(dx * dx + dy * dy), p.z - node.tips.high.z,
                              p.z - node.tips.low.z);
}

std::optional<NearestMove> SweepTree::nearest(const Vec3& p, double bound,
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
      if (cannot_be_below(s, p, bound)) continue;
      const SweptSample d = distance_below(s, p, bound);
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

std::optional<std::uint32_t> SweepTree::first_below(const Vec3& p, double bound) const {
  if (nodes_.empty()) return std::nullopt;
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t first = kNone;
  std::array<std::uint32_t, kDeepest> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    if (node.least_index >= first || lower_bound(node, p) >= bound) continue;
    for (std::uint32_t s = node.first; s < node.first + node.count; ++s)
      if (moves_[s].index < first && !cannot_be_below(s, p, bound) &&
          distance_below(s, p, bound).distance < bound)
        first = moves_[s].index;
    if (node.count > 0) continue;
    // The child of earlier moves first.
    const bool earlier = nodes_[node.first].least_index <= nodes_[node.first + 1].least_index;
    stack[depth++] = node.first + (earlier ? 1 : 0);
    stack[depth++] = node.first + (earlier ? 0 : 1);
  }
  return first == kNone ? std::nullopt : std::optional(first);
}

template <class Skip>
void SweepTree::gather_unless(const Skip& skip, std::vector<std::uint32_t>& slots) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, kDeepest> stack;
  std::size_t depth = 0;
  stack[depth++] = 0;
  while (depth > 0) {
    const Node& node = nodes_[stack[--depth]];
    if (skip(node)) continue;
    for (std::uint32_t s = node.first; s < node.first + node.count; ++s) slots.push_back(s);
    if (node.count > 0) continue;
    stack[depth++] = node.first + 1;
    stack[depth++] = node.first;
  }
}

void SweepTree::gather(const Vec3& p, double limit, std::vector<std::uint32_t>& slots) const {
  gather_unless([&](const Node& node) { return lower_bound(node, p) > limit; }, slots);
}

// All that a node's balls reach lies in the box of their centres' ways and above it, grown by the
// radius: that is convex too, and its foot may slide by |δ|² <= 3h².
void SweepTree::gather_rivals(const NearestCapsule& n, std::vector<std::uint32_t>& slots) const {
  const Vec3 &p = n.middle, &q = n.from_foot;
  const double h = n.half_edge, radius = profile_.corner_radius();
  const double limit = dot(q, q) + 3 * h * h + kDistanceRounding_mm * (1 + 2 * length(q));
  const auto lost = [&](const Node& node) {
    const double x = p.x - std::clamp(p.x, node.tips.low.x, node.tips.high.x);
    const double y = p.y - std::clamp(p.y, node.tips.low.y, node.tips.high.y);
    const double z = std::min(0.0, p.z - (node.tips.low.z + radius));
    const double apart = std::abs(x - q.x) + std::abs(y - q.y) + std::abs(z - q.z);
    return x * x + y * y + z * z - 2 * h * apart > limit;
  };
  gather_unless(lost, slots);
}

// What is said of balls' tops is said of upright ones.
double SweepTree::below_tops_mm() const {
  if (turns_) return -std::numeric_limits<double>::infinity();
  const double lowest = nodes_.empty() ? 0.0 : nodes_[0].tips.low.z;
  return lowest + profile_.length() - profile_.corner_radius();
}

std::size_t SweepTree::memory_bytes() const {
  return moves_.capacity() * sizeof(SweptMove) + nodes_.capacity() * sizeof(Node) +
         (turns_ ? turns_->memory_bytes() : 0) +
         turning_nodes_.capacity() * sizeof(TurningMoves::Node);
}

SweptSample SweepTree::distance_below(std::uint32_t slot, const Vec3& p, double bound,
                                      double within_mm) const {
  if (!turns_) return swept_distance(profile_, moves_[slot], p);
  const auto found = turning_distance(profile_, turns_->move(slot), p, bound, within_mm);
  return found.value_or(SweptSample{std::numeric_limits<double>::infinity(), {}, 0});
}

double SweepTree::curvature_bound(std::uint32_t slot, const Vec3& p, const SweptSample& at,
                                  double reach) const {
  return turns_ ? simulator::curvature_bound(profile_, turns_->move(slot), p, at, reach)
                : simulator::curvature_bound(profile_, moves_[slot], p, at, reach);
}

double SweepTree::outside_bound(std::uint32_t slot, const Vec3& p, const SweptSample& at,
                                const Vec3& half) const {
  return turns_ ? simulator::outside_bound(profile_, turns_->move(slot), p, at, half)
                : simulator::outside_bound(profile_, moves_[slot], p, at, half);
}

}  // namespace limitgauge::simulator
