// Passes that turn their tool as they go: nothing of a verdict depends on how a fixed axis is
// stated, a ball does not care how it stands, and certified figures are those of thousands of
// poses.

#include <algorithm>
#include <cmath>
#include <random>

#include "model/base/angle.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/measuring.h"
#include "tests/support/rasters.h"
#include "verifier/cutter/removed_space.h"

namespace limitgauge::verifier {
namespace {

using model::Pose;
using model::Vec3;
using namespace tests;

StageCheck turning_check(double resolution_mm) {
  StageCheck check;
  check.resolution_mm = resolution_mm;
  // Beyond all figures: no places are looked for but the deepest.
  check.limits.has_gouge = check.limits.has_uncut = true;
  check.limits.gouge_mm = check.limits.uncut_mm = 5;
  check.field_spacing_mm = 1;
  return check;
}

double dome_height(double x, double y) {
  return -0.05 * (x * x + y * y);
}
Vec3 dome_normal(double x, double y) {
  return model::normalized({0.1 * x, 0.1 * y, 1});
}

/// A path with an axis at the end of each move.
struct TurningPath {
  model::Toolpath path;
  model::ToolAxes axes;

  void feed(const Vec3& tip, const Vec3& axis) {
    if (path.moves.empty()) path.start = tip, axes.start = axis;
    feed_to(path, tip);
    axes.to.push_back(axis);
  }
  Pass pass(const model::Cutter& cutter) const {
    Pass out{cutter, shared(path)};
    out.axes = std::make_shared<const model::ToolAxes>(axes);
    return out;
  }
};

/// Rows over the dome; `stand(x, y)` is the axis there, `touch(x, y, axis)` the tip.
template <class Stand, class Touch>
TurningPath dome_rows(double half_mm, double step_mm, double along_mm, const Stand& stand,
                      const Touch& touch) {
  TurningPath out;
  along_rows(half_mm, step_mm, along_mm, [&](double x, double y) {
    const Vec3 axis = stand(x, y);
    out.feed(touch(x, y, axis), axis);
  });
  return out;
}

/// The tip of a bull whose corner circle, or a ball, touches S, `deep_mm` below it.
Vec3 touching_tip(const model::Cutter& cutter, const Vec3& place, const Vec3& normal,
                  const Vec3& axis, double deep_mm) {
  const double r = cutter.corner_radius_mm, flat = cutter.radius_mm() - r;
  const Vec3 across = normal - axis * dot(normal, axis);
  const Vec3 centre = place + normal * (r - deep_mm);
  return centre + model::normalized(across) * flat - axis * r;
}

/// The union of single poses: what a pass sweeps, but for what lies between them.
class PosesOfPass {
 public:
  PosesOfPass(const model::Cutter& cutter, const TurningPath& path, int a_move) : profile_(cutter) {
    for (std::size_t i = 0; i < path.path.moves.size(); ++i)
      for (int k = 0; k <= a_move; ++k) {
        const double t = static_cast<double>(k) / a_move;
        const Vec3 &u = model::axis_from(path.axes, i), &w = path.axes.to[i];
        const double angle = model::angle_between(u, w);
        const Vec3 axis = angle < 1e-9 ? u
                                       : (u * std::sin((1 - t) * angle) + w * std::sin(t * angle)) /
                                             std::sin(angle);
        poses_.push_back({lerp(model::move_from(path.path, i), path.path.moves[i].to, t), axis});
      }
  }
  double distance(const Vec3& p) const {
    double least = 1e300;
    for (const auto& [tip, axis] : poses_) {
      const double height = dot(p - tip, axis);
      const double rho = length(p - tip - axis * height);
      least = std::min(least, closed_distance(profile_, rho, height).value);
    }
    return least;
  }
  /// How far a run from p goes through what is swept, or through what is not.
  double run(const Vec3& p, const Vec3& along, bool swept, double limit_mm) const {
    double t = 0;
    while (t < limit_mm) {
      const double d = distance(p + along * t) * (swept ? -1 : 1);
      if (d <= 1e-7) break;
      t += d;
    }
    return std::min(t, limit_mm);
  }

 private:
  struct Standing {
    Vec3 tip, axis;
  };
  CutterProfile profile_;
  std::vector<Standing> poses_;
};

}  // namespace

TEST_CASE("an axis that leans and does not turn is a pass that leans", "[property]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(-8, 8);
  const model::Cutter cutters[] = {
      ball_cutter(2), flat_cutter(3), {"bull", model::CutterType::bull, 8, 1, 0, 20, {}, {}}};
  for (const model::Cutter& cutter : cutters) {
    Pose pose = model::turn_about({1, 2, 3}, 37);
    pose.shift_mm = {-2, 5, 0.5};
    TurningPath own;
    model::Toolpath upright;
    upright.start = {at(random), at(random), at(random)};
    for (int i = 0; i < 40; ++i) feed_to(upright, {at(random), at(random), at(random)});
    own.path = turned(upright, pose);
    own.axes.start = pose.direction({0, 0, 1});
    own.axes.to.assign(upright.moves.size(), own.axes.start);
    const Pass leaning{cutter, shared(upright), pose}, turning = own.pass(cutter);
    const model::Stock block = model::BoxStock{{-20, -20, -20}, {40, 40, 40}};
    const RemovedSpace a(block, {&leaning, 1}), b(block, {&turning, 1});
    for (int n = 0; n < 300; ++n) {
      const Vec3 p{at(random), at(random), at(random)};
      const Nearest here = a.nearest(p), there = b.nearest(p);
      REQUIRE(std::abs(here.distance.value - there.distance.value) < 1e-8);
      std::vector<BodyRef> near, near_too;
      a.within(p, 1, near), b.within(p, 1 + 1e-8, near_too);
      REQUIRE(near_too.size() >= near.size());
      near.clear(), near_too.clear();
      const model::Box3 box{p, p + Vec3{1, 2, 1}};
      a.within(p, 0.5, near), b.within(box, 0.5, near_too);
      for (const BodyRef body : near)
        REQUIRE(std::find(near_too.begin(), near_too.end(), body) != near_too.end());
      const Vec3 ray = model::normalized({at(random), at(random), at(random)});
      const EndRule rule{1e-6, 0, 0};
      const double met = a.first_met(p, ray, 30, rule).t_mm;
      const double met_too = b.first_met(p, ray, 30, rule).t_mm;
      CAPTURE(cutter.id, n, met, met_too);
      REQUIRE(std::abs(met - met_too) < 1e-4);
    }
  }
}

TEST_CASE("what a ball leaves and takes does not depend on how it stands", "[unit][slow]") {
  const model::Cutter ball = ball_cutter(2);
  const ReferenceSurface dome(paraboloid_cage(3, -0.05));
  const model::Stock block = model::BoxStock{{-10, -10, -12}, {20, 20, 14}};
  const auto stand = [](double x, double y) {
    return model::normalized({0.2 + 0.15 * std::sin(x), 0.3 * std::cos(0.7 * y), 1});
  };
  const auto up = [](double, double) { return Vec3{0, 0, 1}; };
  const auto touch = [&](double x, double y, const Vec3& axis) {
    return touching_tip(ball, {x, y, dome_height(x, y)}, dome_normal(x, y), axis, 0.01);
  };
  const TurningPath leaning = dome_rows(4, 0.25, 0.25, stand, touch);
  const TurningPath upright = dome_rows(4, 0.25, 0.25, up, touch);
  const Pass turning = leaning.pass(ball), standing{ball, shared(upright.path)};
  const StageCheck check = turning_check(0.0005);
  const StageDeviation a = measure_passes(dome, block, {&turning, 1}, check, 2);
  const StageDeviation b = measure_passes(dome, block, {&standing, 1}, check, 2);
  // Centres leave their chords by turn squared over eight, times the radius: 0.1 µm at 1.2 degrees.
  constexpr double kBow_mm = 2e-4;
  CHECK(a.gouge_mm.high - a.gouge_mm.low <= check.resolution_mm);
  CHECK(a.gouge_mm.low <= b.gouge_mm.high + kBow_mm);
  CHECK(b.gouge_mm.low <= a.gouge_mm.high + kBow_mm);
  CHECK(a.gouge_mm.low > 0.0095);
  CHECK(a.uncut_mm.high < 0.001);
  REQUIRE_FALSE(a.gouges.empty());
  CHECK(a.proven_reach.unreachable_mm2 == 0);
  CHECK(a.proven_reach.reachable_mm2 > 0.9 * dome.area_mm2());
}

namespace {

/// Rows of a bull or a ball over the dome that leave and take little.
struct DomeStage {
  model::Cutter cutter;
  TurningPath path;

  explicit DomeStage(bool is_ball)
      : cutter(is_ball ? ball_cutter(2)
                       : model::Cutter{"bull", model::CutterType::bull, 6, 1, 0, 20, {}, {}}) {
    const auto stand = [](double x, double y) {
      return model::normalized(dome_normal(x, y) + Vec3{0.06, 0.02 * std::sin(y), 0});
    };
    const auto touch = [&](double x, double y, const Vec3& axis) {
      return touching_tip(cutter, {x, y, dome_height(x, y)}, dome_normal(x, y), axis, 0);
    };
    path = dome_rows(4, 0.8, 0.5, stand, touch);
  }
};

}  // namespace

TEST_CASE("a wrong axis is found at its line, as deep as it is", "[property][slow]") {
  const ReferenceSurface dome(paraboloid_cage(4, -0.05));
  const model::Stock block = model::BoxStock{{-8, -8, -8}, {16, 16, 10}};
  const StageCheck check = turning_check(0.001);
  std::mt19937 random(21);
  const auto dice = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const int planted = by_effort(6, 200);
  int found = 0;
  for (int n = 0; n < planted; ++n) {
    DomeStage stage(n % 2 == 0);
    if (n < 2) {  // as it should be
      const Pass right = stage.path.pass(stage.cutter);
      CHECK(measure_passes(dome, block, {&right, 1}, check, 2).gouge_mm.high < 0.02);
    }
    // One axis of hundreds off by 11 to 27 degrees, its tip as it was.
    std::vector<Vec3>& axes = stage.path.axes.to;
    const auto wrong = static_cast<std::size_t>(dice(1, static_cast<double>(axes.size()) - 2));
    const double way = dice(0, 6.28), by = dice(0.2, 0.5);
    axes[wrong] = model::normalized(axes[wrong] + Vec3{std::cos(way), std::sin(way), 0} * by);
    const Pass lost = stage.path.pass(stage.cutter);
    const StageDeviation d = measure_passes(dome, block, {&lost, 1}, check, 2);
    // How deep it is is what single poses of the two moves take at the surface about them.
    TurningPath two;
    two.path.start = model::move_from(stage.path.path, wrong);
    two.axes.start = model::axis_from(stage.path.axes, wrong);
    for (const std::size_t i : {wrong, wrong + 1})
      feed_to(two.path, stage.path.path.moves[i].to), two.axes.to.push_back(axes[i]);
    const PosesOfPass poses(stage.cutter, two, 32);
    double deep_mm = 0;
    const Vec3 tip = stage.path.path.moves[wrong].to;
    for (double x = std::max(-4.0, tip.x - 3); x <= std::min(4.0, tip.x + 3); x += 0.1)
      for (double y = std::max(-4.0, tip.y - 3); y <= std::min(4.0, tip.y + 3); y += 0.1)
        deep_mm =
            std::max(deep_mm, poses.run({x, y, dome_height(x, y)}, -dome_normal(x, y), true, 2));
    CAPTURE(n, wrong, by, deep_mm, d.gouge_mm.low, d.gouge_mm.high);
    CHECK(d.gouge_mm.high >= deep_mm);
    if (deep_mm < 0.03) continue;
    ++found;
    REQUIRE_FALSE(d.gouges.empty());
    // Samples 0.1 mm apart may miss the deepest place; there the poses show what is certified, but
    // for what lies between two of them.
    const Vec3& deepest = d.gouges.front().place.point;
    CHECK(poses.run(deepest, -dome_normal(deepest.x, deepest.y), true, 2) > d.gouge_mm.low - 0.002);
    const std::uint32_t line = d.gouges.front().line,
                        planted_line = stage.path.path.moves[wrong].line;
    CHECK((line == planted_line || line == planted_line + 1));
  }
  CHECK(found > planted / 2);
}

TEST_CASE("certified figures of turning passes are those of many poses", "[property][slow]") {
  const int pairs = by_effort(6, 100);
  const model::Cutter cutters[] = {ball_cutter(2),
                                   {"bull", model::CutterType::bull, 6, 1, 0, 20, {}, {}}};
  for (int n = 0; n < pairs; ++n) {
    std::mt19937 random(static_cast<unsigned>(n));
    const auto dice = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    const model::Cutter& cutter = cutters[n % 2];
    const double k = dice(-0.06, 0.02);
    const ReferenceSurface surface(paraboloid_cage(3, k));
    const double lean_x = dice(-0.3, 0.3), lean_y = dice(-0.3, 0.3), wave = dice(0.1, 1);
    const double deep = dice(-0.03, 0.03);
    const auto normal = [&](double x, double y) {
      return model::normalized({-2 * k * x, -2 * k * y, 1});
    };
    const auto stand = [&](double x, double y) {
      return model::normalized(normal(x, y) +
                               Vec3{0.1 + lean_x * std::sin(wave * y), lean_y * std::cos(x), 0});
    };
    const auto touch = [&](double x, double y, const Vec3& axis) {
      return touching_tip(cutter, {x, y, k * (x * x + y * y)}, normal(x, y), axis, deep);
    };
    const TurningPath path = dome_rows(3.5, 0.7, 0.7, stand, touch);
    const Pass pass = path.pass(cutter);
    const model::Stock block = model::BoxStock{{-6, -6, -6}, {12, 12, 12}};
    const StageCheck check = turning_check(0.001);
    const StageDeviation d = measure_passes(surface, block, {&pass, 1}, check, 2);
    CAPTURE(n, d.gouge_mm.low, d.gouge_mm.high, d.uncut_mm.low, d.uncut_mm.high);
    const PosesOfPass poses(cutter, path, 16);
    // Between sixteen poses a move of 0.7 mm sweeps no more than this beyond them.
    constexpr double kBetween_mm = 2e-3;
    for (std::size_t i = 0; i < d.field.samples.size(); i += 7) {
      const auto& sample = d.field.samples[i];
      const Vec3 &p = sample.place.point, &normal_there = sample.normal;
      REQUIRE(poses.run(p, -normal_there, true, 2) <= d.gouge_mm.high + 1e-6);
      // What is uncut between poses may be swept: of places in reach, by more than that.
      if (sample.reachable)
        REQUIRE(poses.run(p, normal_there, false, 0.2) <= d.uncut_mm.high + kBetween_mm);
    }
    // The witnesses are runs of the poses too.
    if (d.gouge_mm.low > kBetween_mm) {
      REQUIRE_FALSE(d.gouges.empty());
      const Vec3& worst = d.gouges.front().place.point;
      CHECK(poses.run(worst, -normal(worst.x, worst.y), true, 2) >= d.gouge_mm.low - kBetween_mm);
    }
  }
}

}  // namespace limitgauge::verifier
