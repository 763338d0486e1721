#include "simulator/grid/vdb_reading.h"

#include <malloc.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "model/base/error.h"
#include "model/geometry/pose.h"
#include "model/mesh/mesh_soup.h"
#include "model/part/stock.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"
#include "simulator/grid/grid_file.h"
#include "simulator/grid/vdb_answer.h"
#include "simulator/mesh/tetrahedra.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using openvdb::Coord;
using Tree = openvdb::FloatTree;
using Leaf = Tree::LeafNodeType;
using Accessor = openvdb::FloatGrid::ConstAccessor;

constexpr int kUnwrittenByte = 0x7F;
constexpr float kUnwritten = 3e38F;  ///< four such bytes are 3.4e38

[[noreturn]] void refuse(const std::string& wrong, const std::string& expected) {
  throw VdbRefusal(wrong + "; expected " + expected);
}

std::string name_of_stock(openvdb::io::File& file) {
  std::vector<std::string> names;
  for (auto name = file.beginName(); name != file.endName(); ++name) names.push_back(*name);
  if (names.size() == 1) return names.front();
  if (std::ranges::find(names, "stock") != names.end()) return "stock";
  refuse("the file has " + std::to_string(names.size()) + " grids", "one, or one named \"stock\"");
}

// Where a grid's nodes lie: those of a lattice, turned and moved. A run whose setups turn the part
// writes such grids, in the part's frame.
struct GridPlace {
  Lattice lattice;
  model::Pose pose;
};

// Of a transform that scales evenly, turns and moves.
GridPlace place_of(const openvdb::math::Transform& transform) {
  constexpr const char* kExpected = "cubic voxels, turned and moved at most";
  if (!transform.isLinear()) refuse("the grid's transform is not linear", kExpected);
  const openvdb::Mat4d m = transform.baseMap()->getAffineMap()->getMat4();
  const double voxel = length(model::Vec3{m(0, 0), m(0, 1), m(0, 2)});
  if (!(voxel > 0) || !std::isfinite(voxel))
    refuse("the grid's voxel is " + model::shortest(voxel) + " mm", kExpected);
  const model::Vec3 origin{m(3, 0), m(3, 1), m(3, 2)};
  if (!is_finite(origin)) refuse("the grid has no finite place", kExpected);
  std::array<model::Vec3, 3> rows;
  for (int c = 0; c < 3; ++c) rows[c] = model::Vec3{m(0, c), m(1, c), m(2, c)} / voxel;
  try {
    GridPlace place{{origin, voxel}, model::rotation_of(rows, kStraightAxes)};
    if (place.pose.turns()) place.lattice.origin_mm = {}, place.pose.shift_mm = origin;
    return place;
  } catch (const std::invalid_argument&) {
    refuse("the grid is mirrored, sheared or unevenly scaled", kExpected);
  }
}

void require_level_set(const openvdb::GridBase& grid) {
  if (!grid.isType<openvdb::FloatGrid>())
    refuse("the grid holds values of type " + model::in_quotes(grid.valueType()), "float");
  if (grid.getGridClass() != openvdb::GRID_LEVEL_SET)
    refuse("the grid is no level set but " +
               model::in_quotes(openvdb::GridBase::gridClassToString(grid.getGridClass())),
           "a level set");
}

openvdb::FloatGrid::Ptr grid_of(openvdb::io::File& file) {
  file.open(false);
  const std::string name = name_of_stock(file);
  require_level_set(*file.readGridMetadata(name));
  auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid(name));
  if (!grid) refuse("the grid cannot be read", "a level set");
  return grid;
}

// OpenVDB does not notice where a file without compression ends too early, and takes what happens
// to stand in memory for distances. As long as one of these lives, memory that is asked for holds
// the same, and no distance that anybody means.
class MarkedMemory {
 public:
  MarkedMemory() { mallopt(M_PERTURB, kUnwrittenByte ^ 0xFF); }
  ~MarkedMemory() { mallopt(M_PERTURB, 0); }
  MarkedMemory(const MarkedMemory&) = delete;
  MarkedMemory& operator=(const MarkedMemory&) = delete;
};

// Of a damaged file OpenVDB may ask for any amount of memory.
openvdb::FloatGrid::Ptr read_grid(const std::filesystem::path& path) {
  try {
    const MarkedMemory marked;
    openvdb::io::File file(path.string());
    return grid_of(file);
  } catch (const VdbRefusal&) {
    throw;
  } catch (const std::bad_alloc&) {
    refuse("OpenVDB asks for more memory than there is: the file is damaged or too large",
           "a stock.vdb of an earlier run");
  } catch (const std::exception&) {
    // OpenVDB's words are about its internals.
    refuse("OpenVDB cannot read the file: it is damaged or of another version",
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

void require_number(float distance) {
  if (!std::isfinite(distance)) refuse("a distance is not a finite number", "millimetres");
  if (std::abs(distance) < kUnwritten) return;
  refuse("a distance is missing: the file is damaged", "a stock.vdb of an earlier run");
}

// Every value is looked at, so that one that is no number cannot hide.
void require_numbers(const Tree& tree) {
  auto tile = tree.cbeginValueAll();
  for (tile.setMaxDepth(Tree::ValueAllCIter::LEAF_DEPTH - 1); tile; ++tile) require_number(*tile);
  bool material = false;
  for (auto leaf = tree.cbeginLeaf(); leaf; ++leaf)
    for (openvdb::Index n = 0; n < Leaf::SIZE; ++n) {
      require_number(leaf->getValue(n));
      material = material || leaf->getValue(n) < 0;
    }
  if (!material) refuse("the grid holds no material", "a level set, negative inside");
  if (!(tree.background() > 0))
    refuse("the grid is not empty outside its band", "a level set, negative inside");
}

void require_memory(std::size_t cells, std::size_t limit_bytes) {
  // A cell has about four triangles; each costs three points on its own, itself, its joined points
  // and its share of the tables while they are joined.
  constexpr std::size_t kBytesOfCell = 4 * 200;
  constexpr std::size_t kMostCells = UINT32_MAX / 36;  // 12 triangles of 3 points at most
  if (cells <= kMostCells && cells <= limit_bytes / kBytesOfCell) return;
  throw model::ResourceError("the surface passes " + std::to_string(cells) +
                             " voxels, whose triangles need about " +
                             std::to_string(cells * kBytesOfCell >> 20) + " MiB; allowed are " +
                             std::to_string(limit_bytes >> 20) +
                             " MiB; a coarser voxel in the run that wrote it would do");
}

// A distance changes by a voxel from node to node at most. Where it leaps across the surface, what
// lies inside of the band was never filled (the file is a hollow shell) or the numbers are no
// distances.
void require_distances(const std::array<double, 8>& f, const Coord& low, const GridPlace& place) {
  const Lattice& lattice = place.lattice;
  for (int k = 0; k < 8; ++k)
    for (const int next : {k | 1, k | 2, k | 4}) {
      const double leap_mm = std::abs(f[next] - f[k]);
      if ((f[k] <= 0) == (f[next] <= 0) || leap_mm <= kSteepestLevelSet * lattice.voxel_mm)
        continue;
      const model::Vec3 at = place.pose.point(lattice.point({low.x(), low.y(), low.z()}));
      refuse("from one node to the next, " + model::shortest(lattice.voxel_mm) +
                 " mm on, values change by " + model::shortest(leap_mm) + " mm, at " +
                 model::shortest(at.x) + ", " + model::shortest(at.y) + ", " +
                 model::shortest(at.z) + " mm",
             "signed distances in mm, negative all through the inside");
    }
}

model::TriangleMesh zero_set(const openvdb::FloatGrid& grid, const GridPlace& place,
                             std::size_t limit_bytes) {
  require_numbers(grid.tree());
  const Cells cells(grid.tree());
  Accessor tree(grid.tree());
  std::array<double, 8> f{};
  std::size_t count = 0;
  cells.each([&](const Coord& low) {
    if (!read_corners(tree, low, f)) return;
    require_distances(f, low, place);
    ++count;
  });
  require_memory(count, limit_bytes);
  model::TriangleSoup soup;
  cells.each([&](const Coord& low) {
    if (read_corners(tree, low, f))
      add_zero_surface(f, {low.x(), low.y(), low.z()}, place.lattice, soup);
  });
  model::TriangleMesh mesh = joined(soup).mesh;
  if (place.pose.turns())
    for (model::Vec3& v : mesh.vertices) v = place.pose.point(v);
  return mesh;
}

// What the file says of the stock that it was written of, no less than its voxels allow; a file of
// another program says nothing.
double blunt_of(const openvdb::FloatGrid& grid, double voxel_mm) {
  const double own_mm = model::kBluntVoxels * voxel_mm;
  const auto said = grid.getMetadata<openvdb::DoubleMetadata>(vdb::kBluntName);
  if (!said) return own_mm;
  constexpr double kMost_mm = 1e4;
  if (!(said->value() >= 0) || said->value() > kMost_mm)
    refuse(std::string(vdb::kBluntName) + " is " + model::shortest(said->value()),
           "millimetres from 0 to 10000");
  return std::max(said->value(), own_mm);
}

}  // namespace

struct VdbReading::Grid {
  openvdb::FloatGrid::ConstPtr grid;
};

VdbReading::VdbReading(const std::filesystem::path& path)
    : grid_(std::make_shared<const Grid>(Grid{read_grid(path)})) {}

VdbStock VdbReading::stock(std::size_t memory_limit_bytes) const {
  const openvdb::FloatGrid& grid = *grid_->grid;
  const GridPlace place = place_of(grid.transform());
  const double voxel_mm = place.lattice.voxel_mm;
  return {zero_set(grid, place, memory_limit_bytes), voxel_mm, blunt_of(grid, voxel_mm)};
}

std::string vdb_answer_about(const std::filesystem::path& path, std::size_t memory_limit_bytes,
                             std::optional<VdbReading>& kept) {
  try {
    return vdb_answer(kept.emplace(path).stock(memory_limit_bytes));
  } catch (const VdbRefusal& refusal) {
    return vdb_refusal(refusal.what());
  } catch (const model::ResourceError& shortage) {
    return vdb_shortage(shortage.what());
  } catch (const std::bad_alloc&) {
    return vdb_shortage(kShortOfMemory);
  }
}

}  // namespace limitgauge::simulator
