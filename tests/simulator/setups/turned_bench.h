#pragma once

#include <random>
#include <vector>

#include "model/part/stock.h"
#include "tests/simulator/paths.h"

namespace limitgauge::simulator::test {

inline constexpr std::size_t kSetupBytes = std::size_t{2} << 30;

/// A frame beside another one: turned over, on its side, leaning, and only shifted. None through
/// the origin.
struct NamedPose {
  const char* name;
  model::Pose pose;
};
std::vector<NamedPose> setup_poses();

/// 24 by 18 by 8 mm, its top at z = 0.
model::BoxStock setup_block();

/// Flat, ball, bull and taper.
std::vector<model::Cutter> setup_cutters();

/// Every pose with every cutter, or each with one of its own where all would take long.
struct TurnedCase {
  NamedPose to;
  model::Cutter cutter;
  unsigned seed = 0;
};
std::vector<TurnedCase> turned_cases();
std::vector<TurnedCase> few_turned_cases();
/// The former, and turns drawn from all there are.
std::vector<TurnedCase> many_turned_cases();

/// Level, ramping and upright moves, short ones and none at all, feeds and rapids, in the block and
/// above it.
Pass moves_of_all_kinds(const model::Cutter& c, unsigned seed);

/// The same pass as it lies in another frame.
Pass placed(const Pass& pass, const model::Pose& pose);

/// Places drawn evenly from a box.
class PlaceDraw {
 public:
  PlaceDraw(const model::Box3& box, unsigned seed) : box_(box), random_(seed) {}
  model::Vec3 operator()();
  double between(double low, double high);

 private:
  model::Box3 box_;
  std::mt19937_64 random_;
};

}  // namespace limitgauge::simulator::test
