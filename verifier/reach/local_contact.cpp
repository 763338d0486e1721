#include "verifier/reach/local_contact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Box3;
using model::Interval;
using model::Vec3;

Box3 negated(const Box3& box) {
  return {-box.high, -box.low};
}

/// What the cutter's section leaves free: n·w ≤ ½(along·w_t² + across·w_b²), along its meridian and
/// across it. `turn` is how far the two directions may be turned against the cell's own.
struct Clearance {
  double along = 0, across = 0, turn = 0;
};

/// How far beyond a cell the rectangles about it go that are tried, one after the other, as far as
/// the next one fails: from so many radii of the cell to so many, or to three of the cells that S
/// is cut into to begin with, if that is more.
constexpr double kLeastMargin = 3.2, kMostMargin = 6.2, kMarginStep = 1.18;

/// How wide the discs are over which S is looked at as a graph: where a ball is further from its
/// tangent plane than kGap / 2 radii of the cell, between so many of the radii of the cells that S
/// is cut into, and then how often and by how much less.
constexpr double kGap = 8, kLeastReach_mm = 1, kLeastDisc = 4, kWidestDisc = 10, kDiscStep = 0.8;
constexpr int kDiscTries = 6;

/// No clearance that is the same all round is greater: a ball's bend, or that of the circle in
/// which the rounding of another cutter touches.
double most_bend(const CellContact& c, double reach) {
  if (c.profile().flat_mm <= 0) return reach > 0 ? 1 / reach : 0;
  if (c.turning() || c.level()) return 0;
  return std::sin(std::min(c.tilt() + c.alpha(), std::numbers::pi / 2)) / c.profile().flat_mm;
}

/// The cells of a region that come nearer than a disc is wide.
ClearedDisc cleared_disc(const GraphRegion& region, double radius_mm, const CellContact& contact) {
  ClearedDisc out{{}, contact.middle(), radius_mm - contact.radius() - kDistanceRounding_mm};
  for (const GraphRegion::Cell& cell : region.cells)
    if (cell.near_mm < radius_mm) out.cells.push_back(cell.index);
  std::sort(out.cells.begin(), out.cells.end());
  return out;
}

}  // namespace

/// Spans over a rectangle: components of the first derivatives, normal parts of the second.
struct LocalContact::Spans {
  Interval ut = Interval::none(), ub = ut, un = ut, vt = ut, vb = ut, vn = ut, uz = ut, vz = ut,
           uu = ut, uv = ut, vv = ut;
  double u = 0, v = 0;  ///< greatest lengths of the first derivatives

  /// Greatest length of S over steps (±x, ±y): the integral of U·x + V·y, any two of which have a
  /// product that lies in the span of x²U·U′ + xy(U·V′ + V·U′) + y²V·V′.
  double longest(double x, double y) const {
    const double skew = (ut * vt + ub * vb + un * vn).largest();
    return std::sqrt(u * u * x * x + 2 * skew * x * y + v * v * y * y);
  }
};

/// The directions that components are taken along.
struct LocalContact::Frame {
  Vec3 n, t, b;     ///< normal, along the cutter's meridian, across it
  double lean = 0;  ///< how far a normal of the cell may be from n
  PlaneParameters plane;

  /// None where S has no plane.
  static std::optional<Frame> of(const SurfaceCell& cell, const CellContact& contact) {
    const auto plane = PlaneParameters::of(cell);
    if (!plane) return std::nullopt;
    const Vec3& e = contact.direction();
    Frame f{contact.normal(), {}, {-e.y, e.x, 0}, 2 * std::sin(contact.alpha() / 2), *plane};
    f.t = cross(f.b, f.n);
    return f;
  }
};

namespace {

/// Whether one of the clearances that hold for all w = q − s of length up to `far`, rising by up to
/// `rise`, `serves`; any of them suffices. k is the curvature of the circle in which the cutter's
/// rounding touches, R′ its rounding with the allowance, and within the angle `free` of the contact
/// the section is round.
template <class Serves>
bool any_clearance(const CellContact& c, double reach, double far, double rise, Serves&& serves) {
  const double top = std::min(c.tilt() + c.alpha(), std::numbers::pi / 2),
               low = std::max(0.0, c.tilt() - c.alpha());
  if (c.profile().flat_mm <= 0 && reach > 0 && rise <= reach * std::cos(top))
    if (serves(Clearance{1 / reach, 1 / reach, 0})) return true;
  if (c.turning() || c.level()) return serves(Clearance{0, 0, 0});
  // No point of the cutter near the contact lies further from its axis; a straight wall ends it.
  double furthest = c.profile().flat_mm + reach * std::sin(top) + far;
  if (c.profile().slope == 0) furthest = std::min(furthest, c.profile().flat_mm + reach);
  const double k = 1 / furthest;
  const double across = std::sin(low) * k, turn = c.beta() + c.alpha();
  if (serves(Clearance{0, across, c.beta()})) return true;
  const double free = std::min(low, std::numbers::pi / 2 - std::atan(c.profile().slope) - top);
  if (free <= 0 || c.profile().flat_mm <= 0) return false;
  const double y = far + k * far * far / 2;
  double bend = reach > 0 ? 1 / reach : 1e300;
  if (y > reach * std::sin(free))
    bend = std::min(bend, 2 * (y * std::tan(free) - reach * (1 / std::cos(free) - 1)) / (y * y));
  // (|w_t| − x)² ≥ (1 − η)·w_t² − (1/η − 1)·x² with x = k·w_b²/2, for η = 1/2, and shares of it.
  for (const double share : {0.015, 0.02, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1, 0.12, 0.15, 0.18,
                             0.21,  0.25, 0.3,  0.35, 0.42, 0.5,  0.6,  0.7, 0.85, 1.0}) {
    const double meridian = share * bend / 2, rest = across - meridian * 2 * k * k * far * far / 4;
    if (rest < 0) continue;
    const double both = std::min(meridian, rest);
    if (serves(Clearance{meridian, rest, turn}) || serves(Clearance{both, both, 0})) return true;
  }
  return false;
}

bool positive(const Interval& uu, const Interval& uv, const Interval& vv) {
  const double off = uv.largest();
  return uu.low >= 0 && vv.low >= 0 && off * off <= uu.low * vv.low;
}

}  // namespace

LocalContact::LocalContact(const std::vector<SurfaceCell>& cells, double allowance_mm,
                           double contact_mm)
    : index_(cells),
      charts_(cells, index_),
      regions_(cells, index_, charts_),
      allowance_mm_(allowance_mm),
      contact_mm_(contact_mm) {
  hulls_.reserve(cells.size());
  for (const SurfaceCell& cell : cells) hulls_.push_back(derivative_hull(cell));
}

ParameterRect LocalContact::clipped(int patch, const ParameterRect& own,
                                    ParameterRect wanted) const {
  wanted = {std::max(wanted.u0, -1.0), std::min(wanted.u1, 2.0), std::max(wanted.v0, -1.0),
            std::min(wanted.v1, 2.0)};
  if (wanted.u0 < 0 && !charts_.covers(patch, -1, 0)) wanted.u0 = 0;
  if (wanted.u1 > 1 && !charts_.covers(patch, 1, 0)) wanted.u1 = 1;
  if (wanted.v0 < 0 && !charts_.covers(patch, 0, -1)) wanted.v0 = 0;
  if (wanted.v1 > 1 && !charts_.covers(patch, 0, 1)) wanted.v1 = 1;
  // A corner round which the surface does not go on: give up the side that is further off.
  for (const int i : {-1, 1})
    for (const int j : {-1, 1}) {
      const bool over_u = i < 0 ? wanted.u0 < 0 : wanted.u1 > 1,
                 over_v = j < 0 ? wanted.v0 < 0 : wanted.v1 > 1;
      if (!over_u || !over_v || charts_.covers(patch, i, j)) continue;
      const double gap_u = i < 0 ? own.u0 : 1 - own.u1, gap_v = j < 0 ? own.v0 : 1 - own.v1;
      if (gap_u > gap_v)
        (i < 0 ? wanted.u0 : wanted.u1) = i < 0 ? 0 : 1;
      else
        (j < 0 ? wanted.v0 : wanted.v1) = j < 0 ? 0 : 1;
    }
  return wanted;
}

/// Adds the cells that touch `rect`, but for those that touch `inner` and were added with it.
void LocalContact::add_spans(Spans& s, int patch, const ParameterRect& rect,
                             const std::optional<ParameterRect>& inner, const Frame& f) const {
  constexpr ParameterRect kAll{0, 1, 0, 1};
  const Vec3 z{0, 0, 1};
  for (const PlacedPatch& placed : charts_.around(patch)) {
    const ParameterRect own = placed.to_own(rect);
    if (!own.touches(kAll)) continue;
    const auto before = inner ? std::optional(placed.to_own(*inner)) : std::nullopt;
    index_.overlapping_beyond(placed.patch, own, before, [&](std::uint32_t k) {
      const DerivativeHull& h = hulls_[k];
      const bool swapped = placed.turns % 2 == 1;
      const Box3& along_u = swapped ? h.v : h.u;
      const Box3& along_v = swapped ? h.u : h.v;
      const Box3 own_u = placed.turns == 1 || placed.turns == 2 ? negated(along_u) : along_u;
      const Box3 own_v = placed.turns >= 2 ? negated(along_v) : along_v;
      const Box3 own_uv = swapped ? negated(h.uv) : h.uv;
      const Box3 &own_uu = swapped ? h.vv : h.uu, &own_vv = swapped ? h.uu : h.vv;
      const auto [u, v, uu, uv, vv] = f.plane.taken({own_u, own_v, own_uu, own_uv, own_vv});
      s.uz.add(along(own_u, z)), s.vz.add(along(own_v, z));
      s.ut.add(along(u, f.t)), s.ub.add(along(u, f.b)), s.un.add(along(u, f.n));
      s.vt.add(along(v, f.t)), s.vb.add(along(v, f.b)), s.vn.add(along(v, f.n));
      s.uu.add(along(uu, f.n).widened(f.lean * longest(uu)));
      s.uv.add(along(uv, f.n).widened(f.lean * longest(uv)));
      s.vv.add(along(vv, f.n).widened(f.lean * longest(vv)));
      s.u = std::max(s.u, longest(u)), s.v = std::max(s.v, longest(v));
    });
  }
}

/// Whether what `s` holds of the derivatives does for a proof over `area`: where they are those of
/// a part of it, no proof over all of it is to be had if there is none by them.
bool LocalContact::proven(const ParameterRect& area, const ParameterRect& own,
                          const CellContact& contact, const Frame& f, const Spans& s) const {
  const double du = std::max(own.u1 - area.u0, area.u1 - own.u0),
               dv = std::max(own.v1 - area.v0, area.v1 - own.v0);
  const double y = dv / f.plane.v_y, x = (du + std::abs(f.plane.u_y) * y) / f.plane.u_x;
  const double far = s.longest(x, y), rise = s.uz.largest() * du + s.vz.largest() * dv;
  const double reach = contact.profile().rounding_mm + allowance_mm_;
  const double slack = slack_mm(far);
  if (slack < 0) return false;
  const auto serves = [&](const Clearance& c) {
    const Interval ut = s.ut.widened(c.turn * s.u), ub = s.ub.widened(c.turn * s.u),
                   vt = s.vt.widened(c.turn * s.v), vb = s.vb.widened(c.turn * s.v);
    const Interval uu = c.along * square(ut) + c.across * square(ub) + (-1.0) * s.uu,
                   uv = c.along * (ut * vt) + c.across * (ub * vb) + (-1.0) * s.uv,
                   vv = c.along * square(vt) + c.across * square(vb) + (-1.0) * s.vv;
    const double on_u = slack / (x * x), on_v = slack / (y * y);
    return positive(uu + Interval{on_u, on_u}, uv, vv + Interval{on_v, on_v});
  };
  return any_clearance(contact, reach, far, rise, serves);
}

std::optional<ClearedRect> LocalContact::clear_rect(const SurfaceCell& cell,
                                                    const CellContact& contact) const {
  const ParameterRect own = rect_of(cell);
  const auto frame = Frame::of(cell, contact);
  if (!frame) return std::nullopt;
  const double u = frame->plane.along_u_mm, v = frame->plane.along_v_mm;
  const auto around = [&](double margin) {
    return clipped(
        cell.patch, own,
        {own.u0 - margin / u, own.u1 + margin / u, own.v0 - margin / v, own.v1 + margin / v});
  };
  Spans spans;
  // What fails by the derivatives at the middle fails over any rectangle, and most cells do.
  const ParameterRect middle{cell.u_at(0.5), cell.u_at(0.5), cell.v_at(0.5), cell.v_at(0.5)};
  add_spans(spans, cell.patch, middle, {}, *frame);
  const double h = contact.radius();
  if (!proven(around(kLeastMargin * h), own, contact, *frame, spans)) return std::nullopt;
  ParameterRect seen = middle;
  std::optional<ParameterRect> failed;
  std::optional<ClearedRect> cleared;
  const double widest = std::max(kMostMargin * h, 3 * regions_.largest_radius_mm());
  for (double margin = kLeastMargin * h; margin <= widest; margin *= kMarginStep) {
    const ParameterRect area = around(margin);
    if (failed && area.holds(*failed)) continue;
    // A side may be given up on the way.
    const bool grows = area.holds(seen);
    if (!grows) spans = {};
    add_spans(spans, cell.patch, area, grows ? std::optional(seen) : std::nullopt, *frame);
    seen = area;
    if (proven(area, own, contact, *frame, spans))
      cleared = {cell.patch, area};
    else if (!cleared)
      return std::nullopt;
    else
      failed = area;
  }
  return cleared;
}

/// By the bend of S as a graph over the contact's plane: it asks for a way round the cell without
/// edges, and is indifferent to how unevenly parameters run.
std::shared_ptr<const ClearedDisc> LocalContact::clear_disc(const CellContact& contact,
                                                            std::uint32_t whole) const {
  const double h = contact.radius(), reach = contact.profile().rounding_mm + allowance_mm_;
  // Beyond it the cutter should be further off than its tip strays over the cell, a few times h.
  const double enough = std::sqrt(kGap * h * std::max(reach, kLeastReach_mm));
  const double usual = regions_.largest_radius_mm();
  const double widest = std::clamp(enough, kLeastDisc * usual, kWidestDisc * usual);
  const auto region = regions_.around(contact, whole, widest, most_bend(contact, reach));
  if (!region) return nullptr;
  double radius = region->limit_mm;
  for (int tries = 0; tries < kDiscTries && radius > 2 * h; ++tries, radius *= kDiscStep) {
    const auto disc = region->over(radius);
    if (!disc || slack_mm(radius) < 0) continue;
    const bool serves = any_clearance(
        contact, reach, radius, std::min(radius, disc->rise_mm),
        [&](const Clearance& c) { return std::min(c.along, c.across) >= disc->bend; });
    if (serves) return std::make_shared<const ClearedDisc>(cleared_disc(*region, radius, contact));
  }
  return nullptr;
}

std::optional<Cleared> LocalContact::clear(const SurfaceCell& cell, const CellContact& contact,
                                           std::uint32_t whole) const {
  if (const auto rect = clear_rect(cell, contact)) return *rect;
  if (auto disc = clear_disc(contact, whole)) return disc;
  return std::nullopt;
}

bool LocalContact::holds(const Cleared& cleared, std::uint32_t whole,
                         const CellHalves::Part& part) const {
  if (const auto* const disc = std::get_if<std::shared_ptr<const ClearedDisc>>(&cleared))
    return (*disc)->holds(whole, part.middle, part.radius_mm);
  const ClearedRect& area = std::get<ClearedRect>(cleared);
  const auto& chart = charts_.around(area.patch);
  return std::any_of(chart.begin(), chart.end(), [&](const PlacedPatch& p) {
    return p.patch == part.cell->patch && area.rect.holds(p.to_chart(rect_of(*part.cell)));
  });
}

bool ClearedDisc::holds(std::uint32_t whole, const Vec3& middle, double part_radius_mm) const {
  return distance(middle, centre) + part_radius_mm < radius_mm &&
         std::binary_search(cells.begin(), cells.end(), whole);
}

}  // namespace limitgauge::verifier
