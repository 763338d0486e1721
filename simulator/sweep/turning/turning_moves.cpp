#include "simulator/sweep/turning/turning_moves.h"

#include <algorithm>
#include <cmath>

#include "model/base/chunks.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr std::size_t kTurnsAtOnce = 1 << 12;
constexpr double kAnyAxis_rad = 3.1416;

double reach_along(const Vec3& half, const Vec3& v) {
  return half.x * std::abs(v.x) + half.y * std::abs(v.y) + half.z * std::abs(v.z);
}

/// What a plane under a move may cost, mm, and the turn that it may have: beyond, a move is cut.
constexpr double kMostSag_mm = 0.01, kMostTurn_rad = 0.03;
constexpr double kMostParts = 256;

int parts_of(const Vec3& from, const Vec3& to, const Vec3& axis_from, const Vec3& axis_to) {
  const double turn = model::angle_between(axis_from, axis_to);
  const double sag = turn * distance(from, to);
  const double parts = std::max(turn / kMostTurn_rad, std::sqrt(sag / kMostSag_mm));
  return static_cast<int>(std::ceil(std::clamp(parts, 1.0, kMostParts)));
}

/// The core keeps to its chord but for an eighth of its bend.
model::Box3 core_box(const TurningMove& m) {
  model::Box3 box;
  box.add(m.core(0)), box.add(m.core(1));
  return box.grown(m.turn_rad * m.turn_rad * std::abs(m.core_mm) / 8);
}

}  // namespace

TurningParts::TurningParts(const model::Pass& pass) {
  const model::Toolpath& all = *pass.path;
  path.start = all.start, axes.start = pass.axes->start;
  for (std::uint32_t i = 0; i < all.moves.size(); ++i) {
    const Vec3 &from = move_from(all, i), &to = all.moves[i].to;
    const Vec3 &axis = axis_from(*pass.axes, i), &last = pass.axes->to[i];
    const int parts = parts_of(from, to, axis, last);
    const TurningMove move(from, to, axis, last, 0);
    for (int k = 1; k <= parts; ++k) {
      const double t = static_cast<double>(k) / parts;
      path.moves.push_back(all.moves[i]);
      path.moves.back().to = k < parts ? move.tip(t) : to;
      axes.to.push_back(k < parts ? move.up(t) : last);
      of_move.push_back(i);
    }
  }
}

TurningMoves::TurningMoves(const TurningParts& parts, const CutterProfile& profile,
                           std::span<const std::uint32_t> order, const model::RunControl& control)
    : moves_(order.size()),
      core_mm_(profile.core_height()),
      size_mm_(
          std::hypot(profile.largest_radius(), std::max(core_mm_, profile.length() - core_mm_))) {
  const model::Toolpath& path = parts.path;
  const model::ToolAxes& axes = parts.axes;
  model::parallel_chunks(order.size(), kTurnsAtOnce, control, [&](std::size_t a, std::size_t b) {
    for (std::size_t s = a; s < b; ++s) {
      const std::uint32_t i = order[s];
      moves_[s] = {move_from(path, i), path.moves[i].to, axis_from(axes, i), axes.to[i], core_mm_};
    }
  });
}

TurningMoves::Node TurningMoves::leaf(std::uint32_t first, std::uint32_t count) const {
  Node node;
  for (std::uint32_t s = first; s < first + count; ++s) {
    const TurningMove& m = moves_[s];
    const Node own{core_box(m), m.up(0.5), m.turn_rad / 2};
    node = s == first ? own : both(node, own);
  }
  return node;
}

TurningMoves::Node TurningMoves::both(const Node& a, const Node& b) {
  Node node{a.cores, a.axis, kAnyAxis_rad};
  node.cores.add(b.cores);
  const Vec3 sum = a.axis + b.axis;
  if (length(sum) < 1e-3) return node;
  node.axis = model::normalized(sum);
  node.cone_rad =
      std::min(kAnyAxis_rad, std::max(model::angle_between(node.axis, a.axis) + a.cone_rad,
                                      model::angle_between(node.axis, b.axis) + b.cone_rad));
  return node;
}

double TurningMoves::lower_bound(const CutterProfile& profile, const Node& node,
                                 const Vec3& p) const {
  const Vec3 half = (node.cores.high - node.cores.low) * 0.5, w = p - node.cores.centre();
  const double height = core_mm_ + dot(w, node.axis), up = reach_along(half, node.axis);
  const Vec3 out = w - node.axis * dot(w, node.axis);
  const double away = length(out);
  const double rho = away > 0 ? std::max(0.0, away - reach_along(half, out / away)) : 0.0;
  const double far = length(w) + length(half);
  const double leaning = profile.lower_bound(rho, height - up, height + up) - node.cone_rad * far;
  const Vec3 beyond{std::max(0.0, std::abs(w.x) - half.x), std::max(0.0, std::abs(w.y) - half.y),
                    std::max(0.0, std::abs(w.z) - half.z)};
  return std::max(leaning, length(beyond) - size_mm_);
}

}  // namespace limitgauge::simulator
