#include "tests/simulator/turning/turning_bench.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::simulator::test {

using model::Vec3;

Vec3 TurnedMove::axis(double t) const {
  const double angle = std::atan2(length(cross(axis_from, axis_to)), dot(axis_from, axis_to));
  if (angle < 1e-9) return model::normalized(axis_from * (1 - t) + axis_to * t);
  return (axis_from * std::sin((1 - t) * angle) + axis_to * std::sin(t * angle)) / std::sin(angle);
}

double distance_at(const ProfileOracle& oracle, const TurnedMove& m, const Vec3& p, double t) {
  const Vec3 w = p - (m.from * (1 - t) + m.to * t), axis = m.axis(t);
  return oracle.signed_distance(length(cross(w, axis)), dot(w, axis));
}

double brute_turning_distance(const ProfileOracle& oracle, const TurnedMove& m, const Vec3& p,
                              int steps) {
  std::vector<double> at(static_cast<std::size_t>(steps) + 1);
  for (int k = 0; k <= steps; ++k)
    at[static_cast<std::size_t>(k)] = distance_at(oracle, m, p, static_cast<double>(k) / steps);
  double least = *std::min_element(at.begin(), at.end());
  const double golden = (std::sqrt(5.0) - 1) / 2;
  for (std::size_t k = 0; k < at.size(); ++k) {
    if ((k > 0 && at[k - 1] < at[k]) || (k + 1 < at.size() && at[k + 1] < at[k])) continue;
    double a = std::max(0.0, (static_cast<double>(k) - 1) / steps),
           b = std::min(1.0, (static_cast<double>(k) + 1) / steps);
    for (int i = 0; i < 60; ++i) {
      const double s = b - golden * (b - a), t = a + golden * (b - a);
      (distance_at(oracle, m, p, s) < distance_at(oracle, m, p, t) ? b : a) =
          distance_at(oracle, m, p, s) < distance_at(oracle, m, p, t) ? t : s;
    }
    least = std::min(least, distance_at(oracle, m, p, (a + b) / 2));
  }
  return least;
}

Vec3 TurningDraw::direction() {
  for (;;)
    if (const Vec3 v = within(1); length(v) > 0.1 && length(v) < 1) return model::normalized(v);
}

TurnedMove TurningDraw::move() {
  TurnedMove m{within(5), {}, direction(), {}};
  m.to = m.from + within(std::pow(10, between(-4, 0.7)));
  const Vec3 side = model::normalized(cross(m.axis_from, direction()));
  const double turn = between(0, 1) < 0.1 ? std::acos(0.0) : std::pow(10, between(-5, 0.19));
  m.axis_to = m.axis_from * std::cos(turn) + side * std::sin(turn);
  if (between(0, 1) < 0.1) m.axis_to = m.axis_from;
  if (between(0, 1) < 0.1) m.to = m.from;
  return m;
}

Vec3 TurningDraw::place(const TurnedMove& m, double around) {
  const double t = between(0, 1);
  return m.from * (1 - t) + m.to * t + m.axis(t) * between(-3, 12) + within(around);
}

const std::vector<model::Cutter>& turning_cutters() {
  static const std::vector<model::Cutter> all = [] {
    std::vector<model::Cutter> out;
    for (const char* text :
         {"ball:D=6,L=20", "bull:D=10,r=2,L=20", "flat:D=8,L=15", "taper:D=3,r=1,angle=10,L=12",
          "drill:D=6,angle=118,L=20", "ball:D=6,L=4", "apt:D=10,r=2,b=-10,L=9"})
      out.push_back(model::parse_cutter(text));
    return out;
  }();
  return all;
}

model::BoxStock turning_block() {
  return {{-12, -9, -10}, {24, 18, 10}};
}

model::Pass with_axes(const model::Cutter& cutter, const std::vector<TurnedMove>& chain) {
  model::Toolpath path;
  model::ToolAxes axes;
  path.start = chain.front().from, axes.start = chain.front().axis_from;
  const auto add = [&](const Vec3& to, const Vec3& axis) {
    path.moves.push_back(
        {to, 1000, static_cast<std::uint32_t>(path.moves.size() + 1), model::MoveKind::feed});
    axes.to.push_back(model::normalized(axis));
  };
  for (const TurnedMove& m : chain) add(m.to, m.axis_to);
  return {cutter,
          std::make_shared<const model::Toolpath>(std::move(path)),
          {},
          false,
          std::make_shared<const model::ToolAxes>(std::move(axes))};
}

model::Pass turning_pass(const model::Cutter& cutter, unsigned seed, int moves) {
  TurningDraw draw(seed);
  std::vector<TurnedMove> chain;
  TurnedMove m;
  m.to = {draw.between(-10, 10), draw.between(-8, 8), 2};
  for (int i = 0; i < moves; ++i) {
    m.from = m.to, m.axis_from = m.axis_to;
    const double way = i % 3 == 0 ? 4 : 0.5, turn = i % 5 == 0 ? 0.8 : 0.1;
    if (i % 7 != 6) m.to = m.from + draw.within(way);
    m.to = {std::clamp(m.to.x, -11.0, 11.0), std::clamp(m.to.y, -8.0, 8.0),
            std::clamp(m.to.z, -5.0, 2.0)};
    if (i % 7 != 5) m.axis_to = model::normalized(m.axis_from + draw.within(turn));
    if (m.axis_to.z < 0.75) m.axis_to = model::normalized(m.axis_to + Vec3{0, 0, 1});
    chain.push_back(m);
  }
  return with_axes(cutter, chain);
}

std::vector<TurnedMove> turned_moves(const model::Pass& pass) {
  std::vector<TurnedMove> all;
  for (std::size_t i = 0; i < pass.path->moves.size(); ++i)
    all.push_back({move_from(*pass.path, i), pass.path->moves[i].to, axis_from(*pass.axes, i),
                   pass.axes->to[i]});
  return all;
}

}  // namespace limitgauge::simulator::test
