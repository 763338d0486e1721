#include "tests/defects/scenes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>

#include "tests/defects/nc_text.h"
#include "tests/support/judging.h"
#include "tests/support/part_cages.h"

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;
using verifier::Pass;

/// Values spread over [a, b], evenly or (where b is many times a) by their logarithm.
double spread(int k, int count, double a, double b) {
  const double t = count > 1 ? static_cast<double>(k) / (count - 1) : 0;
  return a > 0 && b / a > 5 ? a * std::pow(b / a, t) : a + (b - a) * t;
}

std::string text(const char* pattern, double a, double b = 0) {
  char out[120];
  std::snprintf(out, sizeof out, pattern, a, b);
  return out;
}

Pass idle(const model::Cutter& cutter) {
  return pass_of(cutter, moves_through({{-40, -40, 60}, {40, 40, 60}}));
}

/// Down, along and up again.
void cut_along(model::Toolpath& path, const Vec3& a, const Vec3& b) {
  constexpr double kSafe_mm = 30;
  if (path.moves.empty()) path.start = {a.x, a.y, kSafe_mm};
  for (const Vec3& to : {Vec3{a.x, a.y, kSafe_mm}, a, b, Vec3{b.x, b.y, kSafe_mm}})
    feed_to(path, to);
}

void ridges(std::vector<Scene>& out) {
  constexpr int kCount = 36, kTwins = 8;
  for (int k = 0; k < kCount + kTwins; ++k) {
    Scene s;
    s.kind = SceneKind::ridge, s.harmed = k < kCount;
    const double flank = spread(k % 12, 12, 20, 60),
                 over = s.harmed ? spread(k, kCount, 0.1, 3) : 0.02;
    const Ridges r{1 + 2 * (k % 3), 1, flank, 4, 8};
    const double foot = r.count * r.pitch_mm / 2, end = foot + r.floor_mm, radius = 3,
                 top = r.height_mm() + over;
    s.label = text("flank %.3g degrees, %.3g mm over the ridges", flank, over);
    s.cage = ridge_cage(r);
    s.stock = block_between({-end - 1, -3, -4}, {end + 1, 3, top});
    // Mills the floor, its flank off all that stands over the ridges and what leans out of them.
    model::Toolpath path;
    for (const double side : {-1.0, 1.0})
      for (double x = foot + radius + 2 * over + 1; x < end + 4; x += 0.15)
        cut_along(path, {side * x, -7, 0}, {side * x, 7, 0});
    s.passes = {pass_of(ball_cutter(radius), path)};
    s.depth_mm = over;
    // It stands over the valleys and the feet, too, and along the normals of the flanks.
    s.most_mm = top / std::cos(flank * std::numbers::pi / 180) + 1e-3;
    s.limits = uncut_gate(s.harmed ? 0.05 : s.most_mm);
    if (!s.harmed) {
      // The floor between the ridges' feet and the milled part is covered: the twin is the bare
      // block, with no floor beside the ridges.
      const Ridges bare{r.count, 1, flank, 4, 0.001};
      s.cage = ridge_cage(bare);
      const double width = foot + 0.001;
      s.stock = block_between({-width, -3, -4}, {width, 3, top});
      s.passes = {idle(ball_cutter(radius))};
    }
    out.push_back(std::move(s));
  }
}

void rims(std::vector<Scene>& out) {
  constexpr int kCount = 30, kTwins = 10;
  for (int k = 0; k < kCount + kTwins; ++k) {
    Scene s;
    s.kind = SceneKind::rim, s.harmed = k < kCount;
    const double off = spread(k % kCount, kCount, 0.005, 0.8), half = 1.5, r = k % 2 == 0 ? 2 : 1,
                 way = half + off + r, truth = off * std::sqrt(3.0);
    s.label = text("%.3g mm on all faces, flat of radius %.3g mm", off, r);
    s.cage = boss_cage({{-half, -half, -1.5}, {half, half, 0}});
    s.stock = block_between({-3, -3, -5}, {3, 3, 1});
    model::Toolpath path = moves_through({{-way, -way, 30},
                                          {-way, -way, -2},
                                          {way, -way, -2},
                                          {way, way, -2},
                                          {-way, way, -2},
                                          {-way, -way, -2},
                                          {-way, -way, 30}});
    for (double x = -4; x <= 4; x += r) cut_along(path, {x, -6, off}, {x, 6, off});
    s.passes = {pass_of(flat_cutter(r), path)};
    // The faces keep it, and the edges; the corners do not.
    s.limits = uncut_gate(truth * (s.harmed ? 0.9 : 1.15));
    s.depth_mm = s.most_mm = truth;
    out.push_back(std::move(s));
  }
}

void fins(std::vector<Scene>& out) {
  constexpr int kCount = 40, kTwins = 10;
  for (int k = 0; k < kCount + kTwins; ++k) {
    Scene s;
    s.kind = SceneKind::fin, s.harmed = k < kCount;
    const double thick = s.harmed ? spread(k, kCount, 0.002, 0.099)
                                  : -spread(k - kCount, kTwins, 0.001, 0.5),
                 tall = spread(k % 7, 7, 0.5, 6), at = -1.7 + 0.31 * (k % 11), r = 4;
    s.label = text("%.4g mm thick, %.3g mm tall", thick, tall);
    s.cage = plane_cage(4, 0, 0);
    s.stock = block_between({-4.5, -4.5, -4}, {4.5, 4.5, tall});
    model::Toolpath path;
    for (const double x : {at - thick / 2 - r, at + thick / 2 + r})
      cut_along(path, {x, -9, 0}, {x, 9, 0});
    s.passes = {pass_of(flat_cutter(r), path)};
    s.limits = both_gates(0.05, 0.05);
    s.depth_mm = s.most_mm = tall;
    s.has_place = true, s.place = {at, 0, 0}, s.within_mm = 9;
    out.push_back(std::move(s));
  }
}

void holes(std::vector<Scene>& out) {
  constexpr int kCount = 40, kTwins = 8;
  for (int k = 0; k < kCount + kTwins; ++k) {
    Scene s;
    s.kind = SceneKind::hole, s.harmed = k < kCount, s.side = Scene::Side::gouge;
    const double d = spread(k % kCount, kCount, 0.05, 0.11),
                 deep = s.harmed ? spread(k % 9, 9, 0.2, 4) : 0.03;
    s.label = text("diameter %.4g mm, %.3g mm deep", d, deep);
    s.place = {-2.3 + 0.57 * (k % 9), 2.9 - 0.83 * (k % 7), 0};
    s.cage = plane_cage(4, 0, 0);
    s.stock = block_between({-4.5, -4.5, -6}, {4.5, 4.5, 0});
    model::Toolpath path;
    cut_along(path, s.place - Vec3{0, 0, deep}, s.place);
    s.passes = {pass_of(k % 2 == 0 ? flat_cutter(d / 2) : ball_cutter(d / 2), path)};
    s.limits = gouge_gate(0.06);
    s.depth_mm = s.most_mm = deep;
    s.has_place = true, s.within_mm = d / 2 + 1e-6;
    out.push_back(std::move(s));
  }
}

void cusps(std::vector<Scene>& out) {
  constexpr int kCount = 40, kTwins = 12;
  for (int k = 0; k < kCount + kTwins; ++k) {
    Scene s;
    s.kind = SceneKind::cusp, s.harmed = k < kCount;
    const double r = spread(k % 4, 4, 1, 4), p = 2 * r * spread(k % kCount, kCount, 0.02, 0.97),
                 cusp = r - std::sqrt(r * r - p * p / 4);
    // The middle between two rows lies on the part, however far they are apart.
    const double half = p * (std::ceil((4 + r) / p) + 0.5);
    s.label = text("radius %.3g mm, rows %.4g mm apart", r, p);
    s.cage = plane_cage(3, 0, 0);
    s.stock = block_between({-3.5, -3.5, -4}, {3.5, 3.5, 5});
    s.passes = {
        pass_of(ball_cutter(r), raster(half, p, 2 * half, [](double, double) { return 0.0; }))};
    s.limits = uncut_gate(cusp * (s.harmed ? 0.85 : 1.15));
    s.depth_mm = s.most_mm = cusp;
    out.push_back(std::move(s));
  }
}

void thin_blocks(std::vector<Scene>& out) {
  constexpr int kCount = 24, kTwins = 8;
  for (int k = 0; k < kCount + kTwins; ++k) {
    Scene s;
    s.kind = SceneKind::thin_block, s.harmed = k < kCount;
    const double under = spread(k % 8, 8, 0.05, 1), over = spread(k % kCount, kCount, 0.7, 10);
    s.label = text("%.3g mm over the underside, %.3g mm on it", under, over);
    s.cage = plane_cage(4, 0, 0);
    s.stock = block_between({-4.05, -4.05, -under}, {4.05, 4.05, over});
    s.passes = {idle(ball_cutter(3))};
    if (!s.harmed)
      s.passes = {pass_of(flat_cutter(3), raster(6, 2, 12, [](double, double) { return 0.0; }))};
    s.limits = both_gates(0.6, 0.6);
    s.depth_mm = s.most_mm = over;
    out.push_back(std::move(s));
  }
}

void flipped_sheets(std::vector<Scene>& out) {
  constexpr int kCount = 12;
  for (int k = 0; k < 2 * kCount; ++k) {
    Scene s;
    s.kind = SceneKind::flipped_sheet, s.harmed = k < kCount, s.side = Scene::Side::reach;
    const double slope = 0.1 * (k % 4);
    const model::Cutter cutter = k % 3 == 0 ? flat_cutter(2) : ball_cutter(1 + k % 3);
    s.label = text("slope %.3g", slope);
    s.cage = plane_cage(3, slope, 0);
    if (s.harmed) s.cage = flipped(s.cage);
    s.stock = block_between({-3.5, -3.5, -4}, {3.5, 3.5, s.harmed ? 5 : 1.2});
    const double steep = std::sqrt(1 + slope * slope), r = cutter.radius_mm();
    // Touches the plane in rows, a flat with its edge.
    const double lift = cutter.type == model::CutterType::flat ? r * slope : r * steep - r;
    s.passes = {
        pass_of(cutter, raster(6, 0.1, 12, [&](double x, double) { return slope * x + lift; }))};
    s.limits = both_gates(0.05, 0.05);
    out.push_back(std::move(s));
  }
}

/// Material under a ledge stays where it is: in a sound part nobody's uncut.
void undercuts(std::vector<Scene>& out) {
  constexpr int kTwins = 16, kCount = 8;
  for (int k = 0; k < kTwins + kCount; ++k) {
    Scene s;
    s.kind = SceneKind::undercut, s.harmed = k >= kTwins;
    const double deep = spread(k % 8, 8, 0.3, 3), open = spread(k % 5, 5, 0.5, 3), r = 1 + k % 3;
    s.label = text("%.3g mm under, %.3g mm high", deep, open);
    const double floor = -1 - open;
    s.cage = drawn_outline({{-5, 0}, {0, 0}, {0, -1}, {-deep, -1}, {-deep, floor}, {5, floor}}, 4);
    s.stock = block_between({-5.5, -2.5, floor - 3}, {5.5, 2.5, 0.5});
    constexpr double kPastContact_mm = 0.0004;
    model::Toolpath path;
    for (double x = -6; x <= 6; x += r) cut_along(path, {x, -6, 0}, {x, 6, 0});
    for (double x = r - kPastContact_mm; x < 6; x += r)
      cut_along(path, {x, -6, s.harmed ? floor + 0.2 : floor},
                {x, 6, s.harmed ? floor + 0.2 : floor});
    s.passes = {pass_of(flat_cutter(r), path)};
    s.limits = both_gates(0.05, 0.05);
    s.depth_mm = s.most_mm = 0.2;
    out.push_back(std::move(s));
  }
}

void several_tools(std::vector<Scene>& out) {
  constexpr int kCount = 20, kTwins = 10;
  for (int k = 0; k < kCount + kTwins; ++k) {
    Scene s;
    s.kind = SceneKind::several_tools, s.harmed = k < kCount;
    // z = c·x² over |x| <= 5; a ball of R rests on the rims, one of 1.5 reaches everywhere.
    const double c = spread(k % 10, 10, 0.04, 0.07), big = 15 + k % 4, half = 5,
                 rim = c * half * half, tip = rim + std::sqrt(big * big - half * half) - big;
    s.label = text("tip of the wide ball %.3g mm over the bottom", tip);
    s.cage = trough_cage(half, c);
    s.stock = block_between({-half - 0.01, -half - 0.01, -3}, {half + 0.01, half + 0.01, rim + 1});
    const Pass wide = pass_of(ball_cutter(big), moves_through({{0, -25, tip}, {0, 25, tip}}));
    const double small = 1.5;
    model::Toolpath rows;
    for (double x = -half; x <= half; x += 0.1) {
      // Along y, where the ball touches at x.
      const double steep = std::sqrt(1 + 4 * c * c * x * x);
      const double cx = x - small * 2 * c * x / steep, cz = c * x * x + small / steep - small;
      cut_along(rows, {cx, -9, cz}, {cx, 9, cz});
    }
    const Pass fine = s.harmed ? idle(ball_cutter(small)) : pass_of(ball_cutter(small), rows);
    s.passes = k % 2 == 0 ? std::vector{fine, wide} : std::vector{wide, fine};
    s.limits = both_gates(0.05, 0.05);
    s.depth_mm = s.most_mm = tip;
    if (s.harmed) s.has_place = true, s.within_mm = 6;
    out.push_back(std::move(s));
  }
}

/// A slot whose program never names Y before it: the tool stands at the program's zero.
void first_motions(std::vector<Scene>& out) {
  constexpr int kCount = 10, kTwins = 4;
  for (int k = 0; k < kCount + kTwins; ++k) {
    Scene s;
    s.kind = SceneKind::first_motions, s.harmed = k < kCount, s.side = Scene::Side::gouge;
    // As the program's four decimals have it.
    const double deep = s.harmed ? std::round(spread(k, kCount, 0.1, 3) * 1e4) / 1e4 : -0.01;
    s.label = text("%.3g mm deep", deep);
    s.cage = plane_cage(4, 0, 0);
    s.stock = block_between({-4.5, -4.5, -6}, {4.5, 4.5, 0});
    s.passes = {pass_of(flat_cutter(1),
                        read_back("G21 G90\nG0 Z5\nX-2\n" +
                                  text("G1 Z%.4f F100\nX2\nG0 Z5\n", -deep) + "G0 X8 Y8\nM30\n"))};
    s.limits = gouge_gate(0.05);
    s.depth_mm = s.most_mm = deep;
    s.has_place = s.harmed, s.within_mm = 3.01;
    out.push_back(std::move(s));
  }
}

void sliced_shanks(std::vector<Scene>& out) {
  constexpr int kCount = 30, kTwins = 9;
  for (int k = 0; k < kCount + kTwins; ++k) {
    Scene s;
    s.kind = SceneKind::sliced_shank, s.harmed = k < kCount, s.side = Scene::Side::gouge;
    const double deep = s.harmed ? spread(k, kCount, 0.08, 1) : -0.1, r = 1.7;
    const int slices = k % 3 == 0 ? 1 : k % 3 == 1 ? 40 : 10;
    s.label = text("%.3g mm into the wall, %g slices", deep, slices);
    s.cage = drawn_outline({{-4, 0}, {0, 0}, {0, 8}, {4, 8}}, 5);
    s.stock = block_between({-4.5, -3, -3}, {4.5, 3, 8});
    model::Cutter cutter = flat_cutter(r);
    cutter.flute_length_mm = 3;
    for (int i = 0; i < slices; ++i)
      (k % 2 == 0 ? cutter.shank : cutter.holder).push_back({2 * (r + deep), 2.0 / slices});
    s.passes = {pass_of(cutter, moves_through({{-r, -8, 0}, {-r, 8, 0}}))};
    s.limits = gouge_gate(0.05);
    s.depth_mm = s.most_mm = deep;
    out.push_back(std::move(s));
  }
}

double since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void compare(const Scene& s, const verifier::StageDeviation& d, SceneResult& out) {
  constexpr double kSame_mm = 1e-6;
  const bool gouge = s.side == Scene::Side::gouge;
  out.certified = gouge ? d.gouge_mm : d.uncut_mm;
  if (s.side == Scene::Side::reach) {
    out.located = s.harmed ? d.reachable_area_mm2 == 0 : d.reachable_area_mm2 > 0;
    return;
  }
  if (!s.harmed) return;
  out.contained =
      out.certified.low <= s.most_mm + kSame_mm && out.certified.high >= s.depth_mm - kSame_mm;
  const auto& findings = gouge ? d.gouges : d.uncuts;
  out.located = !findings.empty() && (!s.has_place || level_distance(findings.front().place.point,
                                                                     s.place) <= s.within_mm);
}

}  // namespace

const char* name(SceneKind kind) {
  switch (kind) {
    case SceneKind::ridge:
      return "ridges never touched";
    case SceneKind::rim:
      return "rims and corners";
    case SceneKind::fin:
      return "fins";
    case SceneKind::hole:
      return "holes";
    case SceneKind::cusp:
      return "cusps, fine to coarse";
    case SceneKind::thin_block:
      return "thin blocks";
    case SceneKind::flipped_sheet:
      return "flipped sheets";
    case SceneKind::undercut:
      return "undercuts";
    case SceneKind::several_tools:
      return "several tools";
    case SceneKind::first_motions:
      return "first motions";
    case SceneKind::sliced_shank:
      return "shanks, in slices too";
  }
  return "";
}

std::vector<Scene> suite_scenes() {
  std::vector<std::vector<Scene>> kinds;
  for (const auto make : {ridges, rims, fins, holes, cusps, thin_blocks, flipped_sheets, undercuts,
                          several_tools, first_motions, sliced_shanks})
    make(kinds.emplace_back());
  struct Turn {
    double at;
    Scene* scene;
  };
  std::vector<Turn> turns;
  for (auto& kind : kinds)
    for (std::size_t k = 0; k < kind.size(); ++k) {
      // By the golden ratio, so that a first part has harmed ones and twins, small ones and large.
      const double turn = std::fmod(static_cast<double>(k) * std::numbers::phi, 1.0);
      turns.push_back({turn, &kind[k]});
    }
  std::stable_sort(turns.begin(), turns.end(),
                   [](const Turn& a, const Turn& b) { return a.at < b.at; });
  std::vector<Scene> out;
  for (const Turn& t : turns) out.push_back(std::move(*t.scene));
  return out;
}

SceneResult run_scene(const Scene& scene) {
  const auto start = std::chrono::steady_clock::now();
  SceneResult out;
  out.kind = scene.kind, out.label = scene.label, out.harmed = scene.harmed;
  out.depth_mm = scene.depth_mm;
  try {
    verifier::StageCheck check;
    check.limits = scene.limits;
    check.resolution_mm = verifier::automatic_resolution_mm(scene.limits);
    check.field_spacing_mm = 0.5;
    const auto d =
        measure_passes(verifier::ReferenceSurface(scene.cage), scene.stock, scene.passes, check);
    out.verdict = decide(d, scene.limits).verdict;
    compare(scene, d, out);
  } catch (const std::exception& error) {
    out.broken = error.what();
  }
  out.seconds = since(start);
  return out;
}

}  // namespace limitgauge::tests::defects
