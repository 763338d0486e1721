#include "simulator/process/near_material.h"

#include <cmath>
#include <memory>
#include <random>

#include "simulator/stock/raw_stock.h"
#include "simulator/sweep/sweep_index.h"
#include "tests/simulator/paths.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using model::Vec3;
using simulator::Index3;

namespace {

/// Rows across the middle of a block, so that its ends stay raw.
std::shared_ptr<const simulator::SweepIndex> rows(const model::Cutter& cutter, double height_mm) {
  simulator::test::PathBuilder path({8, 0, 9});
  for (int row = 0; row < 8; ++row) {
    const double x = 8 + row, y = row % 2 ? 12 : 0;
    path.feed({x, y, height_mm}).feed({x, 12 - y, height_mm + 0.1 * row});
  }
  return std::make_shared<simulator::SweepIndex>(path.pass(cutter));
}

}  // namespace

TEST_CASE("near material answers as the whole one, wherever it was turned to before",
          "[unit][near_material]") {
  const auto flat = simulator::test::cutter(model::CutterType::flat, 4, 20),
             ball = simulator::test::cutter(model::CutterType::ball, 3, 20);
  const simulator::Material raw(simulator::RawStock(model::BoxStock{{0, 0, 0}, {24, 12, 6}}));
  const simulator::Material material = raw.after(rows(flat, 4)).after(rows(ball, 3));
  const simulator::Lattice lattice{{0, 0, 0}, 0.25};
  simulator::NearMaterial near(material, lattice);
  std::mt19937_64 random(23);
  std::uniform_int_distribution<int> along_x(0, 96), along_y(0, 48), along_z(0, 24);
  std::uniform_real_distribution<double> share(-0.2, 1.2);
  int uncut = 0;
  for (int k = 0; k < 4000; ++k) {
    // Runs of cells next to each other, and leaps between them, from raw places to cut ones.
    Index3 cell{along_x(random), along_y(random), along_z(random)};
    for (int step = 0; step < 4; ++step, ++cell[k % 3]) {
      near.turn_to(cell);
      const Vec3 p = lattice.point(cell) + Vec3{share(random), share(random), share(random)} * 0.25;
      const simulator::MaterialSample whole = material.sample(p);
      REQUIRE(std::abs(near.sample(p, {}).value - whole.value) <= 1e-12);
      uncut += whole.maker.pass == 0;
    }
  }
  // So that both are known to have been asked.
  CHECK(uncut > 4000);
  CHECK(uncut < 12000);
}
