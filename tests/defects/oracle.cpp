#include "tests/defects/oracle.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;
using verifier::SurfaceSample;

constexpr double kNowhere = -std::numeric_limits<double>::infinity();
/// Clearances that count as free for sure, and that may: around the 1e-4 mm of CERTIFICATE.md.
constexpr double kSureContact_mm = 5e-5, kMaybeContact_mm = 2e-4;
constexpr double kFinest_mm = 1e-5, kFinestReached_mm = 1e-4;
constexpr std::size_t kGougeStarts = 16, kUncutStarts = 5;
constexpr double kStartsApart_mm = 0.25;
constexpr int kDirectionsOut = 64;
constexpr std::size_t kUnionPlaces = 5;
/// δ changes by no more than the way gone, but for rounding.
constexpr double kSlack_mm = 1e-9;

simulator::Pass pass_of(const model::Cutter& cutter, const model::Toolpath& path) {
  return {cutter, std::make_shared<const model::Toolpath>(path)};
}

/// Places of the largest values, some way apart, at most `most`, among those that are accepted.
template <class Accept>
std::vector<std::size_t> spread_starts(const std::vector<SampledSurface::Node>& nodes,
                                       const std::vector<double>& value, std::size_t most,
                                       Accept&& accept) {
  std::vector<std::size_t> order(nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return value[a] > value[b]; });
  std::vector<std::size_t> out;
  for (const std::size_t k : order) {
    if (out.size() == most || value[k] <= 0) break;
    const bool near = std::any_of(out.begin(), out.end(), [&](std::size_t o) {
      return nodes[o].place.patch == nodes[k].place.patch &&
             distance(nodes[o].point, nodes[k].point) < kStartsApart_mm;
    });
    if (!near && accept(k)) out.push_back(k);
  }
  return out;
}

Vec3 fibonacci(int k, int count) {
  const double z = 1 - (2 * k + 1.0) / count, around = 2 * std::numbers::pi * k / std::numbers::phi;
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(around), r * std::sin(around), z};
}

}  // namespace

ReachOracle::ReachOracle(const SampledSurface& surface, const model::Cutter& cutter,
                         double allowance_mm)
    : surface_(surface),
      allowance_(allowance_mm),
      flat_(Nose(cutter, 0).flat()),
      rounding_(Nose(cutter, 0).corner()),
      wall_sine_(Nose(cutter, 0).wall_sine()),
      surely_(cutter, allowance_mm - kSureContact_mm),
      maybe_(cutter, allowance_mm - kMaybeContact_mm),
      nodes_(surface.nodes().size()) {}

Reach ReachOracle::with_tip(const Vec3& tip) const {
  const auto sure = surface_.drop(surely_, tip.x, tip.y);
  if (!sure || sure->tip_z <= tip.z) return Reach::sure;
  const auto maybe = surface_.drop(maybe_, tip.x, tip.y);
  return !maybe || maybe->tip_z <= tip.z ? Reach::maybe : Reach::no;
}

Reach ReachOracle::at(const Vec3& point, const Vec3& normal) const {
  constexpr double kLevel = 1e-9, kSteep = 1e-6;
  constexpr int kTurns = 16;
  if (normal.z < wall_sine_ - kSteep) return Reach::no;
  const Vec3 core = point + normal * (rounding_ + allowance_) - Vec3{0, 0, rounding_};
  const double level = std::hypot(normal.x, normal.y);
  Reach best = Reach::no;
  if (flat_ == 0 || level > kLevel) {
    const double out = flat_ == 0 ? 0 : flat_ / level;
    best = with_tip(core + Vec3{normal.x * out, normal.y * out, 0});
  } else {
    for (int k = -1; k < kTurns && best != Reach::sure; ++k) {
      const double angle = 2 * std::numbers::pi * k / kTurns, out = k < 0 ? 0 : flat_;
      best = std::max(best, with_tip(core + Vec3{out * std::cos(angle), out * std::sin(angle), 0}));
    }
  }
  return normal.z < wall_sine_ + kSteep ? std::min(best, Reach::maybe) : best;
}

Reach ReachOracle::of_node(std::size_t node) {
  auto& known = nodes_[node];
  if (!known) known = at(surface_.nodes()[node].point, surface_.nodes()[node].normal);
  return *known;
}

DeviationOracle::DeviationOracle(const SampledSurface& surface, const model::BoxStock& stock,
                                 const model::Cutter& cutter, const model::Toolpath& path)
    : surface_(surface), stock_(stock), cutter_(cutter), index_(pass_of(cutter, path)) {
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    moves_.emplace_back(model::move_from(path, i), path.moves[i].to, static_cast<std::uint32_t>(i));
  at_nodes_.reserve(surface.nodes().size());
  double last = std::numeric_limits<double>::infinity();
  Vec3 from;
  for (const auto& node : surface.nodes()) {
    last = delta(node.point, last + distance(from, node.point));
    from = node.point;
    at_nodes_.push_back(static_cast<float>(last));
  }
}

double DeviationOracle::delta(const Vec3& p, double at_most) const {
  double least = at_most + kSlack_mm;
  for (int axis = 0; axis < 3; ++axis)
    least = std::min({least, p[axis] - stock_.corner_mm[axis],
                      stock_.corner_mm[axis] + stock_.size_mm[axis] - p[axis]});
  const auto nearest = index_.nearest(p, least);
  return nearest ? nearest->at.distance : least;
}

simulator::SweptSample DeviationOracle::of_move(std::size_t move, const Vec3& p) const {
  return swept_distance(index_.profile(), moves_[move], p);
}

Extreme DeviationOracle::deepest(double allowance_mm, const std::vector<Place>& hints) const {
  const auto& nodes = surface_.nodes();
  std::vector<double> value(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k)
    // Troughs narrower than the samples are apart begin above S.
    value[k] = allowance_mm - at_nodes_[k] + 1;
  std::vector<Place> starts = hints;
  for (const std::size_t k :
       spread_starts(nodes, value, kGougeStarts, [](std::size_t) { return true; }))
    starts.push_back(nodes[k].place);
  Extreme best{0, {}};
  for (const Place& start : starts) {
    double found = 0, last = std::numeric_limits<double>::infinity();
    Vec3 from;
    const Place place = surface_.climb(
        start,
        [&](const Place&, const SurfaceSample& s) {
          last = delta(s.position, last + distance(from, s.position));
          from = s.position;
          return allowance_mm - last;
        },
        kFinest_mm, found);
    if (found > best.depth_mm) best = {found, place};
  }
  return best;
}

Extreme DeviationOracle::highest(double allowance_mm, ReachOracle& reach, Reach least,
                                 const std::vector<Place>& hints) const {
  const auto& nodes = surface_.nodes();
  std::vector<double> value(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) value[k] = at_nodes_[k] - allowance_mm;
  std::vector<Place> starts = hints;
  for (const std::size_t k : spread_starts(nodes, value, kUncutStarts, [&](std::size_t node) {
         return reach.of_node(node) >= least;
       }))
    starts.push_back(nodes[k].place);
  Extreme best{0, {}};
  for (const Place& start : starts) {
    double found = 0;
    double reached = kNowhere;
    const Place place = surface_.climb(
        start,
        [&](const Place&, const SurfaceSample& s) {
          const double here = delta(s.position) - allowance_mm;
          // Only a step upwards is worth the question whether it can be reached.
          if (here <= reached || reach.at(s.position, s.normal) < least) return kNowhere;
          return reached = here;
        },
        kFinestReached_mm, found);
    if (found > best.depth_mm) best = {found, place};
  }
  return best;
}

double DeviationOracle::height(double allowance_mm, const Extreme& highest) const {
  const verifier::SurfaceSample s = surface_.at(highest.place);
  constexpr double kOn_mm = 1e-7;
  double t = 0;
  // Steps of δ never pass the surface of what was removed.
  for (double left = delta(s.position); left > kOn_mm; left = delta(s.position + s.normal * t))
    t += left;
  return std::max(highest.depth_mm, t - allowance_mm);
}

double DeviationOracle::way_out(const Vec3& p, const Vec3& direction, double shorter_than) const {
  constexpr double kOn_mm = 1e-7;
  double inside = 0;
  for (double t = 0; t < shorter_than; t += inside) {
    // As far as the last step went, δ has risen at the most: to nothing.
    inside = -delta(p + direction * t, kOn_mm);
    if (inside <= kOn_mm) return t;
  }
  return shorter_than;
}

double DeviationOracle::depth_in_union(const Vec3& p) const {
  double shortest = std::numeric_limits<double>::infinity();
  Vec3 best;
  const auto probe = [&](const Vec3& direction) {
    const double t = way_out(p, direction, shortest);
    if (t < shortest) shortest = t, best = direction;
  };
  probe({0, 0, -1});
  for (int k = 0; k < kDirectionsOut; ++k) probe(fibonacci(k, kDirectionsOut));
  for (double cone = 0.2; cone > 1e-4; cone /= 2) {
    const Vec3 axis = best;
    const Vec3 side =
        normalized(cross(axis, std::abs(axis.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
    const Vec3 other = cross(axis, side);
    for (int k = 0; k < 6; ++k)
      probe(normalized(axis + (side * std::cos(k * std::numbers::pi / 3) +
                               other * std::sin(k * std::numbers::pi / 3)) *
                                  cone));
  }
  return shortest;
}

double DeviationOracle::deepest_in_union(double allowance_mm, const Extreme& deepest) const {
  const auto& nodes = surface_.nodes();
  std::vector<double> value(nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) value[k] = -at_nodes_[k];
  double depth = deepest.depth_mm;
  const Vec3 worst = surface_.at(deepest.place).position;
  if (delta(worst) < 0) depth = std::max(depth, allowance_mm + depth_in_union(worst));
  for (const std::size_t k :
       spread_starts(nodes, value, kUnionPlaces, [](std::size_t) { return true; }))
    depth = std::max(depth, allowance_mm + depth_in_union(nodes[k].point));
  return depth;
}

}  // namespace limitgauge::tests::defects
