#include "engine/strategy/levels/contour_writer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/base/angle.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

/// Chords of one turn of a helix: they run inside its circle.
constexpr int kChords = 16;
/// A loop shorter than this share of a ramp's length has no room for it.
constexpr double kLeastRoom = 0.02;

double length_of(const std::vector<FlatPoint>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

/// The place of `line` after its `step`th point from the first: backwards round a closed one,
/// to and fro along an open one.
const FlatPoint& walked(const LevelPass& pass, std::size_t step) {
  const std::size_t last = pass.points.size() - 1;
  if (pass.closed) return pass.points[last - step % last];
  const std::size_t way = step % (2 * last);
  return pass.points[way <= last ? way : 2 * last - way];
}

}  // namespace

ContourWriter::ContourWriter(const StageRequest& request, double clear_z_mm)
    : cut_(request.cut),
      clearance_(request.clearance_mm),
      slope_(std::tan(model::radians(request.cut.ramp_angle_deg))),
      path_(request, clear_z_mm) {}

void ContourWriter::begin_level(double z_mm, double stands_to_mm) {
  z_ = z_mm;
  stands_to_ = stands_to_mm;
}

void ContourWriter::write(const LevelPass& pass) {
  enter(pass);
  for (std::size_t i = 1; i < pass.points.size(); ++i) path_.cut_to(at_level(pass.points[i]));
}

void ContourWriter::enter(const LevelPass& pass) {
  const Vec3 first = at_level(pass.points.front());
  if (path_.down() && pass.arrival == Arrival::link) return path_.link_to(first);
  if (path_.down() && pass.arrival == Arrival::cut_link) return path_.cut_to(first);
  if (pass.arrival == Arrival::clear_air) return come_down(first, z_ + clearance_);
  Way way;
  if (cut_.entry == Entry::helix) way = helix(pass);
  if (cut_.entry != Entry::plunge && way.empty()) way = ramp(pass);
  if (way.empty()) return come_down(first, stands_to_ + clearance_);
  come_down(way.front(), stands_to_ + clearance_);
  for (const Vec3& p : way) path_.cut_to(p);
}

ContourWriter::Way ContourWriter::ramp(const LevelPass& pass) const {
  const double needed = (stands_to_ - z_) / slope_;
  const double room = length_of(pass.points);
  if (!(room > kLeastRoom * needed)) return {};
  Way way = {at_level(pass.points.front())};
  double gone = 0;
  for (std::size_t step = 1; gone < needed; ++step) {
    const FlatPoint& a = walked(pass, step - 1);
    const FlatPoint& b = walked(pass, step);
    const double piece = distance(a, b), part = std::min(piece, needed - gone);
    if (piece <= 0) continue;
    gone += part;
    const FlatPoint p = lerp(a, b, part / piece);
    way.push_back({p.x, p.y, z_ + gone * slope_});
  }
  std::reverse(way.begin(), way.end());
  return way;
}

ContourWriter::Way ContourWriter::helix(const LevelPass& pass) const {
  if (!pass.helix) return {};
  const FlatPoint centre = *pass.helix, first = pass.points[0], next = pass.points[1];
  const double radius = distance(centre, first);
  const double angle = std::atan2(first.y - centre.y, first.x - centre.x);
  const double side =
      (next.x - first.x) * (centre.y - first.y) - (next.y - first.y) * (centre.x - first.x);
  const double turn = (side > 0 ? 1 : -1) * 2 * std::numbers::pi / kChords;
  const double fall = 2 * radius * std::sin(std::numbers::pi / kChords) * slope_;
  Way way;
  for (int k = static_cast<int>(std::ceil((stands_to_ - z_) / fall)); k > 0; --k)
    way.push_back({centre.x + radius * std::cos(angle - turn * k),
                   centre.y + radius * std::sin(angle - turn * k), z_ + fall * k});
  way.push_back(at_level(first));
  return way;
}

void ContourWriter::come_down(const Vec3& p, double rapid_to_z_mm) {
  if (rapid_to_z_mm >= path_.clear_z()) return path_.enter_at(p);
  path_.rapid_over_to({p.x, p.y, std::max(rapid_to_z_mm, p.z)});
  path_.plunge_to(p);
}

}  // namespace limitgauge::engine::strategy
