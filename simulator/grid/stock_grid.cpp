#include "simulator/grid/stock_grid.h"

#include <openvdb/tools/Interpolation.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/grid/grid_file.h"
#include "simulator/grid/tree_queries.h"
#include "simulator/grid/vdb_tree.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::RunControl;
using model::Vec3;
using namespace vdb;

openvdb::FloatGrid::Ptr empty_grid(const Lattice& lattice) {
  start_openvdb();
  auto grid = openvdb::FloatGrid::create(static_cast<float>(kBandVoxels * lattice.voxel_mm));
  auto transform = openvdb::math::Transform::createLinearTransform(lattice.voxel_mm);
  transform->postTranslate({lattice.origin_mm.x, lattice.origin_mm.y, lattice.origin_mm.z});
  grid->setTransform(transform);
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  grid->setName("stock");
  return grid;
}

IndexBox with_margin(IndexBox box, int margin) {
  for (int a = 0; a < 2; ++a) box.low[a] -= margin, box.high[a] += margin;
  return box;
}

class LeafSource : public NetSource {
 public:
  // A cell's corners are no farther apart than its diagonal, and φ changes by no more than that.
  LeafSource(const Tree& tree, const IndexBox& box, double voxel_mm)
      : tree_(tree), leaves_(ordered_leaves(tree, box)) {
    const auto near = static_cast<float>(1.7321 * voxel_mm);
    std::erase_if(leaves_, [near](const Leaf* leaf) {
      const float* values = leaf->buffer().data();
      return std::none_of(values, values + kLeafVoxels,
                          [near](float v) { return std::abs(v) <= near; });
    });
  }
  std::size_t leaves() const override { return leaves_.size(); }
  Index3 corner(std::size_t leaf) const override { return index3(leaves_[leaf]->origin()); }
  void values(std::size_t leaf, LeafPatch& patch) const override {
    fill_patch(tree_, *leaves_[leaf], patch);
  }

 private:
  const Tree& tree_;
  std::vector<const Leaf*> leaves_;
};

/// Adds the voxels of the leaves that `wanted` says yes to, whose value is another one in `other`.
template <class Wanted>
void add_changed(const Tree& tree, const Tree& other, const Wanted& wanted,
                 std::vector<Index3>& changed) {
  const openvdb::tree::ValueAccessor<const Tree> beside(other);
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf) {
    if (!wanted(leaf->origin())) continue;
    for (openvdb::Index k = 0; k < Leaf::SIZE; ++k) {
      const Coord at = leaf->offsetToGlobalCoord(k);
      float value = 0;
      const bool in_band = beside.probeValue(at, value) || leaf->isValueOn(k);
      if (in_band && value != leaf->getValue(k)) changed.push_back(index3(at));
    }
  }
}

}  // namespace

struct StockGrid::Impl {
  openvdb::FloatGrid::Ptr grid;
  Lattice lattice;
  IndexBox box, built;
};

IndexBox stock_extent(const RawStock& raw, const Lattice& lattice) {
  const model::Box3 box = bounding_box(raw).grown((kBandVoxels + 1) * lattice.voxel_mm);
  const double scale = lattice.voxel_mm * kBlockEdge;
  IndexBox extent;
  for (int a = 0; a < 3; ++a) {
    const auto block = [&](double x) {
      return static_cast<int>(std::floor((x - lattice.origin_mm[a]) / scale));
    };
    extent.low[a] = block(box.low[a]) * kBlockEdge;
    extent.high[a] = (block(box.high[a]) + 1) * kBlockEdge;
  }
  return extent;
}

ColumnTops empty_tops(const IndexBox& extent, const Lattice& lattice) {
  ColumnTops tops;
  tops.edge_mm = kLeafEdge * lattice.voxel_mm;
  tops.corner_mm = lattice.point(extent.low) - Vec3{0.5, 0.5, 0.5} * lattice.voxel_mm;
  tops.nx = (extent.high[0] - extent.low[0]) / kLeafEdge;
  tops.ny = (extent.high[1] - extent.low[1]) / kLeafEdge;
  tops.top_mm.assign(static_cast<std::size_t>(tops.nx) * static_cast<std::size_t>(tops.ny),
                     -std::numeric_limits<double>::infinity());
  return tops;
}

StockGrid::StockGrid(const RawStock& raw, const Lattice& lattice, const IndexBox& box, int margin,
                     const RunControl& control)
    : impl_(std::make_shared<Impl>(
          Impl{empty_grid(lattice), lattice, box,
               with_margin(box, margin).common(stock_extent(raw, lattice))})) {
  add_raw(impl_->grid->tree(), raw, lattice, impl_->built, control);
}

PassReach StockGrid::reach(const SweepIndex& pass, const RunControl& control) const {
  return pass_reach(pass, impl_->lattice, band_mm(), impl_->built, control);
}

StockGrid StockGrid::cut(const SweepIndex& pass, const PassReach& reach,
                         const RunControl& control) const& {
  const Impl copy{impl_->grid->deepCopy(), impl_->lattice, impl_->box, impl_->built};
  return StockGrid(std::make_shared<Impl>(copy)).cut(pass, reach, control);
}

StockGrid StockGrid::cut(const SweepIndex& pass, const PassReach& reach,
                         const RunControl& control) && {
  if (shared()) return static_cast<const StockGrid&>(*this).cut(pass, reach, control);
  cut_tree(impl_->grid->tree(), pass, impl_->lattice, reach, control);
  return StockGrid(std::move(impl_));
}

const Lattice& StockGrid::lattice() const {
  return impl_->lattice;
}

const IndexBox& StockGrid::box() const {
  return impl_->box;
}

double StockGrid::value(const Vec3& p) const {
  const Vec3 i = (p - impl_->lattice.origin_mm) / impl_->lattice.voxel_mm;
  return openvdb::tools::BoxSampler::sample(impl_->grid->tree(), openvdb::Vec3d(i.x, i.y, i.z));
}

GridRun StockGrid::proven_run(const Vec3& from, const Vec3& along, double limit_mm) const {
  const double voxel = impl_->lattice.voxel_mm;
  // The second is a step that is worth its look.
  const double slack = kSinglePrecision_voxels * voxel, least = 0.05 * voxel;
  const openvdb::tree::ValueAccessor<const Tree, false> tree(impl_->grid->tree());
  GridRun run;
  while (run.length_mm < limit_mm) {
    const Vec3 p = from + along * run.length_mm;
    const Vec3 i = (p - impl_->lattice.origin_mm) / voxel;
    const Index3 nearest{static_cast<int>(std::lround(i.x)), static_cast<int>(std::lround(i.y)),
                         static_cast<int>(std::lround(i.z))};
    const double phi = tree.getValue(coord(nearest));
    const double step = std::abs(phi) - distance(p, impl_->lattice.point(nearest)) - slack;
    if (step < least) break;
    run.material = phi < 0;
    run.length_mm += step;
  }
  run.length_mm = std::min(run.length_mm, limit_mm);
  return run;
}

GridVolume StockGrid::volume(const RunControl& control) const {
  const Tree& tree = impl_->grid->tree();
  return vdb::volume(tree, ordered_leaves(tree, impl_->box), impl_->box, impl_->lattice.voxel_mm,
                     control);
}

std::size_t StockGrid::memory_bytes() const {
  return impl_->grid->memUsage();
}

std::size_t StockGrid::leaf_count() const {
  return impl_->grid->tree().leafCount();
}

std::vector<Index3> StockGrid::changed_voxels(const StockGrid& before) const {
  const Tree &now = impl_->grid->tree(), &then = before.impl_->grid->tree();
  std::vector<Index3> changed;
  add_changed(
      now, then, [](const Coord&) { return true; }, changed);
  // Leaves that were cut away as a whole.
  add_changed(
      then, now, [&](const Coord& at) { return !now.probeConstLeaf(at); }, changed);
  return changed;
}

void StockGrid::raise_tops(const IndexBox& extent, const RunControl& control,
                           ColumnTops& tops) const {
  const Tree& tree = impl_->grid->tree();
  vdb::raise_tops(tree, ordered_leaves(tree, impl_->box), impl_->box, extent, impl_->lattice,
                  control, tops);
}

ColumnTops StockGrid::column_tops(const RunControl& control) const {
  ColumnTops tops = empty_tops(impl_->box, impl_->lattice);
  raise_tops(impl_->box, control, tops);
  return tops;
}

model::TriangleMesh StockGrid::mesh(const MakePlacer& placers, const RunControl& control) const {
  const LeafSource source(impl_->grid->tree(), impl_->box, impl_->lattice.voxel_mm);
  return surface_net(source, impl_->lattice, placers, control);
}

std::variant<model::TriangleMesh, NetSize> StockGrid::mesh_within(double most_bytes,
                                                                  const MakePlacer& placers,
                                                                  const RunControl& control) const {
  const LeafSource source(impl_->grid->tree(), impl_->box, impl_->lattice.voxel_mm);
  return surface_net_within(most_bytes, source, impl_->lattice, placers, control);
}

void StockGrid::write(const std::filesystem::path& file, const model::Pose& pose,
                      double blunt_mm) const {
  if (pose == model::Pose{}) return write_grid(*impl_->grid, file, blunt_mm);
  write_grid(*vdb::turned(*impl_->grid, pose), file, blunt_mm);
}

struct GridLeaves::Impl {
  const Tree& tree;
  double voxel_mm;
  std::vector<const Leaf*> leaves;
};

GridLeaves::GridLeaves(const StockGrid& grid)
    : impl_(new Impl{grid.impl_->grid->tree(), grid.lattice().voxel_mm,
                     ordered_leaves(grid.impl_->grid->tree(), grid.box())}) {}
GridLeaves::~GridLeaves() = default;

std::size_t GridLeaves::size() const {
  return impl_->leaves.size();
}

Index3 GridLeaves::corner(std::size_t leaf) const {
  return index3(impl_->leaves[leaf]->origin());
}

std::vector<Index3> GridLeaves::surface_voxels(std::size_t leaf) const {
  const Leaf& at = *impl_->leaves[leaf];
  std::vector<Index3> voxels;
  for (const int n : vdb::surface_voxels(impl_->tree, at, impl_->voxel_mm))
    voxels.push_back(index3(at.offsetToGlobalCoord(static_cast<openvdb::Index>(n))));
  return voxels;
}

}  // namespace limitgauge::simulator
