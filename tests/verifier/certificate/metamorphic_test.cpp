// What must not change the verdict: the same part and path elsewhere, turned, larger or mirrored,
// the same moves cut up or in another order, the same surface by another cage, more threads.
#include <cmath>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/rasters.h"
#include "tests/support/solid_meshes.h"
#include "tests/support/uniform_refinement.h"
#include "verifier/gate/verify.h"

namespace limitgauge::verifier {
namespace {

using model::Box3;
using model::Cage;
using model::Cutter;
using model::Vec3;
using namespace tests;

/// Everything that a measurement is about.
struct Setup {
  std::string name;
  Cage cage;
  model::Stock stock;
  Cutter cutter;
  model::Toolpath path;
  double allowance_mm = 0;
  double resolution_mm = 0;
};

constexpr double kHalf_mm = 3, kAbove_mm = 2;

/// A dome, in faces that a quarter turn and a mirror do not map onto each other.
double dome_z(double x, double y) {
  return -0.04 * (x * x + 1.3 * y * y) + 0.05 * x;
}

std::vector<Cage> cages() {
  const Cage dome = grid_cage(
      4, 3,
      [](int i, int j) {
        const double x = kHalf_mm * (i / 2.0 - 1), y = kHalf_mm * (j / 1.5 - 1);
        return Vec3{x, y, dome_z(x, y)};
      },
      model::BoundaryRule::edge_only);
  Cage roof = grid_cage(
      4, 4,
      [](int i, int j) {
        const double x = kHalf_mm * (i / 2.0 - 1), y = kHalf_mm * (j / 2.0 - 1);
        return Vec3{x, y, -0.3 * std::abs(x) + 0.02 * y};
      },
      model::BoundaryRule::edge_and_corner);
  for (model::Index j = 0; j < 4; ++j)
    roof.creases.push_back({{5 * j + 2, 5 * j + 7}, model::kInfiniteSharpness});
  return {dome, placed(star_cage(5, 0.5), {0.13, 10, {}}), roof};
}

std::vector<Cutter> cutters() {
  return {flat_cutter(1),
          ball_cutter(1.5),
          {"bull", model::CutterType::bull, 3, 0.5, 0, 20, {}, {}},
          {"taper", model::CutterType::taper, 1.6, 0.6, 8, 10, {}, {}}};
}

/// Rows over the part between plunge and retract, each of three straight parts with a point in the
/// middle of each part, so that moves can be merged as well as split. They gouge here and leave
/// there.
model::Toolpath rows(double top_z) {
  constexpr double kStep_mm = 0.6, kReach_mm = kHalf_mm + 1;
  model::Toolpath path;
  path.start = {-kReach_mm, -kReach_mm, top_z};
  const auto height = [](double x, double y) {
    return dome_z(x, y) + 0.35 * std::sin(1.1 * x + 0.5 * y) + 0.25;
  };
  int row = 0;
  for (double x = -kReach_mm; x <= kReach_mm; x += kStep_mm, ++row) {
    const double from = row % 2 == 0 ? -kReach_mm : kReach_mm, by = -2 * from / 3;
    feed_to(path, {x, from, top_z});
    for (int part = 0; part < 3; ++part) {
      const Vec3 a{x, from + part * by, height(x, from + part * by)},
          b{x, from + (part + 1) * by, height(x, from + (part + 1) * by)};
      if (part == 0) feed_to(path, a);
      feed_to(path, lerp(a, b, 0.5));
      feed_to(path, b);
    }
    feed_to(path, {x, -from, top_z});
  }
  return path;
}
constexpr std::size_t kMovesPerRow = 9;

/// Above S here and below it there.
double casting_z(double x, double y) {
  return 0.3 + 0.8 * std::cos(0.9 * x + 0.4 * y + 1);
}

std::vector<Setup> setups() {
  std::vector<Setup> out;
  const char* names[] = {"dome", "star", "roof"};
  const std::vector<Cage> all = cages();
  for (std::size_t c = 0; c < all.size(); ++c)
    for (const Cutter& cutter : cutters()) {
      const model::BoxStock block{{-6, -6, -5}, {12, 12, 7}};
      out.push_back({std::string(names[c]) + ", " + cutter.id, all[c], block, cutter,
                     rows(2 + kAbove_mm), c == 1 ? 0.02 : 0.0, 0.01});
    }
  // Castings: of the same part and path, one with each cage.
  for (const std::size_t k : {1UL, 4UL, 11UL}) {
    Setup casting = out[k];
    casting.name += ", casting";
    casting.stock = mesh_stock(block_under(6, 25, -5, casting_z));
    out.push_back(casting);
  }
  return out;
}

/// Every second one by turns, so that every cage and every cutter is among them, or all.
std::vector<Setup> by_turns(std::size_t first) {
  std::vector<Setup> out;
  const std::vector<Setup> all = setups();
  for (std::size_t n = 0; n < all.size(); ++n)
    if (thorough() || (n + n / cutters().size() + first) % 2 == 0) out.push_back(all[n]);
  return out;
}

StageDeviation measure(const Setup& s, const GateLimits& limits, unsigned threads = 2) {
  StageCheck check;
  check.allowance_mm = s.allowance_mm;
  check.resolution_mm = s.resolution_mm;
  check.limits = limits;
  check.field_spacing_mm = 100 * s.resolution_mm;
  const Pass pass{s.cutter, shared(s.path)};
  return measure_stage(ReferenceSurface(s.cage), s.stock, {&pass, 1}, nullptr, check,
                       {threads, nullptr, {}});
}

/// A gate that the figures keep with room to spare, missing stock of a casting among them, and one
/// that they break, times `scale`.
GateLimits kept_gate(const StageDeviation& d, double scale = 1) {
  const double deepest_mm = std::max(d.gouge_mm.high, d.missing_stock_mm.high);
  return {true, true, false, 1.5 * deepest_mm * scale, 1.5 * d.uncut_mm.high * scale, 0};
}
GateLimits broken_gate(const StageDeviation& d, double scale = 1) {
  return {true, true, false, 0.5 * d.gouge_mm.low * scale, 0.5 * d.uncut_mm.low * scale, 0};
}

/// The base with its figures.
struct Measured {
  Setup setup;
  StageDeviation figures;
};

Measured measured(const Setup& s) {
  // Limits far away: figures without a search for everything beyond half of them.
  Measured m{s, measure(s, {true, true, false, 100, 100, 0})};
  CAPTURE(s.name);
  // Nothing is shown by figures of zero.
  REQUIRE(m.figures.gouge_mm.low > 2 * s.resolution_mm);
  REQUIRE(m.figures.uncut_mm.low > 2 * s.resolution_mm);
  return m;
}

/// Two certified intervals of one truth overlap, and no end is further from the other interval's
/// than both are wide. What is asked of two truths is that they are no more than `apart_mm` apart.
void check_interval(const Interval& a, const Interval& b, double resolution_mm, double apart_mm) {
  CAPTURE(a.low, a.high, b.low, b.high);
  CHECK(a.low <= b.high + apart_mm);
  CHECK(b.low <= a.high + apart_mm);
  CHECK(std::abs(a.low - b.low) <= std::max({resolution_mm, a.width(), b.width()}));
  CHECK(std::abs(a.high - b.high) <= std::max({resolution_mm, a.width(), b.width()}));
}

void check_verdict(const StageDeviation& d, const GateLimits& limits, Verdict expected) {
  const GateDecision decision = decide(d, limits);
  for (const std::string& reason : decision.reasons) UNSCOPED_INFO(reason);
  CHECK(decision.verdict == expected);
}

/// `other` must have the figures of `base` times `scale` and the same verdicts.
void check_same(const Measured& base, const Setup& other, const char* how, double scale = 1) {
  CAPTURE(base.setup.name, how);
  const GateLimits kept = kept_gate(base.figures, scale), broken = broken_gate(base.figures, scale);
  const StageDeviation d = measure(other, kept);
  const auto scaled = [&](const Interval& i) { return Interval{i.low * scale, i.high * scale}; };
  const double width_mm = other.resolution_mm;
  // The tolerance of contact does not scale, so the rim of what can be reached does not quite: with
  // a tenth of it all intervals overlap.
  const double rim_mm = scale == 1 ? 0 : 0.1 * width_mm;
  check_interval(scaled(base.figures.gouge_mm), d.gouge_mm, width_mm, 0);
  check_interval(scaled(base.figures.uncut_mm), d.uncut_mm, width_mm, rim_mm);
  check_interval(scaled(base.figures.missing_stock_mm), d.missing_stock_mm, width_mm, 0);
  check_verdict(d, kept, Verdict::pass);
  check_verdict(d, broken, Verdict::fail);
}

template <class Map>
void map_points(Setup& s, const Map& map) {
  for (Vec3& v : s.cage.vertices) v = map(v);
  s.path.start = map(s.path.start);
  for (model::Move& m : s.path.moves) m.to = map(m.to);
  if (const auto* casting = std::get_if<model::MeshStock>(&s.stock)) {
    s.stock = mesh_stock(mapped(*casting->mesh, map));
    return;
  }
  const auto& block = std::get<model::BoxStock>(s.stock);
  Box3 box;
  box.add(map(block.corner_mm));
  box.add(map(block.corner_mm + block.size_mm));
  s.stock = model::BoxStock{box.low, box.size()};
}

Setup scaled(Setup s, double by) {
  map_points(s, [by](const Vec3& p) { return p * by; });
  s.cutter.diameter_mm *= by, s.cutter.corner_radius_mm *= by, s.cutter.flute_length_mm *= by;
  s.allowance_mm *= by, s.resolution_mm *= by;
  return s;
}

Setup mirrored(Setup s) {
  map_points(s, [](const Vec3& p) { return Vec3{-p.x, p.y, p.z}; });
  if (const auto* casting = std::get_if<model::MeshStock>(&s.stock))
    s.stock = mesh_stock(inside_out(*casting->mesh));
  const Cage cage = s.cage;
  s.cage.face_corners.clear(), s.cage.face_offsets = {0};
  for (model::Index f = 0; f < cage.face_count(); ++f) {
    std::vector<model::Index> corners(cage.face(f).begin(), cage.face(f).end());
    std::reverse(corners.begin(), corners.end());
    s.cage.add_face(corners);
  }
  return s;
}

Setup split_moves(Setup s) {
  model::Toolpath path;
  path.start = s.path.start;
  for (std::size_t i = 0; i < s.path.moves.size(); ++i) {
    for (const double t : {0.3, 0.65})
      feed_to(path, lerp(move_from(s.path, i), s.path.moves[i].to, t));
    feed_to(path, s.path.moves[i].to);
  }
  s.path = path;
  return s;
}

/// Without the points that lie in the middle of a straight part.
Setup merged_moves(Setup s) {
  model::Toolpath path;
  path.start = s.path.start;
  for (std::size_t i = 0; i < s.path.moves.size(); ++i) {
    const std::size_t k = i % kMovesPerRow;
    if (k != 2 && k != 4 && k != 6) feed_to(path, s.path.moves[i].to);
  }
  s.path = path;
  return s;
}

Setup reversed_moves(Setup s) {
  model::Toolpath path;
  path.start = s.path.moves.back().to;
  for (std::size_t i = s.path.moves.size(); i-- > 0;) feed_to(path, move_from(s.path, i));
  s.path = path;
  return s;
}

/// Every third row first, then the others; the links between them stay above the stock.
Setup shuffled_rows(Setup s) {
  model::Toolpath path;
  const std::size_t count = s.path.moves.size() / kMovesPerRow;
  for (std::size_t turn = 0; turn < 3; ++turn)
    for (std::size_t row = turn; row < count; row += 3)
      for (std::size_t k = 0; k < kMovesPerRow; ++k) {
        const Vec3& to = s.path.moves[row * kMovesPerRow + k].to;
        if (path.moves.empty()) path.start = to;
        feed_to(path, to);
      }
  s.path = path;
  return s;
}

bool same(const Interval& a, const Interval& b) {
  return a.low == b.low && a.high == b.high;
}

}  // namespace

TEST_CASE("a part turned by 90° about Z or moved has the same verdict", "[e2e][metamorphic]") {
  for (const Setup& s : by_turns(0)) {
    const Measured base = measured(s);
    Setup turned = s;
    map_points(turned, [](const Vec3& p) { return Vec3{-p.y, p.x, p.z}; });
    check_same(base, turned, "turned");
    for (const Vec3& by : {Vec3{3.7, -2.1, 0.9}, Vec3{1000, -1000, 1000}}) {
      Setup moved = s;
      map_points(moved, [&](const Vec3& p) { return p + by; });
      check_same(base, moved, "moved");
    }
  }
}

TEST_CASE("a part ten times larger or smaller has the same verdict", "[e2e][metamorphic]") {
  // Each one way, by turns: every cage and every cutter sees both.
  const std::vector<Setup> all = setups();
  for (std::size_t n = 0; n < all.size(); ++n) {
    const Setup& s = all[n];
    // A few of them, of both ways, serve on every change.
    const std::size_t turn = (n + n / cutters().size()) % 16;
    if (!tests::thorough() && turn != 0 && turn != 5) continue;
    const bool larger = (n + n / cutters().size()) % 2 == 0;
    const double scale = larger ? 10 : 0.1;
    check_same(measured(s), scaled(s, scale), larger ? "ten times larger" : "ten times smaller",
               scale);
  }
}

TEST_CASE("a mirrored part with reversed faces has the same verdict", "[e2e][metamorphic]") {
  for (const Setup& s : by_turns(1)) check_same(measured(s), mirrored(s), "mirrored");
}

TEST_CASE("moves split, merged, reversed or in another order have the same verdict",
          "[e2e][metamorphic]") {
  struct Change {
    const char* name;
    Setup (*of)(Setup);
  };
  constexpr Change kChanges[] = {{"split", split_moves},
                                 {"merged", merged_moves},
                                 {"reversed", reversed_moves},
                                 {"shuffled", shuffled_rows}};
  // All of them of every setup, or one by turns of every other.
  const std::vector<Setup> all = setups();
  for (std::size_t n = 0; n < all.size(); n += tests::by_effort(2, 1)) {
    const Measured base = measured(all[n]);
    for (std::size_t k = 0; k < std::size(kChanges); ++k)
      if (tests::thorough() || (n + n / cutters().size() + k) % std::size(kChanges) == 0)
        check_same(base, kChanges[k].of(all[n]), kChanges[k].name);
  }
}

TEST_CASE("a cage subdivided once has the same verdict", "[e2e][metamorphic]") {
  for (const Setup& s : by_turns(0)) {
    Setup finer = s;
    finer.cage = refine_uniformly(s.cage);
    check_same(measured(s), finer, "subdivided");
  }
}

TEST_CASE("one, two and three threads give the same bits", "[e2e][metamorphic]") {
  for (const Setup& s : by_turns(1)) {
    CAPTURE(s.name);
    // Limits below the figures, so that there are findings to compare.
    const GateLimits limits = broken_gate(measured(s).figures, 1.9);
    const StageDeviation one = measure(s, limits, 1);
    REQUIRE(!one.gouges.empty());
    REQUIRE(!one.uncuts.empty());
    for (const unsigned threads : {2U, 3U}) {
      const StageDeviation more = measure(s, limits, threads);
      CHECK(same(one.gouge_mm, more.gouge_mm));
      CHECK(same(one.uncut_mm, more.uncut_mm));
      CHECK(one.cells == more.cells);
      CHECK(one.coverage == more.coverage);
      CHECK(one.rms_mm == more.rms_mm);
      CHECK(one.unavoidable_uncut_mm.low == more.unavoidable_uncut_mm.low);
      CHECK(one.unavoidable_uncut_mm.high == more.unavoidable_uncut_mm.high);
      REQUIRE(one.gouges.size() == more.gouges.size());
      REQUIRE(one.uncuts.size() == more.uncuts.size());
      for (std::size_t k = 0; k < one.gouges.size(); ++k) {
        CHECK(one.gouges[k].place.point == more.gouges[k].place.point);
        CHECK(one.gouges[k].move == more.gouges[k].move);
        CHECK(one.gouges[k].area_mm2 == more.gouges[k].area_mm2);
      }
      for (std::size_t k = 0; k < one.uncuts.size(); ++k)
        CHECK(one.uncuts[k].place.point == more.uncuts[k].place.point);
    }
  }
}

}  // namespace limitgauge::verifier
