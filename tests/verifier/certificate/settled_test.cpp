// Parts of planes that once took minutes, or no verdict came of: settled at the default resolution,
// by no more cells than a few seconds' worth. (Time is measured in tests/benchmark; cells are the
// same on every machine.)
#include <numbers>

#include "tests/support/catch.h"
#include "tests/support/judging.h"
#include "tests/support/part_cages.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;
using namespace tests;

constexpr std::size_t kMostCells = 50'000;  // measured: 784 to 31,222

/// The verdict, which must be one, by the cells allowed.
Judged settle(const model::Cage& cage, const model::BoxStock& block,
              const std::vector<Pass>& passes, const GateLimits& limits, Verdict expected,
              double allowance_mm = 0, std::size_t most_cells = kMostCells) {
  const ReferenceSurface surface(cage);
  const Judged judged = judge(surface, block, passes, limits, allowance_mm);
  const StageDeviation& d = judged.deviation;
  CAPTURE(d.gouge_mm.low, d.gouge_mm.high, d.uncut_mm.low, d.uncut_mm.high, d.cells);
  for (const auto* found : {&d.gouges, &d.uncuts})
    if (!found->empty()) {
      const SurfacePlace& place = found->front().place;
      UNSCOPED_INFO(found->front().depth_mm << " mm at " << place.point.x << " " << place.point.y
                                            << " " << place.point.z);
    }
  CHECK(judged.decision.verdict == expected);
  CHECK(d.cells < most_cells);
  return judged;
}

/// Down, along and up again.
void cut_along(model::Toolpath& path, const Vec3& a, const Vec3& b) {
  feed_to(path, {a.x, a.y, 9});
  feed_to(path, a);
  feed_to(path, b);
  feed_to(path, {b.x, b.y, 9});
}

model::Toolpath begun() {
  model::Toolpath path;
  path.start = {-30, -30, 9};
  return path;
}

/// A top at z = 0 faced by a flat of radius r.
void face_top(model::Toolpath& path, double half_x, double half_y, double r) {
  for (double x = -half_x; x <= half_x + r; x += 1.5 * r)
    cut_along(path, {x, -half_y - r, 0}, {x, half_y + r, 0});
}

}  // namespace

TEST_CASE("settled: plain slots by flats", "[slow][definition2]") {
  // 4 mm wide, 3 mm deep; flats as wide as the slot, and half as wide in two passes.
  const Slot slot{4, 3, 5, 10};
  const auto block = block_between({-7.5, -5.5, -8}, {7.5, 5.5, 0.5});
  for (const double r : {2.0, 1.2}) {
    model::Toolpath path = begun();
    face_top(path, 7.5, 5.5, r);
    for (const double z : {-1.0, -2.0, -3.0})
      for (const double x : {r - 2, 2 - r}) cut_along(path, {x, -9, z}, {x, 9, z});
    settle(slot_cage(slot), block, {pass_of(flat_cutter(r), path)}, both_gates(0.05, 0.05),
           Verdict::pass);
    // One level too few, a wall forgotten.
    model::Toolpath shallow = begun();
    face_top(shallow, 7.5, 5.5, r);
    for (const double x : {r - 2, 2 - r}) cut_along(shallow, {x, -9, -2.8}, {x, 9, -2.8});
    settle(slot_cage(slot), block, {pass_of(flat_cutter(r), shallow)}, both_gates(0.05, 0.05),
           Verdict::fail);
  }
}

TEST_CASE("settled: slot and face by flats, in all orders of moves", "[slow][definition2]") {
  const Slot slot{4, 3, 5, 10};
  const auto block = block_between({-7.5, -5.5, -8}, {7.5, 5.5, 0.5});
  const auto slot_moves = [](bool backwards) {
    model::Toolpath path = begun();
    for (const double z : {-1.5, -3.0})
      cut_along(path, {0, backwards ? 9.0 : -9.0, z}, {0, backwards ? -9.0 : 9.0, z});
    return path;
  };
  model::Toolpath face = begun();
  face_top(face, 7.5, 5.5, 3);
  for (const bool backwards : {false, true}) {
    const Pass slotting = pass_of(flat_cutter(2), slot_moves(backwards)),
               facing = pass_of(flat_cutter(3), face);
    settle(slot_cage(slot), block, {slotting, facing}, both_gates(0.05, 0.05), Verdict::pass);
    settle(slot_cage(slot), block, {facing, slotting}, both_gates(0.05, 0.05), Verdict::pass);
  }
}

TEST_CASE("settled: a T-slot part under a flat in fewer than 40 moves", "[slow][definition2]") {
  // The flat mills top and slot and cannot go under; what stays there is nobody's uncut. It goes a
  // micrometre too far into the walls above, past the tolerance of contact.
  const TSlot part{4, 8, 2, 4, 1.5, 12};
  const auto block = block_between({-6, -6.5, -8}, {6, 6.5, 0.5});
  model::Toolpath path = begun();
  for (const double x : {-5.0, -3.0, 3.0, 5.0}) cut_along(path, {x, -8, 0}, {x, 8, 0});
  for (const double z : {-2.0, -4.0})
    for (const double x : {-0.5004, 0.5004}) cut_along(path, {x, -12, z}, {x, 12, z});
  settle(t_slot_cage(part), block, {pass_of(flat_cutter(1.5), path)}, both_gates(0.05, 0.05),
         Verdict::pass);
  for (model::Move& m : path.moves)
    if (m.to.z < 0) m.to.z += 0.2;
  settle(t_slot_cage(part), block, {pass_of(flat_cutter(1.5), path)}, both_gates(0.05, 0.05),
         Verdict::fail);
}

TEST_CASE("settled: a T-slot cutter under a ledge on a small part", "[slow][definition2]") {
  // 3 by 4 mm; the cutter of D4 with flutes of 1 mm on a shank of 2 mm.
  const model::Cage cage =
      drawn_outline({{-1.5, 0}, {-0.3, 0}, {-0.3, -1}, {-1.2, -1}, {-1.2, -2.1}, {1.5, -2.1}}, 4);
  const auto block = block_between({-1.5, -2, -4}, {1.5, 2, 0.2});
  model::Cutter t_slot = flat_cutter(2);
  t_slot.flute_length_mm = 1, t_slot.shank = {{2, 15}};
  model::Toolpath top = begun();
  face_top(top, 3, 3, 2);
  for (const double x : {1.6996, 2.7}) cut_along(top, {x, -6, -2.1}, {x, 6, -2.1});
  const Pass milled = pass_of(flat_cutter(2), top);
  // Under the ledge as far as its neck lets it: x from −1.2 on, tip from −2.1 to −2.
  model::Toolpath under = begun();
  for (const double z : {-2.1, -2.0})
    for (const Vec3& to :
         {Vec3{5, -8, 9}, {5, -8, z}, {0.8, -8, z}, {0.8, 8, z}, {5, 8, z}, {5, 8, 9}})
      feed_to(under, to);
  settle(cage, block, {milled, pass_of(t_slot, under)}, both_gates(0.05, 0.05), Verdict::pass);
  // Not gone under at all, though it could.
  model::Toolpath beside = begun();
  cut_along(beside, {6, -8, -2.1}, {6, 8, -2.1});
  settle(cage, block, {milled, pass_of(t_slot, beside)}, both_gates(0.05, 0.05), Verdict::fail);
}

TEST_CASE("settled: a boss of planes", "[slow][definition2]") {
  const double half = 3, r = 2, out = half + r, deep = -2;
  const model::Cage cage = boss_on_floor_cage({{-half, -half, deep}, {half, half, 0}}, 4);
  const auto block = block_between({-7.5, -7.5, -6}, {7.5, 7.5, 0.5});
  model::Toolpath path = begun();
  face_top(path, 7.5, 7.5, r);
  for (const double z : {-1.0, deep})
    for (const double o : {out, out + 2.5}) {
      feed_to(path, {-o, -o, 9});
      for (const Vec3& to : {Vec3{-o, -o, z}, {o, -o, z}, {o, o, z}, {-o, o, z}, {-o, -o, z}})
        feed_to(path, to);
      feed_to(path, {-o, -o, 9});
    }
  settle(cage, block, {pass_of(flat_cutter(r), path)}, both_gates(0.05, 0.05), Verdict::pass);
  model::Toolpath wide = path;
  for (model::Move& m : wide.moves)
    if (m.to.z < 0) m.to.x *= (out + 0.2) / out, m.to.y *= (out + 0.2) / out;
  settle(cage, block, {pass_of(flat_cutter(r), wide)}, both_gates(0.05, 0.05), Verdict::fail);
}

TEST_CASE("settled: a boss with its allowance, rolled round its corners and mitred",
          "[slow][definition2]") {
  const double half = 3, r = 2, deep = -2, keep = 0.3, round = r + keep, out = half + round;
  const model::Cage cage = boss_on_floor_cage({{-half, -half, deep}, {half, half, 0}}, 4);
  const auto block = block_between({-7.5, -7.5, -6}, {7.5, 7.5, 0.5});
  // Chords outside the arc by no more than the tolerance of contact.
  constexpr int kChords = 128;
  const double turn = std::numbers::pi / 2 / kChords, beyond = round / std::cos(turn / 2);
  const auto milled = [&](bool rolled) {
    model::Toolpath path = begun();
    for (double x = -7.5; x <= 9.5; x += 1.5 * r) cut_along(path, {x, -9.5, keep}, {x, 9.5, keep});
    const double z = deep + keep;
    feed_to(path, {out, -half, 9});
    feed_to(path, {out, -half, z});
    for (int side = 0; side < 4; ++side) {
      const double x = side % 3 == 0 ? half : -half, y = side < 2 ? half : -half;
      const double begin = side * std::numbers::pi / 2;
      feed_to(path, {x + round * std::cos(begin), y + round * std::sin(begin), z});
      for (int k = 0; rolled && k < kChords; ++k) {
        const double at = begin + (k + 0.5) * turn;
        feed_to(path, {x + beyond * std::cos(at), y + beyond * std::sin(at), z});
      }
      if (!rolled) feed_to(path, {x > 0 ? out : -out, y > 0 ? out : -out, z});
    }
    feed_to(path, {out, -half, z});
    for (const Vec3& to : {Vec3{8, -8, z}, {8, 8, z}, {-8, 8, z}, {-8, -8, z}, {8, -8, z}})
      feed_to(path, to);
    return std::vector<Pass>{pass_of(flat_cutter(r), path)};
  };
  settle(cage, block, milled(true), both_gates(0.05, 0.2), Verdict::pass, keep);
  // A mitre leaves the allowance of the walls on the floor's corner, over all the boss's height.
  const Judged mitred =
      settle(cage, block, milled(false), both_gates(0.05, 0.2), Verdict::fail, keep);
  CHECK(mitred.deviation.uncut_mm.low == Approx(-deep).margin(1e-5));
}

TEST_CASE("settled: a pocket cut clean, whose corners the flat cannot reach",
          "[slow][definition2]") {
  const double half = 3, r = 2, deep = -4, way = half - r;
  const model::Cage cage = pocket_cage({half, -deep, 9});
  const auto block = block_between({-9, -9, -8}, {9, 9, 0});
  const auto milled = [&](double floor) {
    model::Toolpath path = begun();
    feed_to(path, {0, 0, 9});
    for (const Vec3& to : {Vec3{0, 0, floor},
                           {-way, 0, floor},
                           {-way, -way, floor},
                           {way, -way, floor},
                           {way, way, floor},
                           {-way, way, floor},
                           {-way, -way, floor},
                           {-way, -way, 9}})
      feed_to(path, to);
    return std::vector<Pass>{pass_of(flat_cutter(r), path)};
  };
  // At the fillets cells are small (measured: 421,512).
  constexpr std::size_t most_cells = 600'000;
  // The fillets of radius r stand, 0.83 mm over the diagonals, where nothing reaches them.
  const Judged clean =
      settle(cage, block, milled(deep), both_gates(0.01, 0.01), Verdict::pass, 0, most_cells);
  CHECK(clean.deviation.unavoidable_uncut_mm.high ==
        Approx((std::numbers::sqrt2 - 1) * r).margin(0.01));
  const Judged deeper = settle(cage, block, milled(deep - 0.02), both_gates(0.01, 0.01),
                               Verdict::fail, 0, most_cells);
  CHECK(deeper.deviation.gouge_mm.low == Approx(0.02).margin(1e-5));
  const Judged shallow =
      settle(cage, block, milled(deep + 0.02), both_gates(0.01, 0.01), Verdict::fail);
  // From the foot of a wall what stands on the floor reads as wide as the pocket is.
  CHECK(shallow.deviation.uncut_mm.low == Approx(2 * half).margin(1e-5));
}

TEST_CASE("settled: a channel two micrometres narrower than its cutter", "[slow][definition2]") {
  // A flat goes in a micrometre too deep on either side; a tenth of a millimetre stays on the
  // floor.
  const Slot slot{5.998, 3, 5, 10};
  // From the ends it reaches the floor, and at the walls' rims what it takes is as deep as they
  // are.
  const auto block = block_between({-8.5, -5, -8}, {8.5, 5, 0.5});
  model::Toolpath path = begun();
  face_top(path, 8.5, 5.5, 3);
  cut_along(path, {0, -9, -2.9}, {0, 9, -2.9});
  settle(slot_cage(slot), block, {pass_of(flat_cutter(3), path)}, both_gates(0.05, 0.05),
         Verdict::fail);
}

TEST_CASE("settled: a T-slot by two tools", "[slow][definition2]") {
  const TSlot part{4, 8, 2, 4, 1.5, 12};
  const auto block = block_between({-6, -6.5, -8}, {6, 6.5, 0.5});
  model::Toolpath path = begun();
  for (const double x : {-5.0, -3.0, 3.0, 5.0}) cut_along(path, {x, -8, 0}, {x, 8, 0});
  for (const double z : {-2.0, -4.0})
    for (const double x : {-0.5, 0.5}) cut_along(path, {x, -12, z}, {x, 12, z});
  model::Cutter t_slot = flat_cutter(3);
  t_slot.flute_length_mm = 1.8, t_slot.shank = {{1.4, 20}};
  model::Toolpath under = begun();
  for (const double z : {-4.0, -3.8})
    for (const double x : {-0.4, 0.0, 0.4}) cut_along(under, {x, -14, z}, {x, 14, z});
  // Its neck would let it go 0.2 mm further aside, and further yet about the part's ends.
  const Judged judged =
      settle(t_slot_cage(part), block, {pass_of(flat_cutter(1.5), path), pass_of(t_slot, under)},
             both_gates(0.05, 0.05), Verdict::fail);
  CHECK(judged.deviation.uncut_mm.low > 1.9);
}

TEST_CASE("settled: a step cut to its allowance exactly", "[slow][definition2]") {
  // Floor and wall keep 0.3 mm and are asked for 0.3 mm.
  const model::Cage cage = drawn_outline({{-4, 0}, {0, 0}, {0, 4}}, 10);
  const auto block = block_between({-6, -10, -4}, {4, 10, 4});
  const double keep = 0.3, r = 3;
  model::Toolpath path = begun();
  for (const double x : {-keep - r, -keep - 2 * r}) cut_along(path, {x, -20, keep}, {x, 20, keep});
  settle(cage, block, {pass_of(flat_cutter(r), path)}, both_gates(0.05, 0.2), Verdict::pass, keep);
}

}  // namespace limitgauge::verifier
