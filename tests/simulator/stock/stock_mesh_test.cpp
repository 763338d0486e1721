#include <algorithm>
#include <cmath>
#include <random>

#include "simulator/stock/stock_model.h"
#include "tests/simulator/mesh/mesh_check.h"
#include "tests/simulator/paths.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::BoxStock;
using model::CutterType;
using model::Vec3;
using simulator::Pass;
using simulator::StockModel;
using simulator::StockSurface;
using simulator::test::cutter;
using simulator::test::faults;
using simulator::test::PathBuilder;
using simulator::test::raster;

constexpr std::size_t kMeshBytes = std::size_t{2} << 30;

StockModel meshed_block(double voxel) {
  return {BoxStock{{-15, -10, -8}, {30, 20, 8}}, voxel, kMeshBytes, {2}};
}

double worst_vertex(const StockModel& stock, const StockSurface& surface) {
  double worst = 0;
  for (const Vec3& v : surface.mesh.vertices)
    worst = std::max(worst, std::abs(stock.exact_value(v)));
  return worst;
}

}  // namespace

TEST_CASE("a raw meshed_block's mesh has its sharp edges and corners", "[unit][stock_mesh]") {
  // Off the lattice, so that no face lies in voxel centres.
  const BoxStock box{{-15.03, -10.01, -8.07}, {30.11, 20.17, 8.13}};
  const StockModel stock(box, 0.3, kMeshBytes);
  const StockSurface surface = stock.surface({2});
  CHECK(faults(surface.mesh).none());
  CHECK(surface.unmoved == 0);
  CHECK(worst_vertex(stock, surface) <= 1e-9);
  // With the vertices along its edges on them, no more is cut off than a sixth of a voxel at each
  // corner, where the lattice's crossings may show two faces only.
  CHECK(simulator::test::enclosed_volume(surface.mesh) ==
        Approx(30.11 * 20.17 * 8.13).margin(8 * 0.3 * 0.3 * 0.3 / 6));
}

TEST_CASE("a bar's mesh has its sharp rims", "[unit][stock_mesh]") {
  const model::CylinderStock bar{{0.3, -0.2, 0.1}, 10, 7};
  const StockModel stock(bar, 0.25, kMeshBytes);
  const StockSurface surface = stock.surface({2});
  CHECK(faults(surface.mesh).none());
  CHECK(surface.unmoved == 0);
  std::size_t on_rim = 0;
  for (const Vec3& v : surface.mesh.vertices)
    on_rim += std::abs(v.z - 7.1) < 1e-8 && std::abs(std::hypot(v.x - 0.3, v.y + 0.2) - 5) < 1e-8;
  // One for each cell that the rim of 31 mm passes through and whose corners tell: more than two
  // thirds of 160.
  CHECK(on_rim >= 107);
}

TEST_CASE("cusps between rows are sharp in the mesh", "[property][stock_mesh]") {
  const double voxel = 0.1, r = 3, step = 0.5, depth = 1.3;
  const Pass rows = raster(cutter(CutterType::ball, 2 * r, 20), 4, step, 8,
                           [&](double, double) { return -depth; });
  const StockModel stock = meshed_block(voxel).cut(rows, {2});
  const StockSurface surface = stock.surface({2});
  CHECK(faults(surface.mesh).none());
  const double cusp = r - depth - std::sqrt(r * r - step * step / 4);
  std::size_t on_cusps = 0;
  double highest = -depth, worst = 0;
  for (const Vec3& v : surface.mesh.vertices) {
    if (std::abs(v.x) > 3 || std::abs(v.y) > 3 || v.z > -1 || v.z < -2) continue;
    const double row = std::round((v.y + 4) / step) * step - 4;
    const double height = r - depth - std::sqrt(r * r - (v.y - row) * (v.y - row));
    worst = std::max(worst, std::abs(v.z - height));
    highest = std::max(highest, v.z);
    on_cusps += std::abs(v.z - cusp) < 1e-8;
  }
  CHECK(worst < 1e-8);  // promised: 1e-4
  CHECK(highest == Approx(cusp).margin(1e-8));
  // Twelve cusps of 6 mm, a vertex a cell.
  CHECK(on_cusps >= 12 * 58);
}

TEST_CASE("thin walls and slivers make closed manifolds", "[slow][stock_mesh]") {
  for (const double wall : {0.01, 0.07, 0.13, 0.31}) {
    // Two slots with a wall between them, not along the lattice, and one that just opens into it.
    const auto flat = cutter(CutterType::flat, 4, 20);
    const Vec3 along = normalized(Vec3{1, 0.137, 0}), side{-along.y, along.x, 0};
    const Vec3 a = side * (2 + wall / 2) + Vec3{0, 0, -4};
    const Vec3 b = side * (-2 - wall / 2) + Vec3{0, 0, -4};
    const Pass slots = PathBuilder(a - along * 9)
                           .feed(a + along * 9)
                           .rapid(a + along * 9 + Vec3{0, 0, 20})
                           .rapid(b - along * 9 + Vec3{0, 0, 20})
                           .feed(b - along * 9)
                           .feed(b + along * 9)
                           .pass(flat);
    for (const double voxel : {0.15, 0.2, 0.33}) {
      const StockModel stock = meshed_block(voxel).cut(slots, {2});
      const StockSurface surface = stock.surface({2});
      INFO("wall " << wall << ", voxel " << voxel);
      CHECK(faults(surface.mesh).none());
      // What could not be moved is about the sheet that is thinner than a voxel.
      CHECK(surface.unmoved <= surface.mesh.vertices.size() / 50);
    }
  }
}

TEST_CASE("holes on a checkerboard make closed manifolds", "[slow][stock_mesh]") {
  // Plunges whose circles touch, overlap by little or leave little between them.
  for (const double pitch : {1.98, 2.0, 2.02}) {
    PathBuilder path({0, 0, 5});
    for (int i = -4; i <= 4; ++i)
      for (int j = -4; j <= 4; ++j) {
        const double x = pitch * i, y = pitch * j;
        path.rapid({x, y, 5}).feed({x, y, (i + j) % 2 ? -2.0 : -3.0}).rapid({x, y, 5});
      }
    for (const auto type : {CutterType::flat, CutterType::ball}) {
      const StockModel stock = meshed_block(0.17).cut(path.pass(cutter(type, 2, 20)), {2});
      CHECK(faults(stock.surface({2}).mesh).none());
    }
  }
}

TEST_CASE("random unions of sweeps make closed manifolds", "[slow][stock_mesh]") {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<> x(-16, 16), y(-11, 11), z(-9, 1), voxel(0.15, 0.6);
  const std::vector<model::Cutter> cutters{
      cutter(CutterType::flat, 3, 6), cutter(CutterType::ball, 3, 5),
      cutter(CutterType::bull, 4, 5, 1), cutter(CutterType::taper, 1, 6, 0.5, 15)};
  for (int i = 0; i < 16; ++i) {
    PathBuilder path({x(random), y(random), z(random)});
    for (int k = 0; k < 30; ++k) path.feed({x(random), y(random), z(random)});
    const double v = voxel(random);
    const StockModel stock = meshed_block(v).cut(path.pass(cutters[i % cutters.size()]), {2});
    const StockSurface surface = stock.surface({2});
    INFO("voxel " << v);
    CHECK(faults(surface.mesh).none());
    CHECK(surface.unmoved <= surface.mesh.vertices.size() / 50);
    std::size_t off = 0;
    for (const Vec3& p : surface.mesh.vertices) off += std::abs(stock.exact_value(p)) > 1e-8;
    CHECK(off == surface.unmoved);
  }
}

TEST_CASE("what a cutter made of a block is its mesh less the block's own sides",
          "[unit][stock_mesh]") {
  const StockModel block = meshed_block(0.4);
  const Pass slot =
      PathBuilder({-20, 0, -3}).feed({20, 0, -3}).pass(cutter(CutterType::flat, 6, 20));
  const StockModel stock = block.cut(slot, {2});
  const StockSurface whole = stock.surface({2});
  const simulator::StockMesh cut = stock.cut_part_of(whole.mesh, {2});
  CHECK(stock.cut_part_of(block.surface({2}).mesh).triangles.empty());
  // Floor and two walls of a slot: 6 x 30 and twice 3 x 30 mm.
  double area = 0;
  for (const auto& t : cut.triangles) {
    const Vec3 &a = cut.vertices[t[0]], &b = cut.vertices[t[1]], &c = cut.vertices[t[2]];
    area += length(cross(b - a, c - a)) / 2;
  }
  CHECK(area == Approx(12 * 30).epsilon(0.01));
  for (const Vec3& p : cut.vertices) CHECK((std::abs(p.y) <= 3 + 1e-6 && p.z >= -3 - 1e-6));
  CHECK(cut.vertices.size() < whole.mesh.vertices.size() / 2);
}
