#include "verifier/certificate/run_tracer.h"

#include <algorithm>
#include <cmath>

#include "verifier/cells/normal_cone.h"
#include "verifier/cells/surface_crossing.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Steps of one run: what is grazed longer is cut short there, which is a bound as well.
constexpr int kMostSteps = 400;
/// Up to here a run is followed before S is asked where it ends it: most runs are shorter, and what
/// lies beyond that end need not be looked through.
constexpr double kFirstLook_mm = 2;

}  // namespace

TracedRun RunTracer::material(const Vec3& s, const Vec3& n, double allowance_mm, double limit_mm,
                              double least_mm) const {
  const auto crossing_before = [&](double length_mm) {
    return next_crossing_mm(cells_, s, n, Way::outwards, allowance_mm, allowance_mm + length_mm) -
           allowance_mm;
  };
  const Vec3 from = s + n * allowance_mm;
  TracedRun run;
  const double near_mm = std::min(limit_mm, kFirstLook_mm);
  if (!stands_up_to(near_mm, from, n, run) || near_mm == limit_mm) {
    if (run.length_mm <= least_mm) return run;
    const double crossing = crossing_before(run.length_mm);
    if (crossing < run.length_mm) run.length_mm = crossing, run.meets_surface = true;
    return run;
  }
  const double crossing = crossing_before(limit_mm), end = std::min(crossing, limit_mm);
  if (crossing <= near_mm) run.length_mm = crossing;
  stands_up_to(end, from, n, run);
  run.meets_surface = crossing < limit_mm && run.length_mm >= crossing;
  return run;
}

/// Follows a run outwards from where it has come to; whether it goes on at `limit_mm`.
bool RunTracer::stands_up_to(double limit_mm, const Vec3& from, const Vec3& n,
                             TracedRun& run) const {
  constexpr EndRule kEnds{kSkin_mm, kBeside_mm, kAlong};
  for (int step = 0; step < kMostSteps && run.length_mm < limit_mm; ++step) {
    const auto met =
        space_.first_met(from + n * run.length_mm, n, limit_mm - run.length_mm, kEnds, far_.get());
    run.length_mm += met.t_mm, run.body = met.body;
    if (!met.body) return true;
    // A slit thinner than a skin, as between a cut and material that touches its edge, ends no run.
    const double past = run.length_mm + kStepOver_mm;
    const auto [body, next] = space_.nearest_grown(from + n * past, met.body, far_.get());
    if (kEnds.is_met(next.value - space_.error_mm(body), next.gradient, n)) return false;
    run.length_mm = std::min(past, limit_mm);
  }
  return run.length_mm >= limit_mm;
}

/// The last place along the ray, from t on where the body holds it, that the body still holds.
double RunTracer::exit_of(BodyRef body, const Vec3& p, const Vec3& along, double t,
                          double limit_mm) const {
  const auto depth = [&](double at) {
    return -space_.distance(body, p + along * at).value - space_.error_mm(body);
  };
  double inside = t, here = depth(t);
  if (const MeshOutside* mesh = space_.mesh_of(body)) {
    if (here <= kSkin_mm / 2) return std::min(inside, limit_mm);
    return inside + mesh->same_side_up_to(p + along * inside, along, limit_mm - inside,
                                          space_.chord_error_mm() + kDistanceRounding_mm);
  }
  if (space_.is_concave(body) || space_.turns(body)) {
    // These are not convex, so by steps that are no longer than the place is deep.
    for (int step = 0; step < kMostSteps && here > kSkin_mm / 2 && inside < limit_mm; ++step)
      inside += here, here = depth(inside);
    return std::min(inside, limit_mm);
  }
  // Convex: what lies between two places inside is inside.
  double outside = inside;
  for (double by = std::max(here, kSkin_mm); outside < limit_mm; by *= 2) {
    outside = std::min(inside + by, limit_mm);
    here = depth(outside);
    if (here < 0) break;
    inside = outside;
  }
  while (outside - inside > kDistanceRounding_mm) {
    const double middle = (inside + outside) / 2;
    (depth(middle) >= 0 ? inside : outside) = middle;
  }
  return inside;
}

/// Up to where nothing stands next to the ray either, where a wall runs along it, by which S is
/// met; the limit where none does. `p` is where the ray begins, `at` the nearest body at t.
double RunTracer::free_beside(const Nearest& at, const Vec3& p, const Vec3& along, double t,
                              double limit_mm) const {
  const Vec3& g = at.distance.gradient;
  if (at.distance.value < -kBeside_mm || std::abs(dot(g, along)) > kAlong) return limit_mm;
  // Just past the face that may end here.
  const Vec3 beside = p + g * (2 * kBeside_mm);
  const double past = t + kStepOver_mm;
  const Nearest next = space_.nearest(beside + along * past, {}, far_.get());
  if (next.distance.value > 0) return t;
  return exit_of(next.body, beside, along, past, limit_mm);
}

/// Whether what stands at p, a film's thickness along a ray, is the thin end of more: where a ray
/// passes through the material just beside a sharp edge of it.
bool RunTracer::is_wedge(const Vec3& p, const Vec3& along) const {
  const Vec3 e = across(along);
  const Vec3 f = cross(along, e);
  for (const Vec3& aside : {e, -e, f, -f})
    if (space_.nearest(p + aside * kBeside_mm, {}, far_.get()).distance.value > kStepOver_mm)
      return true;
  return false;
}

/// From body to body through what does not stand; `visit(body, begin, end)` is told of each.
/// Returns where something stands, or the limit.
template <class Visit>
double RunTracer::walk_removed(const Vec3& p, const Vec3& along, double limit_mm,
                               Visit&& visit) const {
  double t = 0;
  std::optional<BodyRef> hint;
  for (int step = 0; step < kMostSteps && t < limit_mm; ++step) {
    Nearest nearest = space_.nearest_shrunk(p + along * t, hint, far_.get());
    hint = nearest.body;
    const auto may_stand = [&] {
      return nearest.distance.value >= -kSkin_mm - space_.error_mm(nearest.body);
    };
    if (may_stand()) {
      // Two bodies that meet face to face leave no film between them.
      nearest = space_.nearest_shrunk(p + along * (t + kStepOver_mm), hint, far_.get());
      if (may_stand() || is_wedge(p + along * (t + kStepOver_mm / 2), along)) break;
      t += kStepOver_mm;
    }
    const double end = std::min(exit_of(nearest.body, p, along, t, limit_mm),
                                free_beside(nearest, p, along, t, limit_mm));
    if (!(end > t)) break;
    visit(nearest.body, t, end);
    t = end;
  }
  return t;
}

/// What was swept along the ray from one t to another, between which it lies outside the raw stock.
template <class Visit>
void RunTracer::visit_swept(const Vec3& p, const Vec3& along, double from, double to,
                            Visit&& visit) const {
  for (int step = 0; step < kMostSteps && from < to; ++step) {
    const auto met = space_.first_met_swept(p + along * from, along, to - from, far_.get());
    if (!met.body) return;
    from += met.t_mm;
    const double room =
        space_.distance(*met.body, p + along * from).value + space_.chord_error_mm();
    if (room > 0) {
      from += std::max(room, kStepOver_mm);
      continue;
    }
    const double end = exit_of(*met.body, p, along, from, to);
    visit(*met.body, end);
    from = end + kStepOver_mm;
  }
}

TracedRun RunTracer::removed(const Vec3& s, const Vec3& n, double allowance_mm, double limit_mm,
                             double least_mm, bool stock_counts) const {
  const auto run_within = [&](double limit) {
    TracedRun run;
    const Vec3 from = s + n * allowance_mm;
    const auto see = [&](BodyRef body, double end) { run = {end, body, false}; };
    walk_removed(from, -n, limit, [&](BodyRef body, double begin, double end) {
      if (stock_counts || !space_.is_stock(body)) return see(body, end);
      visit_swept(from, -n, begin, end, see);
    });
    return run;
  };
  // t counts from s, inwards.
  const auto crossing_before = [&](double to) {
    return next_crossing_mm(cells_, s, n, Way::inwards, -allowance_mm, to);
  };
  // Beside the raw stock nothing else may end the run: S is looked for first.
  const bool is_beside = space_.stock_distance_mm(s + n * allowance_mm) < 0;
  double crossing = limit_mm - allowance_mm;
  if (is_beside) crossing = crossing_before(crossing);
  TracedRun run = run_within(crossing + allowance_mm);
  if (run.length_mm <= least_mm) return run;
  if (!is_beside) {
    const double to = run.length_mm - allowance_mm;
    crossing = crossing_before(to);
    if (crossing >= to) return run;
    // What a body swept beyond the crossing says nothing of the way there.
    run = run_within(crossing + allowance_mm);
  }
  run.meets_surface =
      crossing + allowance_mm < limit_mm && run.length_mm >= crossing + allowance_mm;
  return run;
}

double RunTracer::free_length_mm(const Vec3& p, const Vec3& along, double limit_mm) const {
  return walk_removed(p, along, limit_mm, [](BodyRef, double, double) {});
}

}  // namespace limitgauge::verifier
