#include "simulator/mesh/net_cells.h"

#include <limits>
#include <stdexcept>

#include "model/base/chunks.h"

namespace limitgauge::simulator {
namespace {

constexpr std::size_t kChunk = 64;

// Which voxels of a vertical of a patch stand in the material, from below.
using Columns = std::array<std::array<unsigned, kPatchEdge>, kPatchEdge>;
constexpr unsigned kAllStand = (1U << kPatchEdge) - 1;

Columns columns_of(const LeafPatch& patch) {
  Columns columns{};
  for (int x = 0; x < kPatchEdge; ++x)
    for (int y = 0; y < kPatchEdge; ++y)
      for (int z = 0; z < kPatchEdge; ++z)
        columns[x][y] |= static_cast<unsigned>(patch[patch_place(x, y, z)] < 0) << z;
  return columns;
}

void add_cell(NetLeaf& leaf, int at, unsigned signs) {
  const unsigned low = signs & 1;
  leaf.signs[at] = static_cast<std::uint8_t>(signs);
  leaf.vertices += cell_cycles()[signs].count;
  leaf.crossed += ((signs >> 4 & 1) != low) + ((signs >> 2 & 1) != low) + ((signs >> 1 & 1) != low);
}

}  // namespace

NetLeaf net_leaf(const LeafPatch& patch) {
  const Columns columns = columns_of(patch);
  NetLeaf leaf;
  for (int x = 0; x < kLeafEdge; ++x)
    for (int y = 0; y < kLeafEdge; ++y) {
      const unsigned a = columns[x][y], b = columns[x][y + 1];
      const unsigned c = columns[x + 1][y], d = columns[x + 1][y + 1];
      leaf.row_vertex[leaf_place(x, y, 0) / kLeafEdge] = static_cast<std::uint16_t>(leaf.vertices);
      if ((a | b | c | d) == 0 || (a & b & c & d) == kAllStand) continue;
      for (int z = 0; z < kLeafEdge; ++z)
        add_cell(leaf, leaf_place(x, y, z),
                 (a >> z & 3) | (b >> z & 3) << 2 | (c >> z & 3) << 4 | (d >> z & 3) << 6);
    }
  return leaf;
}

std::uint32_t NetLeaf::vertex(int at) const {
  std::uint32_t vertex = first_vertex + row_vertex[at / kLeafEdge];
  const auto& cycles = cell_cycles();
  for (int before = at - at % kLeafEdge; before < at; ++before)
    vertex += cycles[signs[before]].count;
  return vertex;
}

std::size_t NetCells::Hash::operator()(const Index3& i) const {
  std::uint64_t h = 0;
  for (const int v : i) h = (h ^ static_cast<std::uint32_t>(v)) * 0x9e3779b97f4a7c15U;
  return static_cast<std::size_t>(h ^ h >> 29);
}

NetCells::NetCells(const NetSource& source, const model::RunControl& control)
    : leaves_(source.leaves()) {
  model::parallel_chunks(leaves_.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    LeafPatch patch;
    for (std::size_t i = begin; i < end; ++i) {
      source.values(i, patch);
      const NetLeaf leaf = net_leaf(patch);
      if (leaf.vertices > 0) leaves_[i] = std::make_unique<NetLeaf>(leaf);
    }
  });
  std::uint64_t vertices = 0;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    if (!leaves_[i]) continue;
    leaves_[i]->first_vertex = static_cast<std::uint32_t>(vertices);
    vertices += leaves_[i]->vertices;
    crossed_ += leaves_[i]->crossed;
    at_.emplace(source.corner(i), leaves_[i].get());
  }
  if (vertices > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("a surface of more than 2^32 vertices");
  vertices_ = static_cast<std::uint32_t>(vertices);
}

const NetLeaf* NetCells::leaf_at(const Index3& corner) const {
  const auto found = at_.find(corner);
  return found == at_.end() ? nullptr : found->second;
}

NetCells::Around::Around(const NetCells& cells, const Index3& corner) : corner_(corner) {
  for (int k = 0; k < 8; ++k) {
    const auto down = [&](int axis, int bit) {
      return corner[axis] - ((k >> bit & 1) != 0 ? kLeafEdge : 0);
    };
    leaves_[k] = cells.leaf_at({down(0, 2), down(1, 1), down(2, 0)});
  }
}

NetCells::Cell NetCells::Around::cell(const Index3& at) const {
  unsigned which = 0;
  for (int a = 0; a < 3; ++a) which = which << 1 | static_cast<unsigned>(at[a] < corner_[a]);
  const NetLeaf* leaf = leaves_[which];
  if (!leaf) throw std::logic_error("a surface cell outside the leaves");
  const auto in_leaf = [](int v) { return v & (kLeafEdge - 1); };
  const int place = leaf_place(in_leaf(at[0]), in_leaf(at[1]), in_leaf(at[2]));
  return {leaf->signs[place], leaf->vertex(place)};
}

}  // namespace limitgauge::simulator
