#include "engine/surface/cell/corner_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/tolerance.h"

namespace limitgauge::engine::surface {

CornerRing::CornerRing(Parts parts)
    : centre_(parts.centre),
      edges_(std::move(parts.edges)),
      faces_(std::move(parts.faces)),
      sharpness_(std::move(parts.sharpness)),
      closed_(parts.closed),
      own_(parts.own) {}

CornerRing::CornerRing(const OuterMesh& mesh, Index corner)
    : centre_(mesh.points[mesh.origin[corner]]),
      own_sharpness_(mesh.vertex_sharpness[mesh.origin[corner]]) {
  const RingWalk walk = walk_ring(mesh, mesh.origin[corner]);
  closed_ = walk.closed;
  for (std::size_t i = 0; i < walk.out.size(); ++i) {
    const Index h = walk.out[i];
    if (h == corner) own_ = static_cast<int>(i);
    edges_.push_back(mesh.points[mesh.target(h)]);
    faces_.push_back(mesh.points[mesh.target(mesh.next(h))]);
    sharpness_.push_back(mesh.edge_sharpness[mesh.edge[h]]);
  }
  if (closed_) return;
  const Index last = mesh.previous(walk.out.back());
  edges_.push_back(mesh.points[mesh.origin[last]]);
  sharpness_.push_back(mesh.edge_sharpness[mesh.edge[last]]);
}

VertexRule CornerRing::rule_of(bool child) const {
  int sharp = 0;
  for (const double s : sharpness_) sharp += is_sharp(child ? child_sharpness(s) : s);
  return vertex_rule(child ? child_sharpness(own_sharpness_) : own_sharpness_, sharp);
}

Vec3 CornerRing::moved_by(VertexRule rule, bool child) const {
  if (rule == VertexRule::corner) return centre_;
  Vec3 edge_sum, face_sum;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const double s = child ? child_sharpness(sharpness_[i]) : sharpness_[i];
    if (rule != VertexRule::crease || is_sharp(s)) edge_sum += edges_[i];
  }
  if (rule == VertexRule::crease) return centre_ * 0.75 + edge_sum * 0.125;
  for (const Vec3& f : faces_) face_sum += f;
  const auto n = static_cast<double>(edges_.size());
  const double beta = 3 / (2 * n), gamma = 1 / (4 * n);
  return centre_ * (1 - beta - gamma) + edge_sum * (beta / n) + face_sum * (gamma / n);
}

Vec3 CornerRing::refined_centre() const {
  const VertexRule now = rule_of(false), then = rule_of(true);
  const Vec3 by_now = moved_by(now, false);
  if (now == then) return by_now;
  int fading = 0;
  double sum = 0;
  const auto count = [&](double s) {
    if (!is_sharp(s) || is_sharp(child_sharpness(s))) return;
    ++fading;
    sum += s;
  };
  count(own_sharpness_);
  for (const double s : sharpness_) count(s);
  if (fading == 0) return by_now;
  return lerp(moved_by(then, true), by_now, std::min(1.0, sum / fading));
}

Vec3 CornerRing::refined_edge(int i) const {
  const Vec3 middle = (centre_ + edges_[i]) * 0.5;
  const double s = sharpness_[i];
  if (s >= 1) return middle;
  const std::size_t before = wrapped(i - 1), after = wrapped(i + 1);
  const Vec3 smooth = (centre_ + edges_[i]) * 0.375 +
                      (faces_[before] + faces_[i] + edges_[before] + edges_[after]) * 0.0625;
  return lerp(smooth, middle, s);
}

void CornerRing::refine() {
  std::vector<Vec3> edges(edges_.size()), faces(faces_.size());
  for (int i = 0; i < edge_total(); ++i) edges[i] = refined_edge(i);
  for (int i = 0; i < face_total(); ++i)
    faces[i] = (centre_ + edges_[i] + faces_[i] + edges_[wrapped(i + 1)]) * 0.25;
  centre_ = refined_centre();
  edges_ = std::move(edges);
  faces_ = std::move(faces);
  for (double& s : sharpness_) s = child_sharpness(s);
  own_sharpness_ = child_sharpness(own_sharpness_);
}

double CornerRing::largest_finite_sharpness() const {
  double largest = is_infinite(own_sharpness_) ? 0.0 : own_sharpness_;
  for (const double s : sharpness_)
    if (!is_infinite(s)) largest = std::max(largest, s);
  return largest;
}

void CornerRing::add_points(std::vector<Vec3>& points) const {
  points.push_back(centre_);
  points.insert(points.end(), edges_.begin(), edges_.end());
  points.insert(points.end(), faces_.begin(), faces_.end());
}

bool CornerRing::regular() const {
  const VertexRule rule = rule_of(false);
  if (rule == VertexRule::smooth) return closed_ && edge_total() == 4;
  if (rule == VertexRule::dart) return false;
  const Sector sector = own_sector();
  if (rule == VertexRule::crease) return sector.faces == 2;
  return sector.faces == 1 && is_sharp(sharpness_[wrapped(sector.first)]) &&
         is_sharp(sharpness_[wrapped(sector.first + 1)]);
}

bool CornerRing::is_sharp_point() const {
  return rule_of(false) == VertexRule::corner;
}

Vec3 CornerRing::limit_point() const {
  switch (rule_of(false)) {
    case VertexRule::corner:
      return centre_;
    case VertexRule::dart:
      return deep_limit().point;
    case VertexRule::crease: {
      Vec3 ends;
      for (std::size_t i = 0; i < edges_.size(); ++i)
        if (is_sharp(sharpness_[i])) ends += edges_[i];
      return (centre_ * 4.0 + ends) / 6.0;
    }
    case VertexRule::smooth:
      break;
  }
  Vec3 edge_sum, face_sum;
  for (const Vec3& e : edges_) edge_sum += e;
  for (const Vec3& f : faces_) face_sum += f;
  const auto n = static_cast<double>(edges_.size());
  return (centre_ * (n * n) + edge_sum * 4.0 + face_sum) / (n * (n + 5));
}

CornerRing::Sector CornerRing::own_sector() const {
  Sector sector{own_, 1};
  const int limit = face_total();
  while (sector.faces < limit && !is_sharp(sharpness_[wrapped(sector.first)])) {
    sector.first = static_cast<int>(wrapped(sector.first - 1));
    ++sector.faces;
  }
  while (sector.faces < limit && !is_sharp(sharpness_[wrapped(sector.first + sector.faces)]))
    ++sector.faces;
  return sector;
}

Vec3 CornerRing::limit_normal() const {
  const VertexRule rule = rule_of(false);
  Vec3 normal;
  if (rule == VertexRule::smooth) normal = smooth_normal();
  if (rule == VertexRule::crease) normal = crease_normal(own_sector());
  if (rule == VertexRule::corner) normal = corner_normal(own_sector());
  // Valence 2, a dart, the tip of a cone and collinear edges have no closed mask here.
  if (length_squared(normal) == 0) normal = deep_limit().normal;
  return length_squared(normal) > 0 ? normalized(normal) : Vec3{0, 0, 1};
}

Vec3 CornerRing::smooth_normal() const {
  const int n = edge_total();
  const double step = 2 * std::numbers::pi / n;
  const double c = std::cos(step), a = 1 + c + std::cos(step / 2) * std::sqrt(2 * (9 + c));
  if (n == 2) return {};
  Vec3 t1, t2;
  for (int i = 0; i < n; ++i) {
    const double here = i * step, there = (i + 1) * step;
    t1 += edges_[i] * (a * std::cos(here)) + faces_[i] * (std::cos(here) + std::cos(there));
    t2 += edges_[i] * (a * std::sin(here)) + faces_[i] * (std::sin(here) + std::sin(there));
  }
  return cross(t1, t2);
}

Vec3 CornerRing::crease_normal(const Sector& sector) const {
  const int k = sector.faces;
  const Vec3 first = edges_[wrapped(sector.first)], last = edges_[wrapped(sector.first + k)];
  const Vec3 along = first - last;
  if (k == 1) return cross(along, first + last - centre_ * 2.0);
  const double theta = std::numbers::pi / k;
  const double c = std::cos(theta), s = std::sin(theta);
  const double r = k == 2 ? 1.0 : (c + 1) / s;
  Vec3 across = centre_ * (4 * r * (c - 1)) - (first + last) * (r * (1 + 2 * c));
  for (int i = 0; i < k; ++i) {
    across += faces_[wrapped(sector.first + i)] * (std::sin(i * theta) + std::sin((i + 1) * theta));
    if (i > 0) across += edges_[wrapped(sector.first + i)] * (4 * std::sin(i * theta));
  }
  return cross(along, across);
}

Vec3 CornerRing::sector_cross(const Sector& sector) const {
  Vec3 sum;
  for (int i = 0; i < sector.faces; ++i) {
    const Vec3 a = edges_[wrapped(sector.first + i)] - centre_;
    const Vec3 b = edges_[wrapped(sector.first + i + 1)] - centre_;
    sum += cross(a, b);
  }
  return sum;
}

Vec3 CornerRing::corner_normal(const Sector& sector) const {
  if (!is_sharp(sharpness_[wrapped(sector.first)])) return {};
  const Vec3 a = edges_[wrapped(sector.first)] - centre_;
  const Vec3 b = edges_[wrapped(sector.first + sector.faces)] - centre_;
  const Vec3 normal = cross(a, b);
  if (length(normal) <= kCollinear * length(a) * length(b)) return {};
  return dot(normal, sector_cross(sector)) < 0 ? -normal : normal;
}

CornerRing::DeepLimit CornerRing::deep_limit() const {
  // Refining about the moving vertex and scaling up keeps full precision at any depth; the error
  // shrinks by at least 0.75 a level, so 100 levels end below rounding.
  constexpr int kLevels = 100;
  CornerRing ring = *this;
  DeepLimit limit;
  double scale = 1;
  for (int level = 0; level <= kLevels; ++level) {
    const Vec3 shift = ring.centre_;
    limit.point += shift * scale;
    const double zoom = level == 0 ? 1.0 : 2.0;
    for (Vec3& e : ring.edges_) e = (e - shift) * zoom;
    for (Vec3& f : ring.faces_) f = (f - shift) * zoom;
    ring.centre_ = {};
    scale /= zoom;
    if (level < kLevels) ring.refine();
  }
  Sector sector = ring.own_sector();
  const bool cone = rule_of(false) == VertexRule::corner && sector.faces == face_total() && closed_;
  if (cone) sector = {own_, 1};
  limit.normal = ring.sector_cross(sector);
  return limit;
}

}  // namespace limitgauge::engine::surface
