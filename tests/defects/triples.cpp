#include "tests/defects/triples.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <random>

#include "tests/support/measuring.h"
#include "tests/support/part_cages.h"
#include "tests/support/rasters.h"

namespace limitgauge::tests::defects {
namespace {

using model::Cage;
using model::Vec3;

constexpr double kSpacing_mm = 0.12;
constexpr double kResolution_mm = 0.01;
/// Branch and bound may give up: an interval that is wide holds the truth all the same.
constexpr std::size_t kCells = 100'000;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  // std distributions differ between libraries.
  double share() { return static_cast<double>(engine_()) / 4294967296.0; }
  double between(double a, double b) { return a + (b - a) * share(); }
  int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  bool chance(double p) { return share() < p; }

 private:
  std::mt19937 engine_;
};

/// Random heights over a few faces, some edges of which are sharp, or all.
Cage sheet(Random& random) {
  const int nx = 3 + random.below(2), ny = 3 + random.below(2);
  const double size = random.between(1.2, 2), high = random.between(0.1, 0.7);
  Cage cage = grid_cage(
      nx, ny,
      [&](int i, int j) {
        return Vec3{size * (i - nx / 2.0), size * (j - ny / 2.0), random.between(-high, high)};
      },
      random.chance(0.5) ? model::BoundaryRule::edge_and_corner : model::BoundaryRule::edge_only);
  const double sharp[] = {0, 0, 0.3, 0.6, 1};
  const double share = sharp[random.below(5)];
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      const model::Index a = j * (nx + 1) + i;
      if (i < nx && j > 0 && j < ny && random.chance(share))
        cage.creases.push_back({{a, a + 1}, model::kInfiniteSharpness});
      if (j < ny && i > 0 && i < nx && random.chance(share))
        cage.creases.push_back({{a, a + nx + 1}, random.chance(0.9) ? 10.0 : 1.5});
    }
  return cage;
}

Cage random_ridges(Random& random) {
  Ridges r;
  r.count = 1 + random.below(3);
  r.pitch_mm = random.between(0.6, 1.6), r.flank_deg = random.between(15, 60);
  r.length_mm = random.between(2, 4), r.floor_mm = random.between(0.5, 1.5);
  return placed(ridge_cage(r), {1, random.chance(0.5) ? 0 : random.between(0, 180), {}});
}

/// A way up and down along x, with upright walls now and then.
Cage random_outline(Random& random) {
  std::vector<OutlinePoint> outline = {{-3, 0}};
  while (outline.back().x < 3) {
    OutlinePoint next = outline.back();
    if (outline.size() > 1 && random.chance(0.3))
      next.z += random.chance(0.5) ? 0.6 : -0.6;
    else
      next = {next.x + random.between(0.5, 1.8), next.z + random.between(-0.8, 0.8)};
    outline.push_back(next);
  }
  return drawn_outline(outline, random.between(2, 4));
}

Cage random_boss(Random& random) {
  const Vec3 half{random.between(1, 2), random.between(1, 2), 0};
  const model::Box3 box{-half - Vec3{0, 0, random.between(0.4, 1.5)}, half};
  const Cage cage = random.chance(0.5) ? boss_cage(box) : boss_on_floor_cage(box, 1);
  return placed(cage, {1, random.chance(0.5) ? 0 : random.between(0, 90), {}});
}

Cage smooth_sheet(Random& random) {
  const int kind = random.below(3);
  if (kind == 0) return paraboloid_cage(3, random.between(-0.12, 0.12));
  if (kind == 1) return plane_cage(3, random.between(-0.5, 0.5), random.between(-0.5, 0.5));
  return placed(star_cage(3 + random.below(5), random.between(0.2, 2)), {0.12, 20, {}});
}

Cage random_cage(Random& random) {
  switch (random.below(8)) {
    case 0:
      return random_ridges(random);
    case 1:
      return random_outline(random);
    case 2:
      return random_boss(random);
    case 3:
      return smooth_sheet(random);
    default:
      return sheet(random);
  }
}

model::Cutter random_cutter(Random& random) {
  using model::CutterType;
  const double d = random.between(0.8, 5);
  switch (random.below(4)) {
    case 0:
      return {"flat", CutterType::flat, d, 0, 0, 30, {}, {}};
    case 1:
      return {"ball", CutterType::ball, d, d / 2, 0, 30, {}, {}};
    case 2:
      return {"bull", CutterType::bull, d, d * random.between(0.1, 0.4), 0, 30, {}, {}};
    default:
      return {"taper",
              CutterType::taper,
              d,
              d * random.between(0.1, 0.5),
              random.between(3, 20),
              12,
              {},
              {}};
  }
}

class PathMaker {
 public:
  PathMaker(const Target& target, const model::Cutter& cutter, double allowance_mm, double safe_z,
            Random& random)
      : target_(target),
        nose_(cutter, allowance_mm),
        box_(target.surface.bounding_box()),
        safe_(safe_z),
        random_(random) {
    path_.start = {box_.low.x, box_.low.y, safe_};
  }

  model::Toolpath make() {
    feed_to(path_, {box_.high.x, box_.low.y, safe_});
    const int kind = random_.below(8);
    if (kind < 4) rows();
    if (kind == 4 || kind == 5) slots();
    if (kind == 3 || kind == 6) plunges();
    if (path_.moves.empty()) feed_to(path_, {box_.high.x, box_.high.y, safe_});
    return std::move(path_);
  }

 private:
  Vec3 somewhere() {
    return {random_.between(box_.low.x, box_.high.x), random_.between(box_.low.y, box_.high.y), 0};
  }
  void to(const Vec3& p) { feed_to(path_, p); }

  /// Rows that follow S, too high or too low by some.
  void rows() {
    constexpr double kAlong_mm = 0.4, kAside_mm = 0.5;
    const double step = random_.between(0.25, 1.6);
    const double off = random_.chance(0.4) ? 0 : random_.between(-0.15, 0.3);
    const bool swap = random_.chance(0.5);
    const int across = swap ? 1 : 0, along = 1 - across;
    for (double c = box_.low[across] - kAside_mm; c <= box_.high[across] + kAside_mm; c += step) {
      bool down = false;
      for (double l = box_.low[along]; l <= box_.high[along]; l += kAlong_mm) {
        Vec3 p;
        p[across] = c, p[along] = l;
        const auto tip = target_.samples.drop(nose_, p.x, p.y);
        if (!tip) continue;
        p.z = tip->tip_z + off;
        if (!down) to({p.x, p.y, safe_});
        down = true;
        to(p);
      }
      if (down) to({path_.moves.back().to.x, path_.moves.back().to.y, safe_});
    }
  }
  void slots() {
    for (int k = 1 + random_.below(3); k > 0; --k) {
      Vec3 a = somewhere(), b = somewhere();
      a.z = random_.between(box_.low.z - 0.5, box_.high.z + 0.5);
      b.z = random_.chance(0.5) ? a.z : random_.between(box_.low.z - 0.5, box_.high.z + 0.5);
      to({a.x, a.y, safe_}), to(a), to(b), to({b.x, b.y, safe_});
    }
  }
  void plunges() {
    for (int k = 1 + random_.below(4); k > 0; --k) {
      const Vec3 a = somewhere();
      to({a.x, a.y, safe_});
      to({a.x, a.y, random_.between(box_.low.z - 2, box_.high.z)});
      to({a.x, a.y, safe_});
    }
  }

  const Target& target_;
  Nose nose_;
  model::Box3 box_;
  double safe_ = 0;
  Random& random_;
  model::Toolpath path_;
};

model::BoxStock random_stock(Random& random, const model::Box3& part) {
  const double above = random.chance(0.15) ? random.between(-0.3, 0) : random.between(0, 1.5);
  const double below = random.chance(0.2) ? random.between(0.05, 0.5) : random.between(1, 3);
  const double aside = random.chance(0.8) ? random.between(0.01, 2) : 0;
  const Vec3 low = part.low - Vec3{aside, aside, below};
  return {low, part.high + Vec3{aside, aside, above} - low};
}

verifier::GateLimits random_limits(Random& random) {
  verifier::GateLimits limits;
  limits.has_gouge = random.chance(0.4), limits.has_uncut = random.chance(0.4);
  limits.gouge_mm = random.between(0.01, 0.5), limits.uncut_mm = random.between(0.01, 1);
  return limits;
}

using Clock = std::chrono::steady_clock;
double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Place place_of(const verifier::Finding& f) {
  return {f.place.patch, f.place.u, f.place.v};
}
std::vector<Place> first_places(const std::vector<verifier::Finding>& findings) {
  constexpr std::size_t kFirst = 3;
  std::vector<Place> out;
  for (std::size_t k = 0; k < std::min(kFirst, findings.size()); ++k)
    out.push_back(place_of(findings[k]));
  return out;
}

/// Adds what is wrong on one side. `possible` gives the most that may be said of a place.
template <class Possible>
void hold_side(const char* what, const TripleResult::Side& side,
               const std::vector<verifier::Finding>& findings, Possible&& possible,
               std::vector<std::string>& out) {
  /// Rounding on either side; marches are one-sided.
  constexpr double kSame_mm = 1e-6;
  char text[300];
  const verifier::Interval& i = side.certified;
  const auto say = [&](const char* how, double a, double b) {
    std::snprintf(text, sizeof text, "%s [%.7f, %.7f]: %s (%.7f against %.7f)", what, i.low, i.high,
                  how, a, b);
    out.emplace_back(text);
  };
  if (!(i.low >= 0 && i.low <= i.high)) say("no interval", i.low, i.high);
  if (side.sure_mm > i.high + kSame_mm) say("a sample has more than high", side.sure_mm, i.high);
  double most = 0;
  char at[120];
  for (const verifier::Finding& f : findings) {
    if (&f - findings.data() >= 3) break;
    std::snprintf(
        at, sizeof at, "a finding at patch %d u %.9f v %.9f (%.7f, %.7f, %.7f) is not so deep",
        f.place.patch, f.place.u, f.place.v, f.place.point.x, f.place.point.y, f.place.point.z);
    const double here = possible(place_of(f));
    most = std::max(most, here);
    // A finding's depth may come from a field in single precision.
    if (f.depth_mm > here + 2e-6) say(at, f.depth_mm, here);
  }
  if (!findings.empty() && i.low > most + kSame_mm) say("no witness has low", i.low, most);
}

}  // namespace

Triple random_triple(unsigned seed) {
  Random random(seed);
  Triple out;
  out.name = "triple " + std::to_string(seed);
  out.cage = random_cage(random);
  const Target target(out.cage, 2 * kSpacing_mm);
  out.stock = random_stock(random, target.surface.bounding_box());
  const double allowances[] = {0, 0, 0.05, 0.2};
  out.check.allowance_mm = allowances[random.below(4)];
  out.check.limits = random_limits(random);
  out.check.resolution_mm = kResolution_mm;
  out.check.field_spacing_mm = 0.5;
  out.check.largest_cell_count = kCells;
  const double safe = out.stock.corner_mm.z + out.stock.size_mm.z + 1;
  for (int k = 1 + random.below(3); k > 0; --k) {
    const model::Cutter cutter = random_cutter(random);
    PathMaker maker(target, cutter, out.check.allowance_mm, safe, random);
    out.passes.push_back({cutter, shared(maker.make())});
  }
  return out;
}

TripleResult hold_against_oracle(const Triple& triple) {
  TripleResult out;
  const auto begun = Clock::now();
  const Target target(triple.cage, kSpacing_mm);
  std::vector<simulator::Pass> passes;
  for (const verifier::Pass& p : triple.passes) passes.push_back({p.cutter, p.path});
  const RunOracle oracle(target, triple.stock, passes, triple.check.allowance_mm);
  const auto measured = Clock::now();
  const verifier::StageDeviation d =
      measure_passes(target.surface, triple.stock, triple.passes, triple.check);
  out.verifier_seconds = since(measured);
  out.gouge = {d.gouge_mm, oracle.surely_gouged(first_places(d.gouges)).depth_mm};
  out.uncut = {d.uncut_mm, oracle.surely_uncut(first_places(d.uncuts)).depth_mm};
  out.missing = {d.missing_stock_mm, oracle.surely_missing().depth_mm};
  hold_side(
      "gouge", out.gouge, d.gouges, [&](const Place& p) { return oracle.possibly_gouged(p); },
      out.contradictions);
  hold_side(
      "uncut", out.uncut, d.uncuts, [&](const Place& p) { return oracle.possibly_uncut(p); },
      out.contradictions);
  hold_side(
      "missing stock", out.missing, d.missing_stock,
      [&](const Place& p) { return oracle.possibly_missing(p); }, out.contradictions);
  out.oracle_seconds = since(begun) - out.verifier_seconds;
  return out;
}

}  // namespace limitgauge::tests::defects
