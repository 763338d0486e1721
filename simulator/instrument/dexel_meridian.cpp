#include "simulator/instrument/dexel_meridian.h"

#include <algorithm>
#include <cmath>

#include "model/base/angle.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

double root(double x) {
  return std::sqrt(std::max(0.0, x));
}

// Where the rounding of a cutter sits, and the angles of its bottom and its side.
struct Corner {
  double rho = 0, z = 0, radius = 0, bottom = 0, lean = 0;
};

// Centre of the arc that touches a bottom rising by `bottom` from the tip and a side leaning by
// `lean` that meet at `radius`: both at the distance `corner` from it.
Corner between(double radius, double corner, double bottom, double lean) {
  const double unit = corner / std::cos(bottom + lean);
  return {radius - unit * (std::cos(bottom) - std::sin(lean)),
          radius * std::tan(bottom) + unit * (std::cos(lean) - std::sin(bottom)), corner, bottom,
          lean};
}

Corner corner_of(const model::Cutter& c) {
  const double tip = model::radians(c.tip_angle_deg), lean = model::radians(c.taper_angle_deg);
  if (c.type == model::CutterType::apt || c.type == model::CutterType::drill)
    return between(c.radius_mm(), c.corner_radius_mm, tip, lean);
  const double r = c.type == model::CutterType::ball ? c.radius_mm() : c.corner_radius_mm;
  return {c.radius_mm() - r, r, r, 0, lean};
}

}  // namespace

void ConvexMeridian::add_line(double end, double height_at_axis, double slope) {
  if (end > (pieces_.empty() ? 0 : pieces_.back().end))
    pieces_.push_back({end, height_at_axis, slope, 0, 0});
}

void ConvexMeridian::add_arc(double end, double centre_rho, double centre_height, double radius) {
  if (radius > 0 && end > (pieces_.empty() ? 0 : pieces_.back().end))
    pieces_.push_back({end, centre_height, 0, centre_rho, radius});
}

const ConvexMeridian::Piece& ConvexMeridian::piece_at(double rho) const {
  std::size_t i = 0;
  while (i + 1 < pieces_.size() && rho > pieces_[i].end) ++i;
  return pieces_[i];
}

double ConvexMeridian::height(double rho) const {
  const Piece& p = piece_at(rho);
  if (p.radius == 0) return p.height + p.slope * rho;
  return p.height - root((p.radius - rho + p.centre) * (p.radius + rho - p.centre));
}

// True where the derivative of height(√(across² + w²)) is at least `slope`, written without
// quotients: an arc may end upright.
bool ConvexMeridian::steeper_at(const Piece& p, double rho, double w, double slope) {
  if (p.radius == 0) return p.slope * w >= slope * rho;
  const double e = rho - p.centre;
  return e * w >= slope * rho * root((p.radius - e) * (p.radius + e));
}

bool ConvexMeridian::steeper(double rho, double w, double slope) const {
  return steeper_at(piece_at(rho), rho, w, slope);
}

double ConvexMeridian::foot_in(const Piece& p, double across, double slope, double w0, double w1) {
  if (p.radius == 0) {
    const double w = slope * across / root(p.slope * p.slope - slope * slope);
    return std::clamp(std::isfinite(w) ? w : w1, w0, w1);
  }
  if (p.centre == 0) {
    const double inside = (p.radius - across) * (p.radius + across) / (1 + slope * slope);
    return std::clamp(slope * root(inside), w0, w1);
  }
  // e·w − slope·ρ·h changes its sign once, from minus to plus, where the derivative vanishes. At a
  // minimum a place to 1e-12 gives the height to rounding.
  double low = w0, high = w1, w = 0.5 * (w0 + w1);
  for (int step = 0; step < 200; ++step) {
    const double rho = std::sqrt(w * w + across * across), e = rho - p.centre;
    const double h = root((p.radius - e) * (p.radius + e));
    const double value = e * w - slope * rho * h;
    (value < 0 ? low : high) = w;
    const double rise = e + w * w / rho - slope * w * (h / rho - (h > 0 ? e / h : 0.0));
    double next = w - value / rise;
    if (!(next >= low && next <= high) || step % 8 == 7) next = 0.5 * (low + high);
    if (std::abs(next - w) <= kSettled * rho) return next;
    w = next;
  }
  return w;
}

double ConvexMeridian::foot(double across, double slope) const {
  if (slope == 0) return 0;
  double w0 = 0;
  for (const Piece& piece : pieces_) {
    if (piece.end <= across) continue;
    const double w1 = root((piece.end - across) * (piece.end + across));
    if (steeper_at(piece, piece.end, w1, slope)) return foot_in(piece, across, slope, w0, w1);
    w0 = w1;
  }
  return w0;
}

DexelProfile::DexelProfile(const model::Cutter& cutter) {
  model::require_valid(cutter);
  const Corner c = corner_of(cutter);
  length_ = cutter.flute_length_mm;
  ball_ = cutter.type == model::CutterType::ball;
  // Where the arc leaves the bottom and where it meets the side.
  const double bottom_end = c.rho + c.radius * std::sin(c.bottom);
  const double side_rho = c.rho + c.radius * std::cos(c.lean);
  const double side_z = c.z - c.radius * std::sin(c.lean);
  const double top_radius = side_rho + (length_ - side_z) * std::tan(c.lean);
  lower_.add_line(bottom_end, 0, std::tan(c.bottom));
  if (c.lean >= 0) {
    lower_.add_arc(side_rho, c.rho, c.z, c.radius);
    const double rise = 1 / std::tan(c.lean);
    if (c.lean > 0) lower_.add_line(top_radius, side_z - rise * side_rho, rise);
    minus_upper_.add_line(top_radius, -length_, 0);
    return;
  }
  const double rise = -1 / std::tan(c.lean);
  lower_.add_arc(c.rho + c.radius, c.rho, c.z, c.radius);
  minus_upper_.add_line(top_radius, -length_, 0);
  minus_upper_.add_line(side_rho, -side_z - rise * side_rho, rise);
  minus_upper_.add_arc(c.rho + c.radius, c.rho, -c.z, c.radius);
}

}  // namespace limitgauge::simulator
