#include "verifier/cells/ridge_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "verifier/cells/normal_cone.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

template <std::size_t n>
using Curve = std::array<Vec3, n>;

/// De Casteljau at t: the coefficients of the part before it, or after it.
template <std::size_t n>
Curve<n> part_before(Curve<n> c, double t) {
  Curve<n> out{};
  for (std::size_t k = 0; k < n; ++k) {
    out[k] = c[0];
    for (std::size_t i = 0; i + 1 < n - k; ++i) c[i] = c[i] + (c[i + 1] - c[i]) * t;
  }
  return out;
}
template <std::size_t n>
Curve<n> reversed(Curve<n> c) {
  std::reverse(c.begin(), c.end());
  return c;
}
template <std::size_t n>
Curve<n> between(const Curve<n>& c, double t0, double t1) {
  const Curve<n> head = t1 < 1 ? part_before(c, t1) : c;
  return t0 > 0 ? reversed(part_before(reversed(head), 1 - t0 / t1)) : head;
}
template <std::size_t n>
Vec3 at_middle(const Curve<n>& c) {
  return part_before(c, 0.5)[n - 1];
}

/// A piece of one side of a sharp edge, `from` < `to` along the edge.
struct Strip {
  double from = 0, to = 1;
  Curve<4> points{};
  Curve<6> normals{};
  int patch = 0;
  double u0 = 0, v0 = 0, u1 = 0, v1 = 0;
};

/// Index steps of the control points, or coefficients, along a side of a square of n by n.
struct Along {
  int first = 0, step = 0;
};
Along along_side(int side, int n) {
  switch (side) {
    case 0:
      return {0, 1};
    case 1:
      return {n - 1, n};
    case 2:
      return {n * n - 1, -1};
    default:
      return {n * (n - 1), -n};
  }
}

/// Where the square lies along a side of its patch, from 0 to 1; none where it does not touch it.
std::optional<std::pair<double, double>> on_side(const ParameterSquare& q, int side) {
  const double u1 = q.u + q.size, v1 = q.v + q.size;
  if (side == 0 && q.v == 0) return {{q.u, u1}};
  if (side == 1 && u1 == 1) return {{q.v, v1}};
  if (side == 2 && v1 == 1) return {{1 - u1, 1 - q.u}};
  if (side == 3 && q.u == 0) return {{1 - v1, 1 - q.v}};
  return std::nullopt;
}

Strip strip_of(const Piece& piece, int side) {
  Strip s;
  const Along points = along_side(side, 4), normals = along_side(side, 6);
  for (int k = 0; k < 4; ++k) s.points[k] = piece.shape.control(points.first + k * points.step);
  const std::array<Vec3, 36> c = normal_coefficients(piece.shape);
  for (int k = 0; k < 6; ++k) s.normals[k] = c[normals.first + k * normals.step];
  const ParameterSquare& q = piece.square;
  const double u1 = q.u + q.size, v1 = q.v + q.size;
  const double u[] = {q.u, u1, u1, q.u}, v[] = {q.v, q.v, v1, v1};
  s.patch = q.patch;
  s.u0 = u[side], s.v0 = v[side], s.u1 = u[(side + 1) & 3], s.v1 = v[(side + 1) & 3];
  return s;
}

/// Strips from one end of an edge on, at an irregular vertex ever smaller: their normals are lost
/// in rounding there, so those that lie wholly within kVertexNormal_mm of the end have the normal
/// of the next one, as the cells of S have.
template <class Iterator>
void steady_normals(Iterator begin, Iterator end, bool at_front) {
  if (begin == end) return;
  const Vec3 vertex = at_front ? begin->points.front() : begin->points.back();
  const auto beyond = std::find_if(begin, end, [&](const Strip& s) {
    return std::any_of(s.points.begin(), s.points.end(),
                       [&](const Vec3& p) { return distance(p, vertex) > kVertexNormal_mm; });
  });
  if (beyond == end) return;
  const Vec3 normal = at_middle(beyond->normals);
  for (auto s = begin; s != beyond; ++s) s->normals.fill(normal);
}

/// All strips of one side of an edge, in their order along it.
std::vector<Strip> strips_of(const std::vector<PatchSide>& sides, const SurfaceTree& tree) {
  std::vector<Strip> out;
  for (const PatchSide& side : sides)
    for (const Piece& piece : tree.pieces_of(side.patch)) {
      const auto range = on_side(piece.square, side.side);
      if (!range) continue;
      Strip s = strip_of(piece, side.side);
      s.from = side.from + (side.to - side.from) * range->first;
      s.to = side.from + (side.to - side.from) * range->second;
      if (s.from > s.to) {
        std::swap(s.from, s.to), std::swap(s.u0, s.u1), std::swap(s.v0, s.v1);
        s.points = reversed(s.points), s.normals = reversed(s.normals);
      }
      out.push_back(s);
    }
  std::sort(out.begin(), out.end(), [](const Strip& a, const Strip& b) { return a.from < b.from; });
  steady_normals(out.begin(), out.end(), true);
  steady_normals(out.rbegin(), out.rend(), false);
  return out;
}

/// Every normal of one side meets every one of the other across a valley: t·(n × m) < 0 for all
/// coefficients, so for all points, with the first side's face to the left of the edge.
bool is_valley(const RidgeCell& cell, bool first_left) {
  for (int k = 0; k < 3; ++k) {
    const Vec3 along = (cell.shape.control(k + 1) - cell.shape.control(k)) * (first_left ? 1 : -1);
    for (const Vec3& n : cell.normals[0])
      for (const Vec3& m : cell.normals[1])
        if (dot(along, cross(n, m)) >= 0) return false;
  }
  return true;
}

bool is_smooth(const RidgeCell& cell) {
  for (int k = 1; k < cell.count; ++k)
    for (const Vec3& n : cell.normals[0])
      for (const Vec3& m : cell.normals[k])
        if (angle_between(n, m) > kSmooth_rad) return false;
  return true;
}

void set_curve(Bezier& b, const Curve<4>& c) {
  for (int k = 0; k < 16; ++k) b.set(k, c[k & 3]);
}

RidgeCell cell_between(const Strip& a, const Strip& b, double from, double to) {
  RidgeCell cell;
  const auto share = [&](const Strip& s, double at) { return (at - s.from) / (s.to - s.from); };
  const double a0 = share(a, from), a1 = share(a, to);
  set_curve(cell.shape, between(a.points, a0, a1));
  cell.normals[0] = between(a.normals, a0, a1);
  cell.normals[1] = between(b.normals, share(b, from), share(b, to));
  // Both sides' normals have about the same length, so that their mean is halfway.
  for (int k = 0; k < 2; ++k) {
    const double l = length(at_middle(cell.normals[k]));
    if (l > 0)
      for (Vec3& n : cell.normals[k]) n = n / l;
  }
  cell.patch = a.patch;
  cell.u0 = a.u0 + (a.u1 - a.u0) * a0, cell.u1 = a.u0 + (a.u1 - a.u0) * a1;
  cell.v0 = a.v0 + (a.v1 - a.v0) * a0, cell.v1 = a.v0 + (a.v1 - a.v0) * a1;
  return cell;
}

std::array<RidgeCell, 2> halved_along(const RidgeCell& cell) {
  std::array<RidgeCell, 2> out{cell, cell};
  const auto shapes = split_u(cell.shape);
  for (int h = 0; h < 2; ++h) {
    out[h].shape = shapes[h];
    for (int k = 0; k < cell.count; ++k)
      out[h].normals[k] = between(cell.normals[k], h == 0 ? 0 : 0.5, h == 0 ? 0.5 : 1);
  }
  out[0].u1 = out[1].u0 = (cell.u0 + cell.u1) / 2;
  out[0].v1 = out[1].v0 = (cell.v0 + cell.v1) / 2;
  return out;
}

double edge_length(const RidgeCell& cell) {
  return 2 * control_radius(cell.shape, middle(cell.shape));
}

/// Halfway between a cell's normals at its middle; zero where these cancel.
Vec3 axis_of(const RidgeCell& cell) {
  Vec3 sum;
  for (int k = 0; k < cell.count; ++k) sum += normalized(at_middle(cell.normals[k]));
  return length(sum) < kCancels ? Vec3{} : normalized(sum);
}

/// Which two of a cell's normals are the furthest apart at its middle.
struct WidestFan {
  int first = 0, second = 1;
  double angle_rad = -1;
};

WidestFan widest_of(const RidgeCell& cell) {
  WidestFan widest;
  for (int i = 0; i < cell.count; ++i)
    for (int j = i + 1; j < cell.count; ++j) {
      const double angle = angle_between(at_middle(cell.normals[i]), at_middle(cell.normals[j]));
      if (angle > widest.angle_rad) widest = {i, j, angle};
    }
  return widest;
}

void add_edge(const SharpEdge& edge, const SurfaceTree& tree, double radius_mm,
              std::vector<RidgeCell>& out) {
  const auto a = strips_of(edge.sides[0], tree), b = strips_of(edge.sides[1], tree);
  // A face lies to the left of its own edges, taken in its own direction.
  const bool first_left = edge.sides[0].front().from < edge.sides[0].front().to;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double from = std::max(a[i].from, b[j].from), to = std::min(a[i].to, b[j].to);
    if (from < to) {
      std::vector<RidgeCell> open{cell_between(a[i], b[j], from, to)};
      while (!open.empty()) {
        const RidgeCell cell = open.back();
        open.pop_back();
        if (is_smooth(cell) || is_valley(cell, first_left)) continue;
        if (edge_length(cell) <= 2 * radius_mm) {
          out.push_back(cell);
          continue;
        }
        const auto halves = halved_along(cell);
        open.push_back(halves[1]), open.push_back(halves[0]);
      }
    }
    (a[i].to < b[j].to ? i : j) += 1;
  }
}

/// A patch's parameters at its corners.
constexpr double kCornerU[] = {0, 1, 1, 0}, kCornerV[] = {0, 0, 1, 1};

/// Whether no face round a vertex rises over the tangent plane of another, but for what it bends
/// itself: only then have the normals between them all a meaning. Where some edges are valleys, the
/// others' own ends say all.
bool is_convex(const std::vector<PatchCorner>& corners, const std::vector<Vec3>& normals,
               const SurfaceTree& tree) {
  for (const PatchCorner& c : corners) {
    const double u = kCornerU[c.corner], v = kCornerV[c.corner];
    const Vec3 vertex = tree.evaluate(c.patch, u, v).position;
    for (const auto& [du, dv] :
         {std::pair{kIntoFace, 0.0}, {0.0, kIntoFace}, {kIntoFace, kIntoFace}}) {
      const Vec3 way = tree.evaluate(c.patch, std::abs(u - du), std::abs(v - dv)).position - vertex;
      const double apart = length(way);
      for (const Vec3& n : normals)
        if (dot(n, way) > apart * (kRises + apart)) return false;
    }
  }
  return true;
}

/// The normals between those of the faces round a vertex: a fan of triangles round their mean.
void add_vertex(const std::vector<PatchCorner>& corners, const SurfaceTree& tree,
                std::vector<RidgeCell>& out) {
  std::vector<Vec3> normals;
  Vec3 mean;
  RidgeCell cell;
  for (const PatchCorner& c : corners) {
    const double u = kCornerU[c.corner], v = kCornerV[c.corner];
    const SurfaceSample s = tree.evaluate(c.patch, u, v);
    const Vec3 normal =
        tree.evaluate(c.patch, std::abs(u - kBesideVertex), std::abs(v - kBesideVertex)).normal;
    if (!(length(normal) > 0)) continue;
    normals.push_back(normal);
    mean += normal;
    cell.patch = c.patch, cell.u0 = cell.u1 = u, cell.v0 = cell.v1 = v;
    for (int k = 0; k < 16; ++k) cell.shape.set(k, s.position);
  }
  if (normals.size() < 2 || !(length(mean) > kCancels) || !is_convex(corners, normals, tree))
    return;
  mean = normalized(mean);
  const Vec3 side = across(mean);
  const Vec3 other = cross(mean, side);
  std::sort(normals.begin(), normals.end(), [&](const Vec3& a, const Vec3& b) {
    return std::atan2(dot(a, other), dot(a, side)) < std::atan2(dot(b, other), dot(b, side));
  });
  cell.count = 3;
  cell.normals[0].fill(mean);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    cell.normals[1].fill(normals[i]);
    cell.normals[2].fill(normals[(i + 1) % normals.size()]);
    if (!is_smooth(cell)) out.push_back(cell);
  }
}

}  // namespace

SurfacePlace RidgeCell::place() const {
  return {patch, (u0 + u1) / 2, (v0 + v1) / 2, middle(shape)};
}

OffsetCell RidgeCell::offset() const {
  const Vec3 axis = axis_of(*this);
  if (axis == Vec3{}) return offset_cell(shape, {}, std::numbers::pi);
  // All normals are positive combinations of the coefficients, so they lie in their cone.
  std::vector<Vec3> all;
  for (int k = 0; k < count; ++k) all.insert(all.end(), normals[k].begin(), normals[k].end());
  if (count == 2)
    return offset_cell(shape, axis, at_middle(normals[0]), at_middle(normals[1]), all);
  double spread = 0;
  for (const Vec3& c : all) spread = std::max(spread, angle_between(c, axis));
  return offset_cell(shape, axis, spread);
}

std::array<RidgeCell, 2> RidgeCell::halved(double t_mm) const {
  double turning = 0;
  for (int k = 0; k < count; ++k)
    turning = std::max(turning, angle_between(normals[k].front(), normals[k].back()));
  const double t = std::abs(t_mm);
  return edge_length(*this) + t * turning > t * widest_of(*this).angle_rad ? halved_along(*this)
                                                                           : halved_fan();
}

std::array<RidgeCell, 2> RidgeCell::halved_fan() const {
  const auto [first, second, angle] = widest_of(*this);
  std::array<RidgeCell, 2> out{*this, *this};
  for (int k = 0; k < 6; ++k)
    out[0].normals[second][k] = out[1].normals[first][k] =
        (normals[first][k] + normals[second][k]) / 2;
  return out;
}

/// At a point of the edge the two are means of their coefficients by the same weights, so they
/// differ by no more than two of these do, and are no shorter than the least of them along the
/// axis.
double RidgeCell::fan_rad() const {
  const Vec3 axis = axis_of(*this);
  if (axis == Vec3{}) return std::numbers::pi;
  double apart = 0, least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 6; ++k)
    for (int i = 0; i < count; ++i) {
      least = std::min(least, dot(normals[i][k], axis));
      for (int j = 0; j < i; ++j) apart = std::max(apart, distance(normals[i][k], normals[j][k]));
    }
  return apart < least ? std::asin(apart / least) : std::numbers::pi;
}

RidgeCell RidgeCell::without_fan() const {
  RidgeCell out = *this;
  for (int k = 0; k < 6; ++k) {
    Vec3 sum;
    for (int i = 0; i < count; ++i) sum += normals[i][k];
    for (int i = 0; i < count; ++i) out.normals[i][k] = sum / count;
  }
  return out;
}

bool RidgeCell::is_tiny() const {
  return edge_length(*this) < 2 * kSmallestCell_mm && offset().spread_rad < kSmallestFan_rad;
}

std::vector<RidgeCell> ridge_cells(const SurfaceTree& tree, double radius_mm) {
  std::vector<RidgeCell> out;
  const SharpLines& lines = tree.sharp_lines();
  if (lines.edges.empty() && lines.vertices.empty()) return out;
  for (const SharpEdge& edge : lines.edges) add_edge(edge, tree, radius_mm, out);
  for (const auto& vertex : lines.vertices) add_vertex(vertex, tree, out);
  return out;
}

RidgeCell turned(RidgeCell cell, const model::Pose& pose) {
  cell.shape = turned(cell.shape, pose);
  for (auto& polynomial : cell.normals)
    for (Vec3& n : polynomial) n = pose.direction(n);
  return cell;
}

}  // namespace limitgauge::verifier
