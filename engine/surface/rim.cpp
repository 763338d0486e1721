#include "engine/surface/rim.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "engine/tolerance.h"

namespace limitgauge::engine::surface {
namespace {

/// A turn of the rim between chords above which a ball fills the wedge between two tubes, rad.
constexpr double kSharpTurn = 0.3;

/// One cage edge of the rim: from vertex to vertex, as points.
struct RimEdge {
  Index from = 0, to = 0;
  std::vector<Vec3> points;
  bool used = false;
};

std::vector<RimEdge> rim_edges(const OffsetSampler& sampler) {
  std::vector<RimEdge> edges;
  const PatchModel& model = sampler.model();
  const OuterMesh& outer = model.outer();
  for (Index h = 0; h < outer.half_edge_count(); ++h) {
    if (!model.has_patch(h)) continue;
    const bool border = model.ends_at(h);
    if (!border && !(model.creased_at(h) && h < outer.twin[h])) continue;
    edges.push_back({outer.origin[h], outer.target(h),
                     sampler.side(model.patch_at(h), model.side_at(h), 0), false});
  }
  return edges;
}

double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
  return angle_between(b - a, c - b);
}

/// Joins rim edges end to end where exactly two meet.
class LineBuilder {
 public:
  explicit LineBuilder(std::vector<RimEdge> edges) : edges_(std::move(edges)) {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      at_[edges_[e].from].push_back(e);
      at_[edges_[e].to].push_back(e);
    }
  }

  std::vector<std::vector<Vec3>> lines() {
    std::vector<std::vector<Vec3>> found;
    for (const bool loops : {false, true})
      for (std::size_t e = 0; e < edges_.size(); ++e) {
        if (edges_[e].used) continue;
        if (loops || at_[edges_[e].from].size() != 2)
          found.push_back(line_from(e, edges_[e].from));
        else if (at_[edges_[e].to].size() != 2)
          found.push_back(line_from(e, edges_[e].to));
      }
    return found;
  }

 private:
  std::vector<Vec3> line_from(std::size_t e, Index vertex) {
    std::vector<Vec3> line;
    for (;;) {
      RimEdge& edge = edges_[e];
      edge.used = true;
      if (edge.from != vertex) std::reverse(edge.points.begin(), edge.points.end());
      vertex = edge.from != vertex ? edge.from : edge.to;
      line.insert(line.end(), edge.points.begin() + (line.empty() ? 0 : 1), edge.points.end());
      const auto& here = at_[vertex];
      if (here.size() != 2) return line;
      const std::size_t next = here[0] == e ? here[1] : here[0];
      if (edges_[next].used) return line;
      e = next;
    }
  }

  std::vector<RimEdge> edges_;
  std::map<Index, std::vector<std::size_t>> at_;
};

void add_cones(const PatchModel& model, std::vector<Vec3>& points) {
  const OuterMesh& outer = model.outer();
  for (Index h = 0; h < outer.half_edge_count(); ++h) {
    const Index v = outer.origin[h];
    if (!model.has_patch(h) || !is_infinite(outer.vertex_sharpness[v])) continue;
    const LimitPatch& limit = model.patches()[model.patch_at(h)].limit;
    points.push_back(limit.points[limit.side_index(model.side_at(h), 0)]);
  }
}

/// Whether the tube's upper half swings round between two points: its line passes the vertical.
bool swings(const Vec3& a, const Vec3& b, const Vec3& c) {
  return angle_between(Vec3{b.x - a.x, b.y - a.y, 0}, Vec3{c.x - b.x, c.y - b.y, 0}) > kSharpTurn;
}

bool same_place(const Vec3& a, const Vec3& b) {
  return distance(a, b) <= kSamePlace_mm;
}

bool smooth_loop(const std::vector<Vec3>& line) {
  return line.size() > 3 && same_place(line.front(), line.back()) &&
         turn(line[line.size() - 2], line[0], line[1]) <= kSharpTurn &&
         !swings(line[line.size() - 2], line[0], line[1]);
}

Vec3 direction_at(const std::vector<Vec3>& line, std::size_t i) {
  const std::size_t last = line.size() - 1;
  const bool loop = smooth_loop(line);
  const Vec3 before = i > 0 ? line[i - 1] : loop ? line[last - 1] : line[0];
  const Vec3 after = i < last ? line[i + 1] : loop ? line[1] : line[last];
  return normalized(after - before);
}

/// Pieces between sharp turns, so that a ring never stands askew to both its chords.
std::vector<std::vector<Vec3>> smooth_pieces(const std::vector<Vec3>& line) {
  std::vector<std::vector<Vec3>> pieces = {{line.front()}};
  for (std::size_t i = 1; i < line.size(); ++i) {
    pieces.back().push_back(line[i]);
    const bool inner = i + 1 < line.size();
    if (inner && (turn(line[i - 1], line[i], line[i + 1]) > kSharpTurn ||
                  swings(line[i - 1], line[i], line[i + 1])))
      pieces.push_back({line[i]});
  }
  return pieces;
}

/// Steps over half a turn that keep the facets' sagitta within `error_mm`.
int half_turn_steps(double radius_mm, double error_mm) {
  const double half = std::acos(1 / (1 + error_mm / radius_mm));
  return std::max(8, static_cast<int>(std::ceil(std::numbers::pi / (2 * half))));
}

/// Steps over half a turn, and over the quarter from the rim of a ball's upper half to its top.
struct BallSteps {
  int half_turn = 0, quarter = 0;
};
BallSteps ball_steps(double radius_mm, double error_mm) {
  const int half_turn = half_turn_steps(radius_mm, error_mm / 2);
  return {half_turn, (half_turn + 1) / 2};
}

}  // namespace

Rim find_rim(const OffsetSampler& sampler) {
  Rim rim;
  add_cones(sampler.model(), rim.points);
  for (const ModelPatch& patch : sampler.model().patches())
    rim.points.insert(rim.points.end(), patch.specks.begin(), patch.specks.end());
  for (const std::vector<Vec3>& line : LineBuilder(rim_edges(sampler)).lines())
    for (std::vector<Vec3>& piece : smooth_pieces(line)) {
      if (!smooth_loop(piece)) rim.points.insert(rim.points.end(), {piece.front(), piece.back()});
      rim.lines.push_back(std::move(piece));
    }
  const auto less = [](const Vec3& a, const Vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::sort(rim.points.begin(), rim.points.end(), less);
  rim.points.erase(std::unique(rim.points.begin(), rim.points.end()), rim.points.end());
  return rim;
}

std::size_t rolling_tube_points(std::size_t line_points, double radius_mm, double error_mm) {
  return (static_cast<std::size_t>(half_turn_steps(radius_mm, error_mm)) + 1) * line_points;
}

Grid rolling_tube(const std::vector<Vec3>& line, double radius_mm, double error_mm) {
  const int steps = half_turn_steps(radius_mm, error_mm);
  Grid grid{steps + 1, static_cast<int>(line.size()), {}};
  grid.points.reserve(rolling_tube_points(line.size(), radius_mm, error_mm));
  const double half_step = std::numbers::pi / (2 * steps);
  Vec3 level{1, 0, 0};
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec3 along = direction_at(line, i);
    const Vec3 flat = cross(along, Vec3{0, 0, 1});
    // A vertical piece has no upper half: its top end is a rim point or its neighbours' ring.
    if (length_squared(flat) > 0) level = normalized(flat);
    const Vec3 up = normalized(cross(level, along));
    double bend = 0;
    if (i > 0 && i + 1 < line.size())
      bend = std::min(kSharpTurn, turn(line[i - 1], line[i], line[i + 1]));
    const double r = radius_mm / (std::cos(half_step) * std::cos(bend / 2));
    for (int k = 0; k <= steps; ++k) {
      const double angle = std::numbers::pi * k / steps;
      grid.points.push_back(line[i] + (level * std::cos(angle) + up * std::sin(angle)) * r);
    }
  }
  return grid;
}

std::size_t rolling_ball_points(double radius_mm, double error_mm) {
  const BallSteps steps = ball_steps(radius_mm, error_mm);
  return (2 * static_cast<std::size_t>(steps.half_turn) + 1) *
         (static_cast<std::size_t>(steps.quarter) + 1);
}

Grid rolling_ball(const Vec3& point, double radius_mm, double error_mm) {
  const auto [steps, quarter] = ball_steps(radius_mm, error_mm);
  const double around = std::numbers::pi / steps, rise = std::numbers::pi / 2 / quarter;
  const double r = radius_mm / (std::cos(around / 2) * std::cos(rise / 2));
  Grid grid{2 * steps + 1, quarter + 1, {}};
  grid.points.reserve(rolling_ball_points(radius_mm, error_mm));
  for (int v = 0; v <= quarter; ++v)
    for (int u = 0; u <= 2 * steps; ++u) {
      const double a = u % (2 * steps) * around, b = v * rise;
      grid.points.push_back(
          point + Vec3{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)} * r);
    }
  return grid;
}

}  // namespace limitgauge::engine::surface
