#include "simulator/grid/vdb_stock.h"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "model/base/error.h"
#include "model/base/message_text.h"
#include "model/base/number_text.h"
#include "model/base/text_file.h"
#include "model/mesh/mesh_defect.h"
#include "simulator/mesh/tetrahedra.h"
#include "simulator/stock/in_own_process.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::InputError;
using openvdb::Coord;
using Tree = openvdb::FloatTree;
using Leaf = Tree::LeafNodeType;
using Accessor = openvdb::FloatGrid::ConstAccessor;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& wrong,
                       const std::string& expected) {
  throw InputError({path.string()}, wrong, expected);
}

// OpenVDB's own messages for these are about its internals.
void require_vdb(const std::filesystem::path& path) {
  model::require_file(path);
  constexpr std::array<char, 4> kMagic = {' ', 'B', 'D', 'V'};
  std::array<char, 4> begin{};
  std::ifstream in(path, std::ios::binary);
  in.read(begin.data(), begin.size());
  if (!in || begin != kMagic) fail(path, "the file is no .vdb", "a stock.vdb of an earlier run");
}

std::string name_of_stock(const std::filesystem::path& path, openvdb::io::File& file) {
  std::vector<std::string> names;
  for (auto name = file.beginName(); name != file.endName(); ++name) names.push_back(*name);
  if (names.size() == 1) return names.front();
  if (std::ranges::find(names, "stock") != names.end()) return "stock";
  fail(path, "the file has " + std::to_string(names.size()) + " grids",
       "one, or one named \"stock\"");
}

// The lattice of a transform that only scales evenly and moves.
Lattice lattice_of(const std::filesystem::path& path, const openvdb::math::Transform& transform) {
  constexpr const char* kExpected = "cubic voxels along the axes";
  if (!transform.isLinear()) fail(path, "the grid's transform is not linear", kExpected);
  const openvdb::Mat4d m = transform.baseMap()->getAffineMap()->getMat4();
  const double voxel = m(0, 0);
  if (!(voxel > 0) || !std::isfinite(voxel))
    fail(path, "the grid's voxel is " + model::shortest(voxel) + " mm", kExpected);
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      if (!(std::abs(m(r, c) - (r == c ? voxel : 0)) <= kStraightAxes * voxel))
        fail(path, "the grid is rotated, sheared or unevenly scaled", kExpected);
  const Lattice lattice{{m(3, 0), m(3, 1), m(3, 2)}, voxel};
  if (!is_finite(lattice.origin_mm)) fail(path, "the grid has no finite place", kExpected);
  return lattice;
}

void require_level_set(const std::filesystem::path& path, const openvdb::GridBase& grid) {
  if (!grid.isType<openvdb::FloatGrid>())
    fail(path, "the grid holds values of type " + model::in_quotes(grid.valueType()), "float");
  if (grid.getGridClass() != openvdb::GRID_LEVEL_SET)
    fail(path,
         "the grid is no level set but " +
             model::in_quotes(openvdb::GridBase::gridClassToString(grid.getGridClass())),
         "a level set");
}

openvdb::FloatGrid::Ptr read_grid(const std::filesystem::path& path) {
  openvdb::io::File file(path.string());
  file.open(false);
  const std::string name = name_of_stock(path, file);
  require_level_set(path, *file.readGridMetadata(name));
  auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid(name));
  if (!grid) fail(path, "the grid cannot be read", "a level set");
  return grid;
}

// OpenVDB 10 believes what a file says: of a damaged one it may write beyond its buffers or ask for
// any amount of memory. So it first reads the file where it can do no harm.
void require_sound(const std::filesystem::path& path) {
  // A leaf of 2.3 kB takes 64 bytes in the file at least.
  constexpr std::size_t kUnpacked = 64, kBase = std::size_t{1} << 30, kBytesPerSecond = 10'000'000;
  // A sound file waits for nothing but its turn on a busy machine and for the disk.
  constexpr unsigned kWallPerCpu = 6;
  const std::uintmax_t size = std::filesystem::file_size(path);
  const auto cpu_seconds = static_cast<unsigned>(10 + size / kBytesPerSecond);
  const ProcessLimits limits{kBase + kUnpacked * size, cpu_seconds, kWallPerCpu * cpu_seconds};
  // The grid outlives the work: taking it down again is no part of the trial.
  if (!comes_to_its_end([&] { static const auto grid = read_grid(path); }, limits))
    fail(path, "OpenVDB breaks down over the file: it is damaged", "a stock.vdb of an earlier run");
}

// Of a file that is cut short OpenVDB may allocate what happens to stand in memory: the trial need
// not have met the same.
openvdb::FloatGrid::Ptr read_sound_grid(const std::filesystem::path& path) {
  try {
    return read_grid(path);
  } catch (const std::bad_alloc&) {
    fail(path, "OpenVDB asks for more memory than there is: the file is damaged or too large",
         "a stock.vdb of an earlier run");
  }
}

// Lowest corners of all cells that the surface may pass through: those that have a corner in a
// leaf.
class Cells {
 public:
  explicit Cells(const Tree& tree) : tree_(tree) {
    for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf) add_leaf(*leaf);
    std::ranges::sort(lows_);
    lows_.erase(std::unique(lows_.begin(), lows_.end()), lows_.end());
  }

  template <class Visit>
  void each(Visit&& visit) const {
    for (auto leaf = tree_.cbeginLeaf(); leaf; ++leaf)
      for (openvdb::Index n = 0; n < Leaf::SIZE; ++n) visit(leaf->offsetToGlobalCoord(n));
    for (const Coord& low : lows_) visit(low);
  }

 private:
  // A cell below a leaf's low sides belongs to the leaf there, if there is one.
  void add_leaf(const Leaf& leaf) {
    constexpr int kEdge = Leaf::DIM;
    for (int x = -1; x < kEdge; ++x)
      for (int y = -1; y < kEdge; ++y)
        for (int z = -1; z < kEdge; ++z) {
          if (x >= 0 && y >= 0 && z >= 0) continue;
          const Coord low = leaf.origin().offsetBy(x, y, z);
          if (tree_.probeConstLeaf(low) == nullptr) lows_.push_back(low);
        }
  }

  const Tree& tree_;
  std::vector<Coord> lows_;
};

// Values at the corners of a cell, ordered as tetrahedra.h has them; whether they differ in sign.
bool read_corners(Accessor& tree, const Coord& low, std::array<double, 8>& f) {
  bool inside = false, outside = false;
  for (int k = 0; k < 8; ++k) {
    f[k] = tree.getValue(low.offsetBy(k >> 2 & 1, k >> 1 & 1, k & 1));
    (f[k] <= 0 ? inside : outside) = true;
  }
  return inside && outside;
}

// Every leaf value is looked at, so that a value that is no number cannot hide.
void require_numbers(const std::filesystem::path& path, const Tree& tree) {
  bool material = false;
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
    for (openvdb::Index n = 0; n < Leaf::SIZE; ++n) {
      if (!std::isfinite(leaf->getValue(n)))
        fail(path, "a distance is not a finite number", "millimetres");
      material = material || leaf->getValue(n) < 0;
    }
  if (!material) fail(path, "the grid holds no material", "a level set, negative inside");
  if (!(tree.background() > 0))
    fail(path, "the grid is not empty outside its band", "a level set, negative inside");
}

void require_memory(std::size_t cells, std::size_t limit_bytes, const std::filesystem::path& path) {
  // A cell has about four triangles; each costs three points on its own, itself, its joined points
  // and its share of the tables while they are joined.
  constexpr std::size_t kBytesOfCell = 4 * 200;
  constexpr std::size_t kMostCells = UINT32_MAX / 36;  // 12 triangles of 3 points at most
  if (cells <= kMostCells && cells <= limit_bytes / kBytesOfCell) return;
  throw model::ResourceError(path.string() + ": the surface passes " + std::to_string(cells) +
                             " voxels, whose triangles need about " +
                             std::to_string(cells * kBytesOfCell >> 20) + " MiB; allowed are " +
                             std::to_string(limit_bytes >> 20) +
                             " MiB; a coarser voxel in the run that wrote it would do");
}

model::TriangleMesh zero_set(const std::filesystem::path& path, const openvdb::FloatGrid& grid,
                             const Lattice& lattice, std::size_t limit_bytes) {
  require_numbers(path, grid.tree());
  const Cells cells(grid.tree());
  Accessor tree(grid.tree());
  std::array<double, 8> f{};
  std::size_t count = 0;
  cells.each([&](const Coord& low) { count += read_corners(tree, low, f); });
  require_memory(count, limit_bytes, path);
  model::TriangleSoup soup;
  cells.each([&](const Coord& low) {
    if (read_corners(tree, low, f)) add_zero_surface(f, {low.x(), low.y(), low.z()}, lattice, soup);
  });
  model::TriangleMesh mesh = joined(soup).mesh;
  if (const auto defect = find_defect(mesh))
    fail(path, "the zero set bounds no solid (its band is torn): " + defect->wrong,
         "a level set as simulations write it");
  return mesh;
}

VdbStock read(const std::filesystem::path& path, std::size_t memory_limit_bytes) {
  openvdb::initialize();
  require_sound(path);
  const openvdb::FloatGrid::Ptr grid = read_sound_grid(path);
  const Lattice lattice = lattice_of(path, grid->transform());
  return {zero_set(path, *grid, lattice, memory_limit_bytes), lattice.voxel_mm};
}

}  // namespace

VdbStock read_vdb_stock(const std::filesystem::path& path, std::size_t memory_limit_bytes) {
  require_vdb(path);
  try {
    return read(path, memory_limit_bytes);
  } catch (const InputError&) {
    throw;
  } catch (const model::ResourceError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw model::ResourceError(path.string() + ": there is not enough memory for this stock");
  } catch (const std::exception&) {
    // OpenVDB's words are about its internals.
    fail(path, "OpenVDB cannot read the file: it is damaged or of another version",
         "a stock.vdb of an earlier run");
  }
}

}  // namespace limitgauge::simulator
