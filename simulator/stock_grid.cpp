#include "simulator/stock_grid.h"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <utility>

#include "engine/model/error.h"
#include "simulator/block_cut.h"
#include "simulator/memory_forecast.h"
#include "simulator/raw_stock.h"
#include "simulator/tetra_volume.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;
using openvdb::Coord;
using Tree = openvdb::FloatTree;
using Leaf = Tree::LeafNodeType;
using Accessor = openvdb::FloatGrid::ConstAccessor;

static_assert(Leaf::DIM == kLeafEdge);

void start_openvdb() {
  static const bool started = (openvdb::initialize(), true);
  static_cast<void>(started);
}

Coord coord(const Index3& i) {
  return {i[0], i[1], i[2]};
}
Index3 index3(const Coord& c) {
  return {c[0], c[1], c[2]};
}

openvdb::FloatGrid::Ptr empty_grid(const Lattice& lattice) {
  auto grid = openvdb::FloatGrid::create(static_cast<float>(kBandVoxels * lattice.voxel_mm));
  auto transform = openvdb::math::Transform::createLinearTransform(lattice.voxel_mm);
  transform->postTranslate({lattice.origin_mm.x, lattice.origin_mm.y, lattice.origin_mm.z});
  grid->setTransform(transform);
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  grid->setName("stock");
  return grid;
}

// Corners of the blocks that the stock with its band lies in, in a fixed order.
std::vector<Index3> blocks_of(const model::Stock& raw, const Lattice& lattice, double band) {
  const model::Box3 box = bounding_box(raw).grown(band + lattice.voxel_mm);
  Index3 low, high;
  for (int a = 0; a < 3; ++a) {
    const double scale = lattice.voxel_mm * kBlockEdge;
    low[a] = static_cast<int>(std::floor((box.low[a] - lattice.origin_mm[a]) / scale));
    high[a] = static_cast<int>(std::floor((box.high[a] - lattice.origin_mm[a]) / scale));
  }
  std::vector<Index3> blocks;
  for (int x = low[0]; x <= high[0]; ++x)
    for (int y = low[1]; y <= high[1]; ++y)
      for (int z = low[2]; z <= high[2]; ++z)
        blocks.push_back({x * kBlockEdge, y * kBlockEdge, z * kBlockEdge});
  return blocks;
}

template <class Visit>
void each_leaf_corner(const Index3& corner, int edge, Visit visit) {
  for (int x = 0; x < edge; x += kLeafEdge)
    for (int y = 0; y < edge; y += kLeafEdge)
      for (int z = 0; z < edge; z += kLeafEdge)
        visit(Index3{corner[0] + x, corner[1] + y, corner[2] + z});
}

// Values at or beyond the band are inactive, as OpenVDB's level set tools want them.
void set_value(Leaf& leaf, int offset, float value, float band) {
  leaf.setValueOnly(offset, value);
  leaf.setActiveState(offset, std::abs(value) < band);
}

class RawBuilder {
 public:
  RawBuilder(Tree& tree, const model::Stock& raw, const Lattice& lattice)
      : tree_(tree), raw_(raw), lattice_(lattice), band_(tree.background()) {}

  void add_block(const Index3& corner) {
    if (depth(corner, kBlockEdge) > 0) return;
    each_leaf_corner(corner, kBlockEdge, [&](const Index3& c) { add_leaf(c); });
  }

 private:
  // +1: wholly outside with its band; −1: wholly inside; 0: neither.
  int depth(const Index3& corner, int edge) const {
    const double d = raw_distance(raw_, lattice_.middle(corner, edge)).distance;
    const double reach = lattice_.half_diagonal(edge) + band_;
    return d > reach ? 1 : d < -reach ? -1 : 0;
  }

  void add_leaf(const Index3& corner) {
    const int where = depth(corner, kLeafEdge);
    if (where > 0) return;
    if (where < 0) return tree_.addTile(1, coord(corner), -band_, false);
    auto leaf = std::make_unique<Leaf>(coord(corner), band_, false);
    float least = band_, most = -band_;
    for (int n = 0; n < static_cast<int>(Leaf::SIZE); ++n) {
      const Index3 at = index3(leaf->offsetToGlobalCoord(n));
      const auto d = static_cast<float>(raw_distance(raw_, lattice_.point(at)).distance);
      const float v = std::clamp(d, -band_, band_);
      set_value(*leaf, n, v, band_);
      least = std::min(least, v), most = std::max(most, v);
    }
    if (least == band_) return;
    if (most == -band_) return tree_.addTile(1, coord(corner), -band_, false);
    tree_.addLeaf(leaf.release());
  }

  Tree& tree_;
  const model::Stock& raw_;
  const Lattice& lattice_;
  float band_;
};

// What a pass changes in one block, worked out beside the old tree and put in its place later.
class BlockChanges : public LeafSink {
 public:
  explicit BlockChanges(const Tree& old) : old_(&old) {}

  bool wanted(const Index3& corner) const override { return stands(corner); }
  void removed(const Index3& corner, int edge) override {
    each_leaf_corner(corner, edge, [&](const Index3& c) {
      if (stands(c)) gone_.push_back(coord(c));
    });
  }
  void reached(const Index3& corner, const LeafDistances& distances) override {
    const Coord at = coord(corner);
    const float band = old_->background();
    const Leaf* old = old_->probeConstLeaf(at);
    auto leaf =
        old ? std::make_unique<Leaf>(*old) : std::make_unique<Leaf>(at, old_->getValue(at), false);
    bool changed = false;
    float least = band;
    for (int n = 0; n < static_cast<int>(Leaf::SIZE); ++n) {
      const float before = leaf->getValue(n), after = std::max(before, -distances[n]);
      if (after > before) changed = true, set_value(*leaf, n, after, band);
      least = std::min(least, after);
    }
    if (changed && least == band) gone_.push_back(at);
    if (changed && least < band) leaves_.push_back(std::move(leaf));
  }

  void put_into(Tree& tree) {
    for (const Coord& c : gone_) tree.addTile(1, c, tree.background(), false);
    for (auto& leaf : leaves_) tree.addLeaf(leaf.release());
    leaves_.clear();
  }

 private:
  bool stands(const Index3& corner) const {
    const Coord c = coord(corner);
    return old_->probeConstLeaf(c) != nullptr || old_->getValue(c) < 0;
  }

  const Tree* old_;
  std::vector<std::unique_ptr<Leaf>> leaves_;
  std::vector<Coord> gone_;
};

// Area of the surface that the pass leaves, from how many blocks lie about it.
double area_about(std::size_t blocks, const Lattice& lattice) {
  const double edge = kBlockEdge * lattice.voxel_mm;
  const double reach = lattice.half_diagonal(kBlockEdge) + kBandVoxels * lattice.voxel_mm;
  return static_cast<double>(blocks) * edge * edge * edge / (2 * reach);
}

double inside_share(Accessor& tree, const Coord& c) {
  std::array<double, 8> f;
  bool inside = false, outside = false;
  for (int k = 0; k < 8; ++k) {
    f[k] = tree.getValue(c.offsetBy(k >> 2 & 1, k >> 1 & 1, k & 1));
    (f[k] < 0 ? inside : outside) = true;
  }
  if (inside && outside) return negative_share(f);
  return inside ? 1.0 : 0.0;
}

// Cells whose lowest corner is in the leaf, in voxels.
double leaf_volume(const Leaf& leaf, Accessor& tree, double voxel) {
  const double diagonal = std::sqrt(3.0) * voxel;
  double sum = 0;
  for (int n = 0; n < static_cast<int>(Leaf::SIZE); ++n) {
    const double v = leaf.getValue(n);
    if (v > diagonal) continue;
    sum += v < -diagonal ? 1.0 : inside_share(tree, leaf.offsetToGlobalCoord(n));
  }
  return sum;
}

bool on_surface(Accessor& tree, const Coord& c) {
  constexpr int kSteps[6][3] = {{-1, 0, 0}, {1, 0, 0},  {0, -1, 0},
                                {0, 1, 0},  {0, 0, -1}, {0, 0, 1}};
  return std::any_of(std::begin(kSteps), std::end(kSteps), [&](const int(&s)[3]) {
    return tree.getValue(c.offsetBy(s[0], s[1], s[2])) >= 0;
  });
}

// OpenVDB puts a random identifier of 36 characters behind the magic number, three version words
// and a flag; the same stock is to give the same bytes.
void fix_identifier(const std::filesystem::path& file) {
  constexpr std::streamoff kIdentifierOffset = 8 + 3 * 4 + 1;
  std::fstream f(file, std::ios::in | std::ios::out | std::ios::binary);
  f.seekp(kIdentifierOffset);
  f << "00000000-0000-0000-0000-000000000000";
  f.close();
  if (!f) throw model::ResourceError(file.string() + ": cannot be written");
}

}  // namespace

struct StockGrid::Impl {
  openvdb::FloatGrid::ConstPtr grid;
  Lattice lattice;
};

StockGrid::StockGrid(const model::Stock& raw, const Lattice& lattice,
                     std::size_t memory_limit_bytes) {
  require_memory(band_bytes(surface_area_mm2(raw), lattice.voxel_mm), memory_limit_bytes,
                 lattice.voxel_mm);
  start_openvdb();
  auto grid = empty_grid(lattice);
  RawBuilder builder(grid->tree(), raw, lattice);
  for (const Index3& corner : blocks_of(raw, lattice, grid->background()))
    builder.add_block(corner);
  impl_ = std::make_shared<const Impl>(Impl{grid, lattice});
}

StockGrid StockGrid::cut(const model::Stock& raw, const SweepIndex& pass,
                         std::size_t memory_limit_bytes, const model::RunControl& control) const {
  using Reach = BlockCutter::Reach;
  const Lattice& lattice = impl_->lattice;
  const Tree& old = impl_->grid->tree();
  const std::vector<Index3> blocks = blocks_of(raw, lattice, band_mm());
  std::vector<Reach> reach(blocks.size());
  model::parallel_for(blocks.size(), control.threads, [&](std::size_t i) {
    reach[i] = BlockCutter::reach(pass, lattice, band_mm(), blocks[i]);
  });
  const std::size_t partly = std::count(reach.begin(), reach.end(), Reach::partly);
  require_memory(2.0 * static_cast<double>(memory_bytes()) +
                     band_bytes(area_about(partly, lattice), lattice.voxel_mm),
                 memory_limit_bytes, lattice.voxel_mm);

  std::vector<BlockChanges> changes;
  changes.reserve(blocks.size());
  for (std::size_t i = 0; i < blocks.size(); ++i) changes.emplace_back(old);
  std::atomic<std::size_t> done = 0;
  model::parallel_for(blocks.size(), control.threads, [&](std::size_t i) {
    if (reach[i] == Reach::wholly) changes[i].removed(blocks[i], kBlockEdge);
    if (reach[i] != Reach::partly) return;
    control.check();
    BlockCutter(pass, lattice, band_mm()).cut(blocks[i], changes[i]);
    control.report(static_cast<double>(++done) / static_cast<double>(partly));
  });
  auto grid = impl_->grid->deepCopy();
  for (BlockChanges& c : changes) c.put_into(grid->tree());
  return StockGrid(std::make_shared<const Impl>(Impl{grid, lattice}));
}

const Lattice& StockGrid::lattice() const {
  return impl_->lattice;
}

double StockGrid::value(const Vec3& p) const {
  const Vec3 i = (p - impl_->lattice.origin_mm) / impl_->lattice.voxel_mm;
  return openvdb::tools::BoxSampler::sample(impl_->grid->tree(), openvdb::Vec3d(i.x, i.y, i.z));
}

double StockGrid::volume_mm3() const {
  const double voxel = impl_->lattice.voxel_mm;
  const Tree& tree = impl_->grid->tree();
  double voxels = 0;
  auto tile = tree.cbeginValueAll();
  for (tile.setMaxDepth(Tree::ValueAllCIter::LEAF_DEPTH - 1); tile; ++tile)
    if (*tile < 0) voxels += static_cast<double>(tile.getVoxelCount());
  Accessor accessor(tree);
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf) voxels += leaf_volume(*leaf, accessor, voxel);
  return voxels * voxel * voxel * voxel;
}

std::size_t StockGrid::memory_bytes() const {
  return impl_->grid->memUsage();
}

std::size_t StockGrid::band_voxels() const {
  return impl_->grid->activeVoxelCount();
}

std::vector<Index3> StockGrid::surface_voxels() const {
  const Tree& tree = impl_->grid->tree();
  // A step to a neighbour changes φ by no more than a voxel, give or take single precision.
  const double deepest = -1.001 * impl_->lattice.voxel_mm;
  Accessor accessor(tree);
  std::vector<Index3> found;
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
    for (auto v = leaf->cbeginValueOn(); v; ++v)
      if (*v < 0 && *v > deepest && on_surface(accessor, v.getCoord()))
        found.push_back(index3(v.getCoord()));
  return found;
}

ColumnTops StockGrid::column_tops() const {
  const Tree& tree = impl_->grid->tree();
  const Lattice& lattice = impl_->lattice;
  openvdb::CoordBBox box;
  if (!tree.evalLeafBoundingBox(box))
    return {lattice.origin_mm,
            kLeafEdge * lattice.voxel_mm,
            1,
            1,
            {-std::numeric_limits<double>::infinity()}};
  const Coord low = box.min() & ~(kLeafEdge - 1);
  ColumnTops tops;
  tops.edge_mm = kLeafEdge * lattice.voxel_mm;
  tops.corner_mm = lattice.point(index3(low)) - Vec3{0.5, 0.5, 0.5} * lattice.voxel_mm;
  tops.nx = (box.max().x() - low.x()) / kLeafEdge + 1;
  tops.ny = (box.max().y() - low.y()) / kLeafEdge + 1;
  tops.top_mm.assign(static_cast<std::size_t>(tops.nx) * tops.ny,
                     -std::numeric_limits<double>::infinity());
  const auto raise = [&](const Coord& at, int z) {
    const int i = (at.x() - low.x()) / kLeafEdge, j = (at.y() - low.y()) / kLeafEdge;
    double& top = tops.top_mm[static_cast<std::size_t>(j) * tops.nx + i];
    top = std::max(top, lattice.origin_mm.z + (z + 1) * lattice.voxel_mm);
  };
  auto tile = tree.cbeginValueAll();
  for (tile.setMaxDepth(Tree::ValueAllCIter::LEAF_DEPTH - 1); tile; ++tile) {
    if (*tile >= 0) continue;
    const openvdb::CoordBBox b = tile.getBoundingBox();
    for (int x = b.min().x(); x <= b.max().x(); x += kLeafEdge)
      for (int y = b.min().y(); y <= b.max().y(); y += kLeafEdge) raise({x, y, 0}, b.max().z());
  }
  // Material thinner than a voxel may miss every centre, but none by more than half a diagonal.
  const double near = 0.8661 * lattice.voxel_mm;
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
    for (int n = 0; n < static_cast<int>(Leaf::SIZE); ++n)
      if (leaf->getValue(n) <= near) raise(leaf->origin(), leaf->offsetToGlobalCoord(n).z());
  return tops;
}

StockMesh StockGrid::mesh() const {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(*impl_->grid, points, triangles, quads, 0.0, 0.0);
  StockMesh mesh;
  for (const auto& p : points) mesh.vertices.push_back({p.x(), p.y(), p.z()});
  // OpenVDB's polygons turn clockwise seen from outside.
  for (const auto& t : triangles) mesh.triangles.push_back({t[0], t[2], t[1]});
  for (const auto& q : quads) {
    mesh.triangles.push_back({q[0], q[2], q[1]});
    mesh.triangles.push_back({q[0], q[3], q[2]});
  }
  return mesh;
}

void StockGrid::write(const std::filesystem::path& file) const {
  try {
    openvdb::io::File out(file.string());
    // Writing a grid notes statistics in its metadata: give it a shallow copy of its own.
    out.write({impl_->grid->copyGrid()});
    out.close();
  } catch (const openvdb::Exception& e) {
    throw model::ResourceError(file.string() + ": cannot be written: " + e.what());
  }
  fix_identifier(file);
}

}  // namespace limitgauge::simulator
