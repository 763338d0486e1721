#include "simulator/mesh/surface_net.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <map>
#include <tuple>

#include "model/base/chunks.h"
#include "model/base/memory.h"
#include "simulator/mesh/net_cells.h"

namespace limitgauge::simulator {
namespace {

using model::TriangleMesh;
using model::Vec3;

constexpr std::size_t kChunk = 64;
constexpr std::size_t kBatch = 8192;  // leaves whose triangles are held twice for a moment

Index3 moved(Index3 at, int axis, int by) {
  at[axis] += by;
  return at;
}

Index3 leaf_corner(Index3 at) {
  for (int& i : at) i &= ~(kLeafEdge - 1);
  return at;
}

// A lattice edge that the surface crosses, from `low` one step along `axis`.
struct CrossedEdge {
  Index3 low{};
  int axis = 0;
  bool low_stands = false;
};

// The four cells about a lattice edge, around it in the turn of its axis, and the net's vertices
// there. Face k lies between cell k and the next one.
struct Ring {
  struct Face {
    int axis = 0;     // across the face
    Index3 corner{};  // its lowest one
  };
  std::array<std::uint32_t, 4> vertex{};
  std::array<Face, 4> face{};
  std::array<bool, 4> doubled{};  // two segments of the face join the same two vertices
  bool any_doubled() const { return doubled[0] || doubled[1] || doubled[2] || doubled[3]; }
};

Ring ring_about(const NetCells::Around& cells, const CrossedEdge& e) {
  const int u = (e.axis + 1) % 3, v = (e.axis + 2) % 3;
  // Steps to the cells, anticlockwise seen against the axis.
  constexpr int kSteps[4][2] = {{0, 0}, {-1, 0}, {-1, -1}, {0, -1}};
  std::array<NetCells::Cell, 4> cell;
  Ring ring;
  for (int k = 0; k < 4; ++k) {
    cell[k] = cells.cell(moved(moved(e.low, u, kSteps[k][0]), v, kSteps[k][1]));
    Index3 place{};
    place[u] = -kSteps[k][0], place[v] = -kSteps[k][1];
    ring.vertex[k] = cell[k].vertex(
        cell_edge(e.axis, place[other_axis(e.axis, 0)], place[other_axis(e.axis, 1)]));
  }
  // The face between cell k and the next one: the cells above and below it, and where it begins.
  constexpr int kUpper[4] = {0, 1, 3, 0}, kLower[4] = {1, 2, 2, 3};
  for (int k = 0; k < 4; ++k) {
    const int across = k % 2 == 0 ? u : v;
    ring.doubled[k] = (cell[kUpper[k]].cycles().twice >> (2 * across) & 1) != 0 &&
                      (cell[kLower[k]].cycles().twice >> (2 * across + 1) & 1) != 0;
    Index3 corner = e.low;
    if (k == 1) corner[u] -= 1;
    if (k == 2) corner[v] -= 1;
    ring.face[k] = {across, corner};
  }
  return ring;
}

template <class Visit>
void each_crossed_edge(const NetLeaf& leaf, const Index3& corner, Visit visit) {
  constexpr int kFar[3] = {4, 2, 1};  // the corner of a cell one step from its lowest
  for (int x = 0; x < kLeafEdge; ++x)
    for (int y = 0; y < kLeafEdge; ++y)
      for (int z = 0; z < kLeafEdge; ++z) {
        const unsigned signs = leaf.signs[leaf_place(x, y, z)];
        if (signs == 0 || signs == 255) continue;
        const bool low = signs & 1;
        for (int axis = 0; axis < 3; ++axis)
          if ((signs >> kFar[axis] & 1) != low)
            visit(CrossedEdge{{corner[0] + x, corner[1] + y, corner[2] + z}, axis, low});
      }
}

// Where the surface crosses the edges of a cell, for each of its cycles.
void place_cell(const NetCells::Cell& cell, const LeafPatch& patch, const Index3& in_leaf,
                const Index3& corner, const Lattice& lattice, NetPlacer& placer,
                std::vector<Vec3>& vertices) {
  const CellCycles& cycles = cell.cycles();
  std::array<std::array<Vec3, 12>, 4> crossings;
  std::array<std::size_t, 4> count{};
  for (int axis = 0; axis < 3; ++axis)
    for (int u = 0; u < 2; ++u)
      for (int v = 0; v < 2; ++v) {
        const std::uint8_t cycle = cycles.of_edge[cell_edge(axis, u, v)];
        if (cycle == CellCycles::kNone) continue;
        Index3 low = in_leaf;
        low[other_axis(axis, 0)] += u, low[other_axis(axis, 1)] += v;
        const Index3 high = moved(low, axis, 1);
        const double a = patch[patch_place(low[0], low[1], low[2])];
        const double b = patch[patch_place(high[0], high[1], high[2])];
        const Index3 from{corner[0] + low[0], corner[1] + low[1], corner[2] + low[2]};
        Vec3 p = lattice.point(from);
        p[axis] += lattice.voxel_mm * std::clamp(a / (a - b), 0.0, 1.0);
        crossings[cycle][count[cycle]++] = p;
      }
  const Index3 at{corner[0] + in_leaf[0], corner[1] + in_leaf[1], corner[2] + in_leaf[2]};
  for (std::uint8_t c = 0; c < cycles.count; ++c)
    vertices[cell.first_vertex + c] = placer.place(at, {crossings[c].data(), count[c]});
}

// Of a leaf, cube by cube of four and of two cells: the n-th.
constexpr Index3 cell_in_cubes(int n) {
  const auto bits = [n](int low) {
    return (n >> (low + 6) & 1) << 2 | (n >> (low + 3) & 1) << 1 | (n >> low & 1);
  };
  return {bits(2), bits(1), bits(0)};
}

// All of them: leaf by leaf they are gone through for the few that the surface passes through.
constexpr std::array<Index3, kLeafCells> cells_in_cubes() {
  std::array<Index3, kLeafCells> cells{};
  for (int n = 0; n < kLeafCells; ++n) cells[static_cast<std::size_t>(n)] = cell_in_cubes(n);
  return cells;
}
constexpr std::array<Index3, kLeafCells> kCellsInCubes = cells_in_cubes();

void place_leaf(const NetLeaf& leaf, const LeafPatch& patch, const Index3& corner,
                const Lattice& lattice, NetPlacer& placer, std::vector<Vec3>& vertices) {
  for (const Index3& c : kCellsInCubes) {
    const int at = leaf_place(c[0], c[1], c[2]);
    if (leaf.signs[at] == 0 || leaf.signs[at] == 255) continue;
    const NetCells::Cell cell{leaf.signs[at], leaf.vertex(at)};
    place_cell(cell, patch, c, corner, lattice, placer, vertices);
  }
}

using Triangle = std::array<std::uint32_t, 3>;

void add_quad(const Ring& ring, bool low_stands, const std::vector<Vec3>& vertices,
              std::vector<Triangle>& triangles) {
  auto q = ring.vertex;
  if (!low_stands) std::swap(q[1], q[3]);
  const auto diagonal = [&](int a, int b) {
    return length_squared(vertices[q[a]] - vertices[q[b]]);
  };
  // The shorter diagonal makes the better triangles.
  if (diagonal(0, 2) <= diagonal(1, 3)) {
    triangles.push_back({q[0], q[1], q[2]});
    triangles.push_back({q[0], q[2], q[3]});
  } else {
    triangles.push_back({q[1], q[2], q[3]});
    triangles.push_back({q[1], q[3], q[0]});
  }
}

// Quads with an edge that joins the same vertices as another.
class DoubledQuads {
 public:
  explicit DoubledQuads(TriangleMesh& mesh) : mesh_(mesh) {}

  void add(const CrossedEdge& e, const Ring& ring) {
    std::vector<std::uint32_t> rim;
    for (int k = 0; k < 4; ++k) {
      rim.push_back(ring.vertex[k]);
      if (ring.doubled[k])
        rim.push_back(middle(e, ring.face[k], ring.vertex[k], ring.vertex[(k + 1) % 4]));
    }
    if (!e.low_stands) std::reverse(rim.begin(), rim.end());
    Vec3 sum;
    for (const std::uint32_t v : rim) sum += mesh_.vertices[v];
    const auto centre = static_cast<std::uint32_t>(mesh_.vertices.size());
    mesh_.vertices.push_back(sum / static_cast<double>(rim.size()));
    for (std::size_t k = 0; k < rim.size(); ++k)
      mesh_.triangles.push_back({centre, rim[k], rim[(k + 1) % rim.size()]});
  }

 private:
  // A segment is known by its face and the standing corner that it cuts off.
  std::uint32_t middle(const CrossedEdge& e, const Ring::Face& face, std::uint32_t a,
                       std::uint32_t b) {
    const Index3 standing = e.low_stands ? e.low : moved(e.low, e.axis, 1);
    const auto [at, added] = middles_.try_emplace(
        {face.axis, face.corner, standing}, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (added) mesh_.vertices.push_back((mesh_.vertices[a] + mesh_.vertices[b]) * 0.5);
    return at->second;
  }

  TriangleMesh& mesh_;
  std::map<std::tuple<int, Index3, Index3>, std::uint32_t> middles_;
};

struct LeafQuads {
  std::vector<Triangle> triangles;
  std::vector<CrossedEdge> doubled;
};

LeafQuads quads_of(const NetCells& cells, const NetLeaf& leaf, const Index3& corner,
                   const std::vector<Vec3>& vertices) {
  LeafQuads quads;
  quads.triangles.reserve(2 * leaf.crossed);
  const NetCells::Around around(cells, corner);
  each_crossed_edge(leaf, corner, [&](const CrossedEdge& e) {
    const Ring ring = ring_about(around, e);
    if (ring.any_doubled()) return quads.doubled.push_back(e);
    add_quad(ring, e.low_stands, vertices, quads.triangles);
  });
  return quads;
}

void add_triangles(const NetSource& source, const NetCells& cells, TriangleMesh& mesh,
                   const model::RunControl& control) {
  std::vector<CrossedEdge> doubled;
  for (std::size_t first = 0; first < source.leaves(); first += kBatch) {
    const std::size_t count = std::min(kBatch, source.leaves() - first);
    std::vector<LeafQuads> batch(count);
    model::parallel_chunks(count, kChunk, control, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        if (const NetLeaf* leaf = cells.leaf(first + i))
          batch[i] = quads_of(cells, *leaf, source.corner(first + i), mesh.vertices);
    });
    for (const LeafQuads& quads : batch) {
      mesh.triangles.insert(mesh.triangles.end(), quads.triangles.begin(), quads.triangles.end());
      doubled.insert(doubled.end(), quads.doubled.begin(), quads.doubled.end());
    }
  }
  DoubledQuads quads(mesh);
  for (const CrossedEdge& e : doubled)
    quads.add(e, ring_about(NetCells::Around(cells, leaf_corner(e.low)), e));
}

TriangleMesh net_of(const NetCells& cells, const NetSource& source, const Lattice& lattice,
                    const MakePlacer& placers, const model::RunControl& control) {
  TriangleMesh mesh;
  model::reserve_large(mesh.vertices, cells.vertices());
  mesh.vertices.resize(cells.vertices());
  std::atomic<std::size_t> done = 0;
  const std::size_t chunks = model::chunk_count(source.leaves(), kChunk);
  model::parallel_chunks(source.leaves(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    LeafPatch patch;
    const auto placer = placers();
    for (std::size_t i = begin; i < end; ++i) {
      if (!cells.leaf(i)) continue;
      source.values(i, patch);
      place_leaf(*cells.leaf(i), patch, source.corner(i), lattice, *placer, mesh.vertices);
    }
    control.report(static_cast<double>(++done) / static_cast<double>(chunks));
  });
  model::reserve_large(mesh.triangles, 2 * cells.crossed_edges());
  add_triangles(source, cells, mesh, control);
  return mesh;
}

double bytes_of_leaves(std::size_t leaves) {
  constexpr double kLeafOverhead = 64;  // its place in the table
  return static_cast<double>(leaves) * (sizeof(NetLeaf) + kLeafOverhead);
}

}  // namespace

double NetSize::bytes() const {
  return static_cast<double>(vertices) * sizeof(Vec3) +
         static_cast<double>(triangles) * sizeof(Triangle) + bytes_of_leaves(leaves);
}

NetSize surface_net_size(const NetSource& source, const model::RunControl& control) {
  std::atomic<std::size_t> vertices = 0, edges = 0, leaves = 0;
  model::parallel_chunks(source.leaves(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    LeafPatch patch;
    for (std::size_t i = begin; i < end; ++i) {
      source.values(i, patch);
      const NetLeaf leaf = net_leaf(patch);
      vertices += leaf.vertices, edges += leaf.crossed, leaves += leaf.vertices > 0;
    }
  });
  return {vertices, 2 * edges, leaves};
}

TriangleMesh surface_net(const NetSource& source, const Lattice& lattice, const MakePlacer& placers,
                         const model::RunControl& control) {
  return net_of(NetCells(source, control), source, lattice, placers, control);
}

std::variant<TriangleMesh, NetSize> surface_net_within(double most_bytes, const NetSource& source,
                                                       const Lattice& lattice,
                                                       const MakePlacer& placers,
                                                       const model::RunControl& control) {
  // Where the cells might be too much already they are counted before they are held.
  if (bytes_of_leaves(source.leaves()) > most_bytes) {
    const NetSize size = surface_net_size(source, control);
    if (size.bytes() > most_bytes) return size;
  }
  const NetCells cells(source, control);
  const NetSize size{cells.vertices(), 2 * cells.crossed_edges(), cells.leaves()};
  if (size.bytes() > most_bytes) return size;
  return net_of(cells, source, lattice, placers, control);
}

}  // namespace limitgauge::simulator
