#include "engine/strategy/linking/linking.h"

#include <numbers>
#include <set>
#include <tuple>

#include "engine/strategy/linking/approach.h"
#include "tests/engine/lift_probe.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace engine::strategy;
using model::MoveKind;
using model::Vec3;

namespace {

/// Heights of tips that come from tip_z() or lift() are exact but for this.
constexpr double kLinkError = 2 * limitgauge::engine::kHeightError_mm;

StageRequest request_for(const char* cutter, Entry entry = Entry::ramp) {
  StageRequest r;
  r.cutter = model::parse_cutter(cutter);
  r.cut.feed_mm_min = 1000;
  r.cut.plunge_feed_mm_min = 300;
  r.cut.link_feed_mm_min = 1500;
  r.cut.tolerance_mm = 0.01;
  r.cut.entry = entry;
  r.cut.ramp_angle_deg = 3;
  r.clearance_mm = 5;
  r.stock = model::BoxStock{{-30, -30, -10}, {60, 60, 15}};
  return r;
}

/// Hills and hollows, up to 2 mm about zero.
double hills(double x, double y) {
  return std::sin(0.7 * x) + std::cos(0.5 * y + 0.3 * x);
}

/// Rows along X on the location surface, `count` of them over [-12, 12].
std::vector<CutPass> rows_on(const CutterLocations& locations, int count) {
  std::vector<CutPass> rows;
  for (int k = 0; k < count; ++k) {
    CutPass row;
    row.reversible = true;
    const double y = -12 + 24.0 * k / (count - 1);
    for (double x = -12; x <= 12; x += 0.25) row.tips.push_back({x, y, *locations.tip_z(x, y)});
    rows.push_back(std::move(row));
  }
  return rows;
}

CutPass square_at(double x, double y, double half, double z) {
  CutPass pass;
  pass.closed = true;
  pass.tips = {{x - half, y - half, z},
               {x + half, y - half, z},
               {x + half, y + half, z},
               {x - half, y + half, z}};
  return pass;
}

using Key = std::tuple<double, double, double>;
Key key(const Vec3& p) {
  return {p.x, p.y, p.z};
}

/// How often the path turns from rapids to feeds, that is how often it comes down.
int descents(const model::Toolpath& path) {
  int count = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    count += path.moves[i].kind == MoveKind::feed &&
             (i == 0 || path.moves[i - 1].kind == MoveKind::rapid);
  return count;
}

/// The moves between cuts: all but those along two tips of one pass that follow each other.
std::vector<std::pair<Vec3, Vec3>> links_of(const model::Toolpath& path,
                                            const std::vector<CutPass>& passes) {
  std::set<std::pair<Key, Key>> cuts;
  for (const CutPass& pass : passes)
    for (std::size_t i = 0; i + (pass.closed ? 0 : 1) < pass.tips.size(); ++i) {
      const Vec3 &a = pass.tips[i], &b = pass.tips[(i + 1) % pass.tips.size()];
      cuts.insert({key(a), key(b)});
      if (pass.reversible) cuts.insert({key(b), key(a)});
    }
  std::vector<std::pair<Vec3, Vec3>> links;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 &a = model::move_from(path, i), &b = path.moves[i].to;
    if (!cuts.count({key(a), key(b)})) links.push_back({a, b});
  }
  return links;
}

/// Worst of the lifts at places of the links, none of them proven by the evaluator that chose them.
double deepest(const CutterLocations& locations, const std::vector<std::pair<Vec3, Vec3>>& links) {
  double worst = test::kNone;
  for (const auto& [a, b] : links) {
    const int steps = 1 + static_cast<int>(distance(a, b) / 0.02);
    for (int k = 0; k <= steps; ++k) {
      const Vec3 tip = lerp(a, b, static_cast<double>(k) / steps);
      if (const auto z = locations.tip_z(tip.x, tip.y)) worst = std::max(worst, *z - tip.z);
    }
  }
  return worst;
}

/// Every pass is cut once, whole: its chords are moves of the path.
void check_all_cut(const model::Toolpath& path, const std::vector<CutPass>& passes) {
  std::multiset<std::pair<Key, Key>> moves;
  for (std::size_t i = 0; i < path.moves.size(); ++i)
    moves.insert({key(model::move_from(path, i)), key(path.moves[i].to)});
  for (const CutPass& pass : passes)
    for (std::size_t i = 0; i + (pass.closed ? 0 : 1) < pass.tips.size(); ++i) {
      const Key a = key(pass.tips[i]), b = key(pass.tips[(i + 1) % pass.tips.size()]);
      const std::size_t back = pass.reversible ? moves.count({b, a}) : 0;
      CHECK(moves.count({a, b}) + back == 1);
    }
}

}  // namespace

TEST_CASE("links and leads never go below the location surface", "[property][linking]") {
  const char* cutter = GENERATE("ball:D=4", "flat:D=5", "bull:D=6,r=1", "taper:D=2,r=1,angle=8");
  const int count = GENERATE(4, 40);
  INFO(cutter << ", rows " << count);
  const CutterLocations locations({test::height_grid(60, 15, hills)}, model::parse_cutter(cutter),
                                  0.1);
  const auto rows = rows_on(locations, count);
  const auto path = link_passes({rows}, locations, request_for(cutter), {});
  check_all_cut(path, rows);
  const auto links = links_of(path, rows);
  REQUIRE(links.size() >= rows.size());
  CHECK(deepest(locations, links) <= kLinkError);
}

TEST_CASE("rows close to each other are linked without a retract", "[property][linking]") {
  const CutterLocations locations({test::height_grid(60, 15, hills)},
                                  model::parse_cutter("ball:D=4"), 0);
  const auto path = link_passes({rows_on(locations, 60)}, locations, request_for("ball:D=4"), {});
  CHECK(descents(path) == 1);
  // The stretch below the stock's top is never crossed by a rapid but straight up.
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    if (path.moves[i].kind != MoveKind::rapid) continue;
    const Vec3 &a = model::move_from(path, i), &b = path.moves[i].to;
    const bool up = a.x == b.x && a.y == b.y && b.z > a.z;
    CHECK((up || (a.z > 5 && b.z > 5)));
  }
}

TEST_CASE("a comb is cut with one retract less than in the order given", "[unit][linking]") {
  // A wall 20 mm high along Y with passes on either side of it, given left, right, left: the two on
  // the left follow each other, and only the wall is crossed, once.
  const auto wall = test::grid_of(2, 2, [](int u, int v) {
    return Vec3{0, 60.0 * v - 30, 20.0 * u};
  });
  const CutterLocations locations({wall}, model::parse_cutter("flat:D=4"), 0);
  StageRequest request = request_for("flat:D=4");
  request.stock = model::BoxStock{{-30, -30, 0}, {60, 60, 20}};
  const auto line = [](double x) {
    return CutPass{{{x, -10, 1}, {x, 10, 1}}, false, true, std::nullopt};
  };
  const std::vector<CutPass> passes = {line(-8), line(8), line(-6)};
  const auto path = link_passes({passes}, locations, request, {});
  check_all_cut(path, passes);
  CHECK(descents(path) == 2);
  const auto naive = link_passes({{passes[0]}, {passes[1]}, {passes[2]}}, locations, request, {});
  CHECK(descents(naive) == 3);
}

TEST_CASE("closed passes come back to the start nearest to the pass before", "[unit][linking]") {
  const CutterLocations locations({test::height_grid(4, 30, [](double, double) { return 0.0; })},
                                  model::parse_cutter("flat:D=4"), 0);
  std::vector<CutPass> passes = {square_at(0, 0, 2, 1), square_at(10, 0, 3, 1)};
  const auto path = link_passes({passes}, locations, request_for("flat:D=4"), {});
  check_all_cut(path, passes);
  // From (-2, -2), where the first ends, the corner (7, -3) is nearest: it is passed twice.
  int passed = 0;
  for (const model::Move& move : path.moves) passed += move.to == Vec3{7, -3, 1};
  CHECK(passed == 2);
  CHECK(descents(path) == 1);
}

TEST_CASE("groups are cut in their order", "[unit][linking]") {
  const CutterLocations locations({}, model::parse_cutter("flat:D=4"), 0);
  const std::vector<CutPass> high = {square_at(0, 0, 2, 1), square_at(9, 0, 2, 1)};
  const std::vector<CutPass> low = {square_at(0, 0, 2, 0), square_at(9, 0, 2, 0)};
  const auto path = link_passes({high, low}, locations, request_for("flat:D=4"), {});
  double lowest = 1;
  std::size_t first_low = 0, last_high = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const double z = path.moves[i].to.z;
    if (z == 1) last_high = i;
    if (z == 0 && lowest == 1) first_low = i, lowest = 0;
  }
  CHECK(first_low > 0);
  // The link down may rise from a pass of the first group only before the second has begun.
  CHECK(last_high < first_low);
}

TEST_CASE("entries into standing material keep to the ramp angle", "[property][linking]") {
  const Entry entry = GENERATE(Entry::ramp, Entry::helix);
  const bool helix = entry == Entry::helix;
  INFO(helix);
  const CutterLocations locations({test::height_grid(30, 30, [](double, double) { return -2.0; })},
                                  model::parse_cutter("flat:D=8"), 0.2);
  const StageRequest request = request_for("flat:D=8", entry);
  CutPass pass = square_at(0, 0, 5, -1);
  pass.stands_to_mm = 2;
  const auto path = link_passes({{pass}}, locations, request, {});
  check_all_cut(path, {pass});
  const double slope = std::tan(request.cut.ramp_angle_deg * std::numbers::pi / 180);
  int ramps = 0;
  double lowest_vertical = 10;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 &a = model::move_from(path, i), &b = path.moves[i].to;
    const double level = std::hypot(b.x - a.x, b.y - a.y);
    if (!(b.z < a.z)) continue;
    if (level == 0) {
      lowest_vertical = std::min(lowest_vertical, b.z);
      continue;
    }
    ++ramps;
    CHECK(path.moves[i].feed_mm_min == 300);
    CHECK(a.z - b.z <= slope * level);
    if (helix) CHECK(std::hypot(b.x + 5, b.y + 5) <= 2 * 0.4 * 4 + 1e-9);
  }
  CHECK(ramps > 4);
  CHECK(lowest_vertical >= 2);
  CHECK(deepest(locations, links_of(path, {pass})) <= kLinkError);
}

TEST_CASE("a helix that has no room gives way to a ramp along the pass", "[unit][linking]") {
  // A slot along X with walls 0.3 mm beside the cutter: no helix, but the pass itself is free.
  const auto slot = test::grid_of(2, 2, [](int u, int v) {
    return Vec3{40.0 * u - 20, 4.3, 10.0 * v - 5};
  });
  auto other = slot;
  for (Vec3& p : other.points) p.y = -p.y;
  const CutterLocations locations({slot, other}, model::parse_cutter("flat:D=8"), 0);
  const StageRequest request = request_for("flat:D=8", Entry::helix);
  const ApproachRule rule{locations, request, 1};
  const std::vector<Vec3> tips = {{-10, 0, -1}, {10, 0, -1}};
  CHECK_FALSE(helix_to(rule, tips, 3).has_value());
  const auto ramp = ramp_along(rule, tips, 3);
  REQUIRE(ramp.has_value());
  CHECK(ramp->front().z == Approx(2));
  CHECK(ramp->back() == tips.front());
  for (const Vec3& tip : *ramp) CHECK(tip.y == 0);
}

TEST_CASE("a retract stands above the stock and the location surface", "[unit][linking]") {
  const CutterLocations low({test::height_grid(4, 30, [](double, double) { return 0.0; })},
                            model::parse_cutter("flat:D=4"), 0.5);
  const CutterLocations high({test::height_grid(4, 30, [](double, double) { return 40.0; })},
                             model::parse_cutter("flat:D=4"), 0.5);
  const StageRequest request = request_for("flat:D=4");
  CHECK(clear_height_mm(low, request) == Approx(10));
  CHECK(clear_height_mm(high, request) == Approx(45.5));
  CHECK(link_passes({}, low, request, {}).moves.empty());
  CHECK(link_passes({{CutPass{}}}, low, request, {}).moves.empty());
}
