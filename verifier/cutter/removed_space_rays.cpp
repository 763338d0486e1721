#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/geometry/box_tree.h"
#include "verifier/cutter/removed_space.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {

using model::Vec3;

namespace {

/// Steps to where a ray meets one body: far more than a tangent that touches takes.
constexpr int kMostSteps = 400;

/// The first t in [0, limit_mm) at which the ray meets a body whose distance, less its error, is
/// `distance(t)`; the limit where there is none. A convex one lies above its planes, whose zeros
/// come before its own; of others a step is no longer than the place is far.
template <class Distance>
double first_meeting(Distance&& distance, const Vec3& ray, bool is_convex, double limit_mm,
                     const EndRule& rule) {
  double t = 0;
  for (int step = 0; step < kMostSteps && t < limit_mm; ++step) {
    const BodyDistance d = distance(t);
    if (rule.is_met(d.value, d.gradient, ray)) return t;
    const double closing = is_convex ? -dot(d.gradient, ray) : 1;
    if (closing <= 0) return limit_mm;
    const double wanted = d.value > rule.beside_mm + kDistanceRounding_mm ? rule.beside_mm : 0;
    t += std::max(d.value - d.slack_mm - wanted, kDistanceRounding_mm / 2) / closing;
  }
  return std::min(t, limit_mm);
}

/// The same of one whose distance is not convex, where `clear(from, to)` proves that it is not met
/// between: in steps that grow while that is proven, and no longer than the place is far where not.
template <class Distance, class Clear>
double first_meeting_by_steps(Distance&& distance, Clear&& clear, const Vec3& ray, double from_mm,
                              double limit_mm, const EndRule& rule) {
  constexpr double kShort_mm = 1e-2;  // to be done with in one step
  double t = from_mm, step = 0;
  for (int n = 0; n < kMostSteps && t < limit_mm; ++n) {
    const BodyDistance d = distance(t);
    if (rule.is_met(d.value, d.gradient, ray)) return t;
    const double wanted = d.value > rule.beside_mm + kDistanceRounding_mm ? rule.beside_mm : 0;
    const double sure = std::max(d.value - d.slack_mm - wanted, kDistanceRounding_mm / 2);
    step = std::max(2 * step, std::min(limit_mm - t, kShort_mm));
    while (step > sure && !clear(t, t + step)) step /= 4;
    step = std::max(step, sure);
    t += step;
  }
  return std::min(t, limit_mm);
}

/// The first t in [0, limit_mm] up to which steps are proven to meet nothing, `room(t)` being how
/// far from t that is: a few of them, which is what bounds are good for.
template <class Room>
double clear_up_to(Room&& room, double limit_mm) {
  constexpr int kSteps = 4;
  double t = 0;
  for (int k = 0; k < kSteps && t < limit_mm; ++k) {
    const double step = room(t);
    if (step <= 0) break;
    t += step;
  }
  return t;
}

/// Meetings that are further away are looked for among what is near, or from the root.
constexpr double kNearMeeting_mm = 0.1, kNearRoots_mm = 0.5;

/// Of a turning body the exact distance only where it is near: afar a step that is a little shorter
/// than it might be costs less.
BodyDistance distance_from_afar(const PassBodies& bodies, std::uint32_t place, const Vec3& p,
                                double near_mm) {
  constexpr double kAfar_mm = 1e-3, kRoughly_mm = 1e-4;
  if (bodies.turn()) {
    const BodyDistance d = bodies.distance_at(place, p, kRoughly_mm);
    if (d.value - d.slack_mm > near_mm + kAfar_mm) return d;
  }
  return bodies.distance_at(place, p);
}

}  // namespace

bool EndRule::is_met(double distance_mm, const Vec3& gradient, const Vec3& ray) const {
  if (distance_mm <= skin_mm) return true;
  return distance_mm <= beside_mm + kDistanceRounding_mm && std::abs(dot(gradient, ray)) <= along;
}

/// Where a ray of a pass's own frame meets the body at `place`, before `limit_mm`.
double RemovedSpace::meeting_with(const PassBodies& bodies, std::uint32_t place, const Vec3& p,
                                  const Vec3& ray, double limit_mm, const EndRule& rule) const {
  const double near = near_mm(rule) + kDistanceRounding_mm;
  const auto distance = [&](double t) {
    BodyDistance d = distance_from_afar(bodies, place, p + ray * t, near);
    d.value -= chord_error_mm_;
    return d;
  };
  if (!bodies.turn()) return first_meeting(distance, ray, true, limit_mm, rule);
  const auto clear = [&](double a, double b) {
    const std::array ends{p + ray * a, p + ray * b};
    return bodies.lower_at(place, ends, p + ray * ((a + b) / 2), near) >= near;
  };
  const double start = clear_up_to(
      [&](double t) { return bodies.bound_at(place, p + ray * t, near) - near; }, limit_mm);
  return first_meeting_by_steps(distance, clear, ray, start, limit_mm, rule);
}

void RemovedSpace::first_met_in(std::uint32_t pass, const Vec3& from, const Vec3& along,
                                const EndRule& rule, Meeting& first, FarPasses* far) const {
  const Vec3 p = passes_[pass].place(from - shift_);
  const Vec3 ray = passes_[pass].direction(along);
  const PassBodies& bodies = *passes_[pass];
  const double near = near_mm(rule) + kDistanceRounding_mm;
  const auto start_of = [&](const model::BoxNode& node) {
    return clear_up_to(
        [&](double t) {
          // What is further away than the rest of the ray need not be known better.
          const double limit = bodies.turn() ? near : near + first.t_mm - t;
          return bodies.bound(node, p + ray * t, limit) - near;
        },
        first.t_mm);
  };
  const auto look = [&](const model::BoxNode& leaf) {
    for (std::uint32_t k = leaf.first; k < leaf.first + leaf.count; ++k) {
      const BodyRef body{pass, bodies.move_at(k)};
      if (body == first.body) continue;
      const double t = meeting_with(bodies, k, p, ray, first.t_mm, rule);
      if (t < first.t_mm) first = {t, body};
    }
  };
  // What is met before then is no further away than that.
  const auto* ring =
      first.t_mm <= kNearMeeting_mm ? near_ring(pass, p, near + first.t_mm, far) : nullptr;
  if (!ring)
    return model::nearest_first(
        bodies.nodes(),
        roots_near(pass, p, near + first.t_mm, first.t_mm <= kNearRoots_mm ? far : nullptr),
        start_of, [&](double start) { return start >= first.t_mm; }, look);
  for (const std::uint32_t leaf : ring->leaves)
    if (const model::BoxNode& node = bodies.nodes()[leaf]; start_of(node) < first.t_mm) look(node);
}

/// The body that is nearest where the ray begins is most often the one that it meets, and what it
/// leaves to be looked through is short. An upright one is found once more, which takes little, so
/// that among equals the one that is named does not depend on where the search began.
void RemovedSpace::first_met_of_nearest(const Vec3& p, const Vec3& ray, const EndRule& rule,
                                        Meeting& first, FarPasses* far) const {
  const BodyRef body = nearest(p, {}, far).body;
  if (is_stock(body)) return;
  const PlacedPass& pass = passes_[body.pass];
  const double t = meeting_with(*pass, pass->place_of(body.index), pass.place(p - shift_),
                                pass.direction(ray), first.t_mm, rule);
  if (!(t < first.t_mm)) return;
  if (pass->turn())
    first = {t, body};
  else
    first = {std::nextafter(t, std::numeric_limits<double>::infinity()), {}};
}

void RemovedSpace::first_met_of_stock(const Vec3& p, const Vec3& ray, const EndRule& rule,
                                      Meeting& first) const {
  const auto outside = static_cast<std::uint32_t>(passes_.size());
  for (std::uint32_t face = 0; face < (mesh_ ? 1 : stock_faces()); ++face) {
    const BodyRef body{outside, face};
    const auto distance = [&](double t) { return this->distance(body, p + ray * t); };
    const bool is_convex = !mesh_ && !is_concave(body);
    const double t = first_meeting(distance, ray, is_convex, first.t_mm, rule);
    if (t < first.t_mm) first = {t, body};
  }
}

RemovedSpace::Meeting RemovedSpace::first_met(const Vec3& p, const Vec3& ray, double limit_mm,
                                              const EndRule& rule, FarPasses* far) const {
  Meeting first{limit_mm, {}};
  if (!mesh_) first_met_of_stock(p, ray, rule, first);
  // Beside a mesh the search for the nearest body takes longer than it saves, but of turning ones.
  if (turns_ || (far && !mesh_)) first_met_of_nearest(p, ray, rule, first, far);
  const double near = near_mm(rule);
  for (auto k = static_cast<std::uint32_t>(passes_.size()); k-- > 0;)
    if (!far || far->bound(k, p) - first.t_mm <= near) first_met_in(k, p, ray, rule, first, far);
  if (mesh_) first_met_of_stock(p, ray, rule, first);
  return first;
}

RemovedSpace::Meeting RemovedSpace::first_met_swept(const Vec3& p, const Vec3& ray, double limit_mm,
                                                    FarPasses* far) const {
  Meeting first{limit_mm, {}};
  for (auto k = static_cast<std::uint32_t>(passes_.size()); k-- > 0;)
    first_met_in(k, p, ray, {}, first, far);
  return first;
}

}  // namespace limitgauge::verifier
