#include "simulator/mesh/surface_net.h"

#include <map>
#include <random>
#include <set>

#include "model/base/error.h"
#include "simulator/mesh/cell_cycles.h"
#include "tests/simulator/mesh/mesh_check.h"
#include "tests/support/catch.h"

namespace {

using namespace limitgauge;
using model::Vec3;
using simulator::CellCycles;
using simulator::Index3;
using simulator::kLeafEdge;
using simulator::kPatchEdge;
using simulator::LeafPatch;

// Any values on a cube of leaves, positive all around.
class Field : public simulator::NetSource {
 public:
  explicit Field(int leaves_an_edge) : n_(leaves_an_edge * kLeafEdge), value_(n_ * n_ * n_, 1.0F) {}

  float& at(int x, int y, int z) { return value_[(x * n_ + y) * n_ + z]; }
  float get(int x, int y, int z) const {
    const bool in = x >= 0 && y >= 0 && z >= 0 && x < n_ && y < n_ && z < n_;
    return in ? value_[(x * n_ + y) * n_ + z] : 1.0F;
  }
  int edge() const { return n_; }

  // Leaves one below the cube, too: cells may begin there.
  std::size_t leaves() const override { return across() * across() * across(); }
  Index3 corner(std::size_t leaf) const override {
    const int n = static_cast<int>(across()), i = static_cast<int>(leaf);
    return {(i / n / n - 1) * kLeafEdge, (i / n % n - 1) * kLeafEdge, (i % n - 1) * kLeafEdge};
  }
  void values(std::size_t leaf, LeafPatch& patch) const override {
    const Index3 c = corner(leaf);
    std::size_t i = 0;
    for (int x = 0; x < kPatchEdge; ++x)
      for (int y = 0; y < kPatchEdge; ++y)
        for (int z = 0; z < kPatchEdge; ++z) patch[i++] = get(c[0] + x, c[1] + y, c[2] + z);
  }

 private:
  std::size_t across() const { return static_cast<std::size_t>(n_ / kLeafEdge + 1); }
  int n_;
  std::vector<float> value_;
};

class Middles : public simulator::NetPlacer {
 public:
  Vec3 place(const Index3&, std::span<const Vec3> crossings) override {
    Vec3 sum;
    for (const Vec3& p : crossings) sum += p;
    return sum / static_cast<double>(crossings.size());
  }
};

model::TriangleMesh net(const Field& field, unsigned threads = 2) {
  return simulator::surface_net(field, {{0, 0, 0}, 1}, [] { return std::make_unique<Middles>(); },
                                {threads});
}

template <class Value>
void fill(Field& field, Value value) {
  for (int x = 0; x < field.edge(); ++x)
    for (int y = 0; y < field.edge(); ++y)
      for (int z = 0; z < field.edge(); ++z) field.at(x, y, z) = value(x, y, z);
}

}  // namespace

TEST_CASE("every crossed edge of a cell is in one cycle of three edges or more",
          "[unit][surface_net]") {
  for (unsigned signs = 0; signs < 256; ++signs) {
    const CellCycles& cell = simulator::cell_cycles()[signs];
    std::map<int, int> edges;
    for (int axis = 0; axis < 3; ++axis)
      for (int u = 0; u < 2; ++u)
        for (int v = 0; v < 2; ++v) {
          Index3 low{};
          low[axis == 0 ? 1 : 0] = u, low[axis == 2 ? 1 : 2] = v;
          Index3 high = low;
          high[axis] = 1;
          const auto stands = [&](const Index3& c) {
            return signs >> (4 * c[0] + 2 * c[1] + c[2]) & 1;
          };
          const auto cycle = cell.of_edge[simulator::cell_edge(axis, u, v)];
          CHECK((cycle != CellCycles::kNone) == (stands(low) != stands(high)));
          if (cycle != CellCycles::kNone) ++edges[cycle];
        }
    CHECK(edges.size() == cell.count);
    CHECK(cell.count <= 4);
    for (const auto& [cycle, count] : edges) CHECK(count >= 3);
  }
}

TEST_CASE("the net of any signs whatever is closed and manifold", "[property][surface_net]") {
  std::mt19937_64 random(17);
  bool met_doubled = false;
  for (const double share : {0.02, 0.2, 0.5, 0.8, 0.98}) {
    Field field(4);
    std::bernoulli_distribution stands(share);
    fill(field, [&](int, int, int) { return stands(random) ? -0.3F : 0.7F; });
    const auto mesh = net(field);
    CHECK(mesh.triangles.size() > 1000);
    CHECK(simulator::test::faults(mesh).none());
    const auto size = simulator::surface_net_size(field, {2});
    met_doubled = met_doubled || mesh.vertices.size() > size.vertices;
  }
  // So that the rare case is known to have been among them.
  CHECK(met_doubled);
}

TEST_CASE("checkerboards make a closed manifold", "[property][surface_net]") {
  // Voxels that touch in edges alone, in corners alone, and columns and layers of them.
  const std::array<int (*)(int, int, int), 5> boards{
      [](int x, int y, int z) { return (x + y + z) % 2; },
      [](int x, int y, int) { return (x + y) % 2; },
      [](int x, int y, int z) { return (x / 2 + y / 2 + z / 2) % 2; },
      [](int x, int y, int z) { return (x % 2) * (y % 2) * (z % 2); },
      [](int x, int y, int z) { return (x + y) % 2 + (y + z) % 2 == 1 ? 1 : 0; }};
  for (const auto board : boards) {
    Field field(2);
    fill(field, [&](int x, int y, int z) { return board(x, y, z) ? -1.0F : 1.0F; });
    CHECK(simulator::test::faults(net(field)).none());
  }
}

TEST_CASE("a ball's net holds the ball's volume", "[property][surface_net]") {
  Field field(4);
  const double r = 12.3;
  fill(field, [&](int x, int y, int z) {
    return static_cast<float>(length(Vec3{1.0 * x, 1.0 * y, 1.0 * z} - Vec3{16, 15.7, 16.2}) - r);
  });
  const auto mesh = net(field);
  CHECK(simulator::test::faults(mesh).none());
  // A vertex in the middle of its crossings is inside by no more than a voxel's square over 8 r,
  // the facets by as much again: 2 % of the volume at the most.
  CHECK(simulator::test::enclosed_volume(mesh) == Approx(4.18879 * r * r * r).epsilon(0.02));
}

TEST_CASE("a net is the same for any number of threads", "[property][surface_net]") {
  std::mt19937_64 random(4);
  Field field(3);
  std::normal_distribution<float> value;
  fill(field, [&](int, int, int) { return value(random); });
  const auto one = net(field, 1), three = net(field, 3);
  CHECK(one.vertices == three.vertices);
  CHECK(one.triangles == three.triangles);
}
