#include "simulator/net_cells.h"

#include <limits>
#include <stdexcept>

#include "engine/model/chunks.h"

namespace limitgauge::simulator {
namespace {

constexpr std::size_t kChunk = 64;

std::unique_ptr<NetLeaf> leaf_of(const LeafPatch& patch) {
  NetLeaf leaf;
  for (int x = 0; x < kLeafEdge; ++x)
    for (int y = 0; y < kLeafEdge; ++y)
      for (int z = 0; z < kLeafEdge; ++z) {
        const unsigned signs = cell_signs(patch, x, y, z);
        const int at = leaf_place(x, y, z);
        leaf.signs[at] = static_cast<std::uint8_t>(signs);
        leaf.vertex[at] = static_cast<std::uint16_t>(leaf.vertices);
        leaf.vertices += cell_cycles()[signs].count;
      }
  return leaf.vertices > 0 ? std::make_unique<NetLeaf>(leaf) : nullptr;
}

}  // namespace

unsigned cell_signs(const LeafPatch& patch, int x, int y, int z) {
  unsigned signs = 0;
  for (int k = 0; k < 8; ++k)
    if (patch[patch_place(x + (k >> 2 & 1), y + (k >> 1 & 1), z + (k & 1))] < 0) signs |= 1U << k;
  return signs;
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
      leaves_[i] = leaf_of(patch);
    }
  });
  std::uint64_t vertices = 0;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    if (!leaves_[i]) continue;
    leaves_[i]->first_vertex = static_cast<std::uint32_t>(vertices);
    vertices += leaves_[i]->vertices;
    at_.emplace(source.corner(i), leaves_[i].get());
  }
  if (vertices > std::numeric_limits<std::uint32_t>::max())
    throw std::length_error("a surface of more than 2^32 vertices");
  vertices_ = static_cast<std::uint32_t>(vertices);
}

NetCells::Cell NetCells::cell(const Index3& at) const {
  const auto in_leaf = [](int v) { return v & (kLeafEdge - 1); };
  const int x = in_leaf(at[0]), y = in_leaf(at[1]), z = in_leaf(at[2]);
  const auto found = at_.find({at[0] - x, at[1] - y, at[2] - z});
  if (found == at_.end()) throw std::logic_error("a surface cell outside the leaves");
  const NetLeaf& leaf = *found->second;
  const int place = leaf_place(x, y, z);
  return {leaf.signs[place], leaf.first_vertex + leaf.vertex[place]};
}

}  // namespace limitgauge::simulator
