// What the verifier finds uncut, the engine's rest strategy cuts: and nothing else.

#include "engine/strategy/strategies.h"

#include <array>

#include "engine/surface/finish_model.h"
#include "engine/surface/patch_model.h"
#include "tests/support/catch.h"
#include "verifier/certificate/leftover_regions.h"

using namespace limitgauge;
using namespace engine;
using model::Vec3;

namespace {

constexpr double kUncutLimit_mm = 0.04;

/// A plate with a valley along Y whose fillets have a radius of about 3 mm.
model::Cage valley() {
  constexpr std::array<double, 10> kX = {-14, -10, -6, -3.5, -1.2, 1.2, 3.5, 6, 10, 14};
  model::Cage cage;
  for (int j = 0; j < 5; ++j)
    for (const double x : kX) cage.vertices.push_back({x, 5.0 * j - 10, std::abs(x) < 2 ? 0.0 : 3});
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 9; ++i) {
      const model::Index a = j * 10 + i;
      cage.add_face(std::array<model::Index, 4>{a, a + 1, a + 11, a + 10});
    }
  return cage;
}

struct Bench {
  model::Cage cage = valley();
  model::Stock stock = model::BoxStock{{-16, -12, -4}, {32, 24, 8}};
  verifier::ReferenceSurface reference{cage};
  surface::FinishModel finish{cage, {0.005, 5, 10}, {}};

  strategy::StageRequest request(strategy::Strategy strategy, const std::string& cutter,
                                 double step_mm) const {
    strategy::StageRequest r;
    r.cut.strategy = strategy;
    r.cut.step_mm = step_mm;
    r.cut.steep_angle_deg = 60;
    r.cut.overlap_mm = 0.5;
    r.cut.tolerance_mm = 0.01;
    r.cut.feed_mm_min = r.cut.link_feed_mm_min = 1200;
    r.cut.plunge_feed_mm_min = 300;
    r.cutter = model::parse_cutter(cutter);
    r.clearance_mm = 2;
    r.floor_z_mm = -r.cutter.radius_mm() - 0.5;
    r.stock = stock;
    return r;
  }
  verifier::Pass pass(const strategy::StageRequest& request) const {
    return {request.cutter,
            std::make_shared<const model::Toolpath>(plan_stage(finish, request, {}).path)};
  }
  verifier::Pass large() const {
    return pass(request(strategy::Strategy::zigzag, "ball:D=10,L=25", 0.4));
  }
  strategy::StageRequest small(strategy::Strategy strategy) const {
    return request(strategy, "ball:D=2,L=12", 0.2);
  }
  verifier::LeftoverRegions left(const std::vector<verifier::Pass>& passes) const {
    verifier::LeftoverRequest asked;
    asked.cutter = small(strategy::Strategy::rest).cutter;
    asked.threshold_mm = kUncutLimit_mm / 2;
    return find_leftover_regions(reference, stock, passes, asked, {});
  }
  verifier::Verdict verdict(const std::vector<verifier::Pass>& passes) const {
    verifier::StageCheck check;
    check.limits.has_gouge = check.limits.has_uncut = true;
    check.limits.gouge_mm = check.limits.uncut_mm = kUncutLimit_mm;
    check.resolution_mm = 0.004;
    const auto measured = measure_stage(reference, stock, passes, nullptr, check, {});
    return decide(measured, check.limits).verdict;
  }
};

double cut_mm(const verifier::Pass& pass) {
  return model::lengths(*pass.path, 5000).cut_mm;
}

}  // namespace

TEST_CASE("a rest stage cuts what a larger ball has left, and little else", "[slow][rest]") {
  const Bench bench;
  const verifier::Pass large = bench.large();
  const verifier::LeftoverRegions regions = bench.left({large});
  REQUIRE(regions.complete);
  REQUIRE(!regions.boxes.empty());
  // The fillets lie within 4 mm of the valley's bottom; the plate beside it is done.
  for (const model::Box3& box : regions.boxes) CHECK(std::abs(box.centre().x) < 4);

  strategy::StageRequest request = bench.small(strategy::Strategy::rest);
  request.regions = regions.boxes;
  const verifier::Pass rest = bench.pass(request);
  CHECK(bench.verdict({large, rest}) == verifier::Verdict::pass);
  CHECK(bench.left({large, rest}).boxes.empty());
  const verifier::Pass whole = bench.pass(bench.small(strategy::Strategy::steep_shallow));
  CHECK(bench.verdict({large, whole}) == verifier::Verdict::pass);
  // Measured 0.23: the valley's share of the plate, and the overlap on either side.
  CHECK(cut_mm(rest) < 0.35 * cut_mm(whole));
  // No move at the feed lies away from the regions but for links of a few millimetres.
  constexpr double kLink_mm = 2;
  for (const model::Move& move : rest.path->moves)
    if (move.kind == model::MoveKind::feed) CHECK(comes_near_regions(request, kLink_mm, move.to));
}

TEST_CASE("without the rest stage the small ball's gate fails", "[slow][rest]") {
  const Bench bench;
  const verifier::Pass large = bench.large();
  strategy::StageRequest request = bench.small(strategy::Strategy::rest);
  const verifier::Pass nothing = bench.pass(request);
  CHECK(nothing.path->moves.empty());
  CHECK(nothing.path->start.z > model::bounding_box(bench.stock).high.z);
  CHECK(bench.verdict({large, nothing}) == verifier::Verdict::fail);
}

TEST_CASE("leftover regions need a threshold", "[unit][rest]") {
  const Bench bench;
  CHECK_THROWS_AS(find_leftover_regions(bench.reference, bench.stock, {}, {}, {}),
                  std::invalid_argument);
}
