#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "model/base/run_control.h"
#include "simulator/mesh/cell_cycles.h"
#include "simulator/mesh/net_source.h"

namespace limitgauge::simulator {

inline constexpr int kLeafCells = kLeafEdge * kLeafEdge * kLeafEdge;

/// The cells of one leaf that the surface passes through.
struct NetLeaf {
  std::array<std::uint8_t, kLeafCells> signs{};
  /// First vertex of each row of cells along z, from the leaf's first: those of its cells follow
  /// from the signs, and tens of thousands of leaves are held.
  std::array<std::uint16_t, kLeafCells / kLeafEdge> row_vertex{};
  std::uint32_t first_vertex = 0;
  std::uint32_t vertices = 0;
  std::uint32_t crossed = 0;  ///< lattice edges upwards from the cells' lowest corners

  /// First one of the cell at a leaf_place.
  std::uint32_t vertex(int at) const;
};

/// The cells of a leaf, its first vertex being 0.
NetLeaf net_leaf(const LeafPatch& patch);

/// All cells that the surface passes through, with the numbers of their vertices.
class NetCells {
 public:
  NetCells(const NetSource& source, const model::RunControl& control);

  struct Cell {
    unsigned signs = 0;
    std::uint32_t first_vertex = 0;
    const CellCycles& cycles() const { return cell_cycles()[signs]; }
    std::uint32_t vertex(int edge) const { return first_vertex + cycles().of_edge[edge]; }
  };
  /// The cells of the leaf at `corner` and of those below it along any axis.
  class Around {
   public:
    Around(const NetCells& cells, const Index3& corner);
    /// The cell whose lowest corner is `at`. Throws std::logic_error where the source left it out.
    Cell cell(const Index3& at) const;

   private:
    Index3 corner_;
    std::array<const NetLeaf*, 8> leaves_{};
  };
  std::uint32_t vertices() const { return vertices_; }
  std::size_t crossed_edges() const { return crossed_; }
  /// That the surface passes through.
  std::size_t leaves() const { return at_.size(); }
  /// Null where the surface does not pass through the leaf.
  const NetLeaf* leaf(std::size_t i) const { return leaves_[i].get(); }

 private:
  struct Hash {
    std::size_t operator()(const Index3& i) const;
  };
  const NetLeaf* leaf_at(const Index3& corner) const;

  std::vector<std::unique_ptr<NetLeaf>> leaves_;
  std::unordered_map<Index3, const NetLeaf*, Hash> at_;
  std::uint32_t vertices_ = 0;
  std::size_t crossed_ = 0;
};

/// Place of a voxel in a leaf's arrays.
constexpr int leaf_place(int x, int y, int z) {
  return (x * kLeafEdge + y) * kLeafEdge + z;
}
constexpr int patch_place(int x, int y, int z) {
  return (x * kPatchEdge + y) * kPatchEdge + z;
}

}  // namespace limitgauge::simulator
