#include <map>
#include <numbers>

#include "engine/strategy/raster/clearing_field.h"
#include "engine/strategy/strategies.h"
#include "engine/surface/patch_model.h"
#include "tests/engine/cages.h"
#include "tests/engine/cutter_outline.h"
#include "tests/engine/stock_heights.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace engine;
using model::Vec3;
using strategy::CutDirection;
using strategy::Entry;

namespace {

model::Cage cage_named(const std::string& name) {
  if (name == "dome") return test::paraboloid_cage(6, 5, -0.02);
  if (name == "bowl") return test::paraboloid_cage(6, 5, 0.04);
  return test::cube_cage(12);
}

/// Two millimetres of stock around the part, its top one above it.
strategy::StageRequest request_for(const model::Box3& part, const std::string& cutter) {
  strategy::StageRequest r;
  r.cut.strategy = strategy::Strategy::contour;
  r.cutter = model::parse_cutter(cutter);
  r.cut.step_mm = 1;
  r.cut.tolerance_mm = 0.05;
  r.cut.feed_mm_min = 1000;
  r.cut.plunge_feed_mm_min = 300;
  r.cut.link_feed_mm_min = 2000;
  r.allowance_mm = 0.2;
  r.clearance_mm = 2;
  r.floor_z_mm = part.low.z;
  r.stock = model::BoxStock{part.low - Vec3{2, 2, 1}, part.size() + Vec3{4, 4, 2}};
  return r;
}

struct Planned {
  strategy::StageRequest request;
  model::Toolpath path;
  std::vector<Vec3> surface;  ///< points of the limit surface, a few tenths apart
};

Planned planned(const std::string& cage_name, const std::string& cutter,
                const std::function<void(strategy::StageRequest&)>& change = {}) {
  const model::Cage cage = cage_named(cage_name);
  const surface::FinishModel finish(cage, {0.01, 6, 10}, {});
  Planned result{request_for(finish.patches().bounding_box(), cutter), {}, {}};
  if (change) change(result.request);
  result.path = plan_stage(finish, result.request, {}).path;
  constexpr int kDepth = 4;  // A patch in sixteen parts each way.
  const surface::PatchModel dense(cage, {1e-6, 0, kDepth}, {});
  for (const auto& patch : dense.patches())
    result.surface.insert(result.surface.end(), patch.limit.points.begin(),
                          patch.limit.points.end());
  return result;
}

/// Moves along each level: both ends at one height below the top of the stock.
std::map<double, std::vector<std::pair<Vec3, Vec3>>> cuts_by_level(const Planned& p) {
  std::map<double, std::vector<std::pair<Vec3, Vec3>>> levels;
  const double top = model::bounding_box(p.request.stock).high.z;
  for (std::size_t i = 0; i < p.path.moves.size(); ++i) {
    const Vec3 a = model::move_from(p.path, i), b = p.path.moves[i].to;
    if (p.path.moves[i].kind == model::MoveKind::feed && a.z == b.z && b.z < top)
      levels[b.z].push_back({a, b});
  }
  return levels;
}

double distance_to(const Vec3& p, const std::pair<Vec3, Vec3>& cut) {
  const Vec3 d = cut.second - cut.first;
  const double t = std::clamp(dot(p - cut.first, d) / length_squared(d), 0.0, 1.0);
  return distance(p, cut.first + d * t);
}

}  // namespace

TEST_CASE("a contour keeps its allowance with every kind of cutter", "[slow][contour]") {
  const std::string cutter =
      GENERATE("flat:D=8", "bull:D=8,r=2", "ball:D=6", "taper:D=4,r=1,angle=10,L=12");
  const std::string cage = GENERATE("dome", "bowl", "cube");
  INFO(cutter << " over a " << cage);
  const Planned p = planned(cage, cutter);
  REQUIRE(p.path.moves.size() > 20);
  const test::CutterOutline outline(p.request.cutter);
  double least = 1e9;
  for (std::size_t i = 0; i < p.path.moves.size(); i += 3) {
    const Vec3 tip = p.path.moves[i].to;
    for (const Vec3& s : p.surface)
      if (s.z >= tip.z - 1 && std::abs(s.x - tip.x) < 6 && std::abs(s.y - tip.y) < 6)
        least =
            std::min(least, outline.distance_mm(std::hypot(s.x - tip.x, s.y - tip.y), s.z - tip.z));
  }
  // The height map is an upper bound: nothing but rounding is forgiven.
  CHECK(least >= p.request.allowance_mm - 1e-9);
}

TEST_CASE("a contour leaves nothing that the tip can reach", "[slow][contour]") {
  const std::string cutter =
      GENERATE("flat:D=8", "bull:D=8,r=2", "ball:D=6", "taper:D=4,r=1,angle=10,L=12");
  const std::string cage = GENERATE("dome", "bowl", "cube");
  INFO(cutter << " over a " << cage);
  const Planned p = planned(cage, cutter);
  const test::CutterOutline outline(p.request.cutter);
  // Farther off than this nothing can be touched.
  const double sight = model::largest_radius_mm(p.request.cutter) + 1;
  const double radius = strategy::profile_radius_mm(p.request.cutter, p.request.cut.step_mm);
  // What rasters of 0.1 and up to 0.3 mm may cost: twice the diagonal of a fine pixel, the height
  // over one on a slope of 45 degrees, and the border's own share of a pixel.
  const double kept = p.request.allowance_mm + 0.6;
  const model::Box3 stock = model::bounding_box(p.request.stock);
  const auto levels = cuts_by_level(p);
  REQUIRE(levels.size() >= 2);
  int looked_at = 0;
  double farthest = 0;
  for (const auto& [level, cuts] : levels)
    for (double x = stock.low.x; x <= stock.high.x; x += 1.23)
      for (double y = stock.low.y; y <= stock.high.y; y += 1.23) {
        const double z = level;
        const Vec3 tip{x, y, z};
        const bool clear = std::all_of(p.surface.begin(), p.surface.end(), [&](const Vec3& s) {
          if (s.z < z - kept || std::abs(s.x - x) > sight || std::abs(s.y - y) > sight) return true;
          return outline.distance_mm(std::hypot(s.x - x, s.y - y), s.z - z) > kept;
        });
        if (!clear) continue;
        double nearest = 1e9;
        for (const auto& cut : cuts) nearest = std::min(nearest, distance_to(tip, cut));
        farthest = std::max(farthest, nearest);
        ++looked_at;
      }
  CHECK(looked_at > 50);
  CHECK(farthest <= radius);
}

TEST_CASE("climb milling leaves the part on the right", "[property][contour]") {
  const CutDirection direction = GENERATE(CutDirection::climb, CutDirection::conventional);
  const std::string cage = GENERATE("bowl", "cube");
  const Planned p = planned(cage, "flat:D=8", [&](auto& r) { r.cut.direction = direction; });
  const double wanted = direction == CutDirection::climb ? 1 : -1, radius = 4;
  int along_part = 0, wrong = 0;
  for (const auto& [z, cuts] : cuts_by_level(p))
    for (const auto& [a, b] : cuts) {
      if (distance(a, b) < 0.2) continue;
      const Vec3 middle = (a + b) * 0.5;
      // The nearest part of the surface that stands beside the cutter.
      Vec3 nearest;
      double least = 1e9;
      for (const Vec3& s : p.surface)
        if (const double d = std::hypot(s.x - middle.x, s.y - middle.y); s.z > z && d < least) {
          least = d;
          nearest = s;
        }
      if (least > radius + p.request.allowance_mm + 0.4) continue;
      const Vec3 way = b - a, to_part = nearest - middle;
      const double right = way.y * to_part.x - way.x * to_part.y;
      ++along_part;
      wrong += right * wanted <= 0;
    }
  CHECK(along_part > 20);
  // Links come down to the border from outside it, and end with the part ahead of them.
  CHECK(wrong <= along_part / 20);
}

TEST_CASE("a contour enters standing material at the ramp's angle", "[property][contour]") {
  const Entry entry = GENERATE(Entry::ramp, Entry::helix);
  const std::string cage = GENERATE("bowl", "cube");
  const Planned p = planned(cage, "flat:D=8", [&](auto& r) {
    r.cut.entry = entry;
    r.cut.ramp_angle_deg = 5;
  });
  const double steepest = std::tan(5 * std::numbers::pi / 180);
  test::StockHeights stock(p.request.stock, 0.25);
  // Within a pixel of the coarse raster, and one of this one, entries may meet a sliver.
  const double radius = 4, blind = 0.6;
  int ramps = 0;
  for (std::size_t i = 0; i < p.path.moves.size(); ++i) {
    const Vec3 a = model::move_from(p.path, i), b = p.path.moves[i].to;
    const bool rapid = p.path.moves[i].kind == model::MoveKind::rapid;
    const double flat = std::hypot(b.x - a.x, b.y - a.y), fall = a.z - b.z;
    INFO("move " << i << " to " << b.x << " " << b.y << " " << b.z);
    if (rapid)
      REQUIRE(stock.highest_mm(a, b, radius - blind) <= std::min(a.z, b.z) + 1e-9);
    else if (fall > 0 && fall > flat * steepest * (1 + 1e-6))
      REQUIRE(stock.highest_mm(b, b, radius - blind) <= b.z + 1e-9);
    else if (fall > 0)
      ++ramps;
    if (!rapid) stock.cut(a, b, radius);
  }
  CHECK(ramps > 0);
  // All of it is down to the floor where nothing of the part stands: at the corners.
  const model::Box3 box = model::bounding_box(p.request.stock);
  if (cage == "cube") CHECK(stock.highest_mm(box.low, box.low, 1) <= p.request.floor_z_mm + 1e-9);
}

TEST_CASE("conventional, climb and either clear alike; links run at their feed",
          "[property][contour]") {
  const auto length = [&](CutDirection direction) {
    const Planned p = planned("cube", "flat:D=8", [&](auto& r) { r.cut.direction = direction; });
    bool links = false;
    for (const model::Move& move : p.path.moves) links |= move.feed_mm_min == 2000;
    CHECK(links);
    return model::lengths(p.path, 5000).cut_mm;
  };
  const double climb = length(CutDirection::climb);
  CHECK(length(CutDirection::conventional) == Approx(climb).epsilon(0.1));
  CHECK(length(CutDirection::either) < climb * 1.1);
}

TEST_CASE("loops of a contour lie almost a cutter's diameter apart", "[property][contour]") {
  // Nothing of the part is in sight: 40 x 24 mm, 4 mm deep, in levels of a millimetre.
  model::Cage cage = cage_named("cube");
  for (Vec3& v : cage.vertices) v.z -= 100;
  const surface::FinishModel finish(cage, {0.01, 4.2, 10}, {});
  auto request = request_for({{-20, -12, 0}, {20, 12, 4}}, "flat:D=8");
  request.floor_z_mm = 1;
  const auto stage = plan_stage(finish, request, {});
  const Vec3 size = model::bounding_box(request.stock).size();
  const double least = 4 * size.x * size.y / 8;
  const double cut = model::lengths(stage.path, 5000).cut_mm;
  // No path can be shorter than the area over the diameter; loops at 0.95 radii take 2.1 times it.
  CHECK(cut > least * 0.8);
  CHECK(cut < least * 1.5);
}

TEST_CASE("contours that cannot be cut as asked are refused by name", "[unit][contour]") {
  const auto asking = [&](const std::function<void(strategy::StageRequest&)>& change) {
    return planned("cube", "flat:D=8", change);
  };
  CHECK_THROWS_WITH(asking([](auto& r) { r.cut.ramp_angle_deg = 0; }),
                    ContainsSubstring("ramp_angle"));
  CHECK_THROWS_WITH(asking([](auto& r) { r.cut.link_feed_mm_min = 0; }),
                    ContainsSubstring("link_feed"));
}
