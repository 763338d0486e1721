#include "tests/defects/oracle.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;

constexpr double kNowhere = -std::numeric_limits<double>::infinity();
/// Films: material or air thinner than this says nothing for certain ...
constexpr double kSure_mm = 2e-6;
/// ... and thinner than this is passed over where a run may go on.
constexpr double kPossible_mm = 1e-5;
/// Climbs end at steps of this; what they found is certain all the same.
constexpr double kFinest_mm = 1e-4;
constexpr std::size_t kStarts = 4;
constexpr double kStartsApart_mm = 0.3;
constexpr int kFan = 8, kFineFan = 48;

std::vector<model::Cutter> cutters_of(std::span<const simulator::Pass> passes) {
  std::vector<model::Cutter> out;
  for (const simulator::Pass& p : passes) out.push_back(p.cutter);
  return out;
}

std::shared_ptr<const simulator::SweepIndex> sweep(const simulator::Pass& pass) {
  return std::make_shared<const simulator::SweepIndex>(pass);
}

/// A cylinder of the tool above its flutes, as a flat cutter on a path of its own.
simulator::Pass lifted(const simulator::Pass& pass, const model::CylinderPart& part,
                       double lift_mm) {
  model::Toolpath path = *pass.path;
  path.start.z += lift_mm;
  for (model::Move& m : path.moves) m.to.z += lift_mm;
  model::Cutter body{"body", model::CutterType::flat, part.diameter_mm, 0, 0, part.length_mm, {},
                     {}};
  return {body, std::make_shared<const model::Toolpath>(std::move(path))};
}

/// What a march gives up with: nothing more for a run that must be certain, all for one that may
/// be.
enum class Claim { sure, possible };

/// How far f stays above `end`, in steps that f itself allows (it changes by no more than the way).
template <class F>
double march(F&& f, Claim claim, double limit, int most_steps = 30'000) {
  // What nothing ends may be stated as longer than all of the scene by any length.
  constexpr double kBeyond_mm = 5;
  if (claim == Claim::possible) limit += kBeyond_mm;
  const double end = claim == Claim::sure ? kSure_mm : -kPossible_mm / 2;
  const double least_step = claim == Claim::sure ? kSure_mm / 2 : kPossible_mm / 2;
  double t = 0;
  for (int step = 0; step < most_steps && t < limit; ++step) {
    const double here = f(t);
    if (!(here > end)) return t;
    t += std::max(here - end, least_step);
  }
  return t < limit && claim == Claim::sure ? t : limit;
}

/// The verifier states that what lies half a micrometre beside a normal may count as met by it. So
/// a place surely has what the normals this far beside it have as well, and may have what any has.
constexpr double kBeside_mm = 7.5e-4;

/// A run's value at a point and four beside it, gathered by `pick`.
template <class Run, class Pick>
double with_beside(const Vec3& point, const Vec3& normal, Run&& run, Pick&& pick) {
  const Vec3 e =
      normalized(cross(normal, std::abs(normal.z) < 0.7 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
  const Vec3 f = cross(normal, e);
  double out = run(point);
  for (const Vec3& aside : {e, -e, f, -f}) out = pick(out, run(point + aside * kBeside_mm));
  return out;
}
double lesser(double a, double b) {
  return std::min(a, b);
}
double greater(double a, double b) {
  return std::max(a, b);
}

}  // namespace

RunOracle::RunOracle(const Target& target, const model::Stock& stock,
                     std::span<const simulator::Pass> passes,
                     std::span<const simulator::Pass> stated, double allowance_mm)
    : target_(target),
      raw_(stock),
      allowance_(allowance_mm),
      reach_(target.samples, cutters_of(stated), allowance_mm) {
  model::Box3 all = raw_.box();
  all.add(target.surface.bounding_box());
  longest_ = length(all.size());
  for (const simulator::Pass& pass : passes) {
    if (pass.path->moves.empty()) continue;
    flutes_.push_back(sweep(pass));
    everything_.push_back(flutes_.back());
    double lift = pass.cutter.flute_length_mm;
    for (const auto* parts : {&pass.cutter.shank, &pass.cutter.holder})
      for (const model::CylinderPart& part : *parts) {
        everything_.push_back(sweep(lifted(pass, part, lift)));
        lift += part.length_mm;
      }
  }
}

double RunOracle::least(const Bodies& bodies, const Vec3& p) {
  constexpr double kFar_mm = 1e3;
  double out = kFar_mm;
  for (const auto& body : bodies)
    if (const auto nearest = body->nearest(p, out)) out = std::min(out, nearest->at.distance);
  return out;
}

double RunOracle::swept_distance_mm(const Vec3& p) const {
  return least(flutes_, p);
}

double RunOracle::inside_material(const Bodies& swept, const Vec3& p) const {
  const double depth = -raw_.distance(p).distance;
  return depth <= 0 ? depth : std::min(depth, least(swept, p));
}

/// A run that begins `from_mm` along a ray from s is ended by S. What crosses the way before it
/// begins ends what must be certain, and nothing of what may be.
double RunOracle::ended_by_surface(const Vec3& point, const Vec3& along, const Vec3& normal,
                                   double from_mm, double run_mm, bool sure) const {
  constexpr double kPast_mm = 1e-5;
  if (run_mm <= 0) return 0;
  const double least = (sure ? std::min(from_mm, 0.0) : from_mm) + kPast_mm;
  const auto c = target_.crossings.first(point, along, least, from_mm + run_mm, point, normal);
  return std::clamp((sure ? c.possible : c.sure) - from_mm, 0.0, run_mm);
}

double RunOracle::sure_uncut(const Vec3& point, const Vec3& normal, int most_steps) const {
  const Vec3 from = point + normal * allowance_;
  const double run = march([&](double t) { return inside_material(flutes_, from + normal * t); },
                           Claim::sure, longest_, most_steps);
  return ended_by_surface(point, normal, normal, allowance_, run, true);
}

double RunOracle::possible_uncut(const Vec3& point, const Vec3& normal) const {
  const Vec3 from = point + normal * (allowance_ + kPossible_mm);
  // What starts in air has no run.
  if (inside_material(flutes_, from) <= -kPossible_mm) return 0;
  const double run = march([&](double t) { return inside_material(flutes_, from + normal * t); },
                           Claim::possible, longest_);
  return ended_by_surface(point, normal, normal, allowance_, run + 2 * kPossible_mm, false);
}

double RunOracle::gouge_run(const Vec3& point, const Vec3& normal, bool sure,
                            int most_steps) const {
  const Vec3 from = point + normal * (sure ? allowance_ : allowance_ - kPossible_mm);
  const double needed = sure ? kSure_mm : -kPossible_mm;
  double last = 0;
  // How far no material is: inside what was swept its depth, outside the raw stock the way there.
  const auto free = [&](double t) {
    const Vec3 p = from - normal * t;
    const double swept = -least(everything_, p), outside = raw_.distance(p).distance;
    if (swept <= needed) return outside;
    last = std::max(last, t + std::max(swept, 0.0));
    // No further than what was swept is sure to go on: it may end outside the raw stock.
    return swept > 0 ? swept : std::max(swept, outside);
  };
  double run = march(free, sure ? Claim::sure : Claim::possible, longest_, most_steps);
  if (sure) run = std::min(run, longest_);
  run = std::min(run, last);
  if (!sure && run > 0) run += 2 * kPossible_mm;
  const double ended = ended_by_surface(point, -normal, normal, -allowance_, run, sure);
  if (!sure || ended >= run) return ended;
  // What was swept beyond the crossing says nothing of the way there.
  last = 0;
  march(free, Claim::sure, ended, most_steps);
  return std::min(ended, last);
}

double RunOracle::missing_run(const Vec3& point, const Vec3& normal, bool sure) const {
  const Vec3 from = sure ? point : point - normal * kPossible_mm;
  const double run = march([&](double t) { return raw_.distance(from - normal * t).distance; },
                           sure ? Claim::sure : Claim::possible, longest_);
  return ended_by_surface(point, -normal, normal, 0,
                          sure || run <= 0 ? run : run + 2 * kPossible_mm, sure);
}

/// A vertex's own normal may be a limit that nothing comes near to: what is certain there is what
/// its faces come to beside it.
Place RunOracle::off_vertex(Place place) {
  static constexpr double kAside = 1e-6;
  const auto moved = [](double p) { return std::clamp(p, kAside, 1 - kAside); };
  const Place inner{place.patch, moved(place.u), moved(place.v)};
  return inner.u != place.u && inner.v != place.v ? inner : place;
}

/// The highest `run(place, point, normal, at_least)` over samples and climbs from the best of them:
/// a run that is no more than `at_least` need not be worked out. Where `sharp`, the fans of sharp
/// places too, each direction of which climbs along its edge for itself.
template <class Run>
Extreme RunOracle::highest(const std::vector<Place>& hints, bool sharp, Run&& run) const {
  const auto& nodes = target_.samples.nodes();
  struct Value {
    double value;
    std::size_t node;
  };
  std::vector<Value> values;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double value = run(nodes[k].point, nodes[k].normal, kNowhere, false);
    if (value > 0) values.push_back({value, k});
  }
  std::stable_sort(values.begin(), values.end(),
                   [](const Value& a, const Value& b) { return a.value > b.value; });
  std::vector<Place> starts = hints;
  std::vector<std::size_t> taken;
  std::size_t refused = 0;
  constexpr std::size_t kMostRefused = 80;
  for (const Value& v : values) {
    if (taken.size() == kStarts || refused == kMostRefused) break;
    const bool near = std::any_of(taken.begin(), taken.end(), [&](std::size_t o) {
      return nodes[o].place.patch == nodes[v.node].place.patch &&
             distance(nodes[o].point, nodes[v.node].point) < kStartsApart_mm;
    });
    if (near) continue;
    if (run(nodes[v.node].point, nodes[v.node].normal, 0, true) <= 0) {
      ++refused;
      continue;
    }
    taken.push_back(v.node), starts.push_back(nodes[v.node].place);
  }
  Extreme best;
  for (const Place& start : starts) {
    double found = 0, reached = 0;
    const Place place = target_.samples.climb(
        start,
        [&](const Place& at, const verifier::SurfaceSample& there) {
          const Place inner = off_vertex(at);
          const verifier::SurfaceSample s = inner.u == at.u ? there : target_.samples.at(inner);
          const double here = run(s.position, s.normal, reached, true);
          if (here <= reached) return kNowhere;
          return reached = here;
        },
        kFinest_mm, found);
    if (found > best.depth_mm) best = {found, place};
  }
  if (!sharp) return best;
  struct Leaning {
    double value;
    std::size_t edge;
    Vec3 normal;
  };
  std::vector<Leaning> leaning;
  const auto& edge = target_.sharp.samples();
  for (std::size_t k = 0; k < edge.size(); ++k) {
    const Vec3 point = target_.samples.at(edge[k]).position;
    for (const Vec3& n : target_.sharp.fan(edge[k], kFan)) {
      const double here = run(point, n, kNowhere, false);
      if (here > best.depth_mm) leaning.push_back({here, k, n});
    }
  }
  std::stable_sort(leaning.begin(), leaning.end(),
                   [](const Leaning& a, const Leaning& b) { return a.value > b.value; });
  constexpr std::size_t kMostLooks = 150;
  for (std::size_t k = 0; k < std::min(kMostLooks, leaning.size()); ++k) {
    // The longest first; then some from everywhere.
    const std::size_t spread =
        leaning.size() > kMostLooks && k % 2 == 1 ? k * (leaning.size() / kMostLooks) : k;
    const Leaning& l = leaning[spread];
    if (l.value <= best.depth_mm) continue;
    const double here =
        run(target_.samples.at(edge[l.edge]).position, l.normal, best.depth_mm, true);
    if (here > best.depth_mm) best = {here, edge[l.edge]};
  }
  return best;
}

namespace {
/// Of a march that must be certain: a few to choose where to look, many there.
int steps(bool exact) {
  return exact ? 20'000 : 1000;
}
}  // namespace

Extreme RunOracle::surely_uncut(const std::vector<Place>& hints) const {
  return highest(hints, true, [&](const Vec3& p, const Vec3& n, double at_least, bool in_reach) {
    const auto run = [&](const Vec3& q) { return sure_uncut(q, n, steps(in_reach)); };
    double here = run(p);
    if (here <= 0 || here <= at_least || !in_reach) return here;
    here = with_beside(p, n, run, lesser);
    return here > at_least && reach_.at(p, n, Reach::sure) == Reach::sure ? here : 0.0;
  });
}

Extreme RunOracle::surely_gouged(const std::vector<Place>& hints) const {
  // The least over a sharp place's normals is no more than beside it.
  return highest(hints, false, [&](const Vec3& p, const Vec3& n, double, bool exact) {
    const auto run = [&](const Vec3& q) { return gouge_run(q, n, true); };
    return exact ? with_beside(p, n, run, lesser) : run(p);
  });
}

Extreme RunOracle::surely_missing() const {
  return highest({}, false, [&](const Vec3& p, const Vec3& n, double, bool exact) {
    const auto run = [&](const Vec3& q) { return missing_run(q, n, true); };
    return exact ? with_beside(p, n, run, lesser) : run(p);
  });
}

double RunOracle::possibly_uncut(const Place& place) const {
  double most = 0;
  for (const Place& near : target_.sharp.beside(place)) {
    const Vec3 point = target_.samples.at(near).position;
    Vec3 best;
    const auto look = [&](const Vec3& n) {
      const double here = with_beside(
          point, n, [&](const Vec3& q) { return possible_uncut(q, n); }, greater);
      if (here > most && reach_.at(point, n) != Reach::no) most = here, best = n;
    };
    const std::vector<Vec3> fan = target_.sharp.fan(near, kFineFan);
    for (const Vec3& n : fan) look(n);
    if (fan.size() < 2) continue;
    // Between the normals of the fan, ever closer to the best of them.
    for (double step = std::numbers::pi / kFineFan; step > 1e-5 && length(best) > 0; step /= 2) {
      const Vec3 from = best;
      for (const Vec3& face : target_.sharp.span_at(near).faces)
        look(normalized(from + (face - from) * step)),
            look(normalized(from - (face - from) * step));
    }
  }
  return most;
}

template <class Run>
double RunOracle::possible_of_faces(const Place& place, Run&& run) const {
  double most = 0;
  for (const Place& near : target_.sharp.beside(place)) {
    const Vec3 point = target_.samples.at(near).position;
    for (const Vec3& n : target_.sharp.span_at(near).faces)
      most = std::max(most, with_beside(
                                point, n, [&](const Vec3& q) { return run(q, n); }, greater));
  }
  return most;
}

double RunOracle::possibly_gouged(const Place& place) const {
  return possible_of_faces(place,
                           [&](const Vec3& q, const Vec3& n) { return gouge_run(q, n, false); });
}

double RunOracle::possibly_missing(const Place& place) const {
  return possible_of_faces(place,
                           [&](const Vec3& q, const Vec3& n) { return missing_run(q, n, false); });
}

}  // namespace limitgauge::tests::defects
