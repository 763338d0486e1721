#pragma once

#include <random>
#include <vector>

#include "model/part/stock.h"
#include "model/part/toolpath.h"
#include "simulator/sweep/turning/turning_move.h"
#include "tests/simulator/sweep/profile_oracle.h"

namespace limitgauge::simulator::test {

/// A move with what turns it, as its definition has it: an axis evenly along a great circle.
struct TurnedMove {
  model::Vec3 from, to, axis_from{0, 0, 1}, axis_to{0, 0, 1};

  model::Vec3 axis(double t) const;
  TurningMove move(const CutterProfile& profile) const {
    return {from, to, axis_from, axis_to, profile.core_height()};
  }
};

/// The signed distance of the oracle's cutter at one time, and the least of many times with a
/// golden section about each that is lower than those beside it.
double distance_at(const ProfileOracle& oracle, const TurnedMove& move, const model::Vec3& p,
                   double t);
double brute_turning_distance(const ProfileOracle& oracle, const TurnedMove& move,
                              const model::Vec3& p, int steps);

/// Random moves and places near them; the same for the same seed.
class TurningDraw {
 public:
  explicit TurningDraw(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  model::Vec3 within(double half) {
    return {between(-half, half), between(-half, half), between(-half, half)};
  }
  model::Vec3 direction();
  /// From far below a micrometre to some millimetres, and from no turn to 90 degrees; one in ten
  /// has no length, one in ten no turn.
  TurnedMove move();
  /// Near the cutter at some time, most often.
  model::Vec3 place(const TurnedMove& move, double around_mm = 6);
  std::size_t one_of(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }

 private:
  std::mt19937_64 random_;
};

/// Ball, bull, flat and taper, a drill, and a ball whose flutes end below its top.
const std::vector<model::Cutter>& turning_cutters();

/// A path of `moves` turning moves over a block about zero, its tool leaning up to 40 degrees from
/// +Z, with a few that have no length or no turn.
model::Pass turning_pass(const model::Cutter& cutter, unsigned seed, int moves = 40);
/// The moves of such a pass.
std::vector<TurnedMove> turned_moves(const model::Pass& pass);
model::BoxStock turning_block();

/// The same sweep from moves in the other order, each preceded by one in the air that goes to where
/// it begins.
model::Pass with_axes(const model::Cutter& cutter, const std::vector<TurnedMove>& chain);

}  // namespace limitgauge::simulator::test
