#include "simulator/grid/vdb_stock.h"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/LevelSetUtil.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <random>
#include <sstream>

#include "model/base/error.h"
#include "model/mesh/mesh_defect.h"
#include "simulator/stock/stock_model.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/rasters.h"
#include "tests/support/temporary_folder.h"

using namespace limitgauge;
using namespace limitgauge::simulator;
using model::TriangleMesh;
using model::Vec3;

/// The address sanitizer has memory of its own, which vdb_reading.cpp cannot mark: it is to do the
/// same. Asked for by it, and by nobody else.
extern "C" const char* __asan_default_options();
extern "C" const char* __asan_default_options() {
  return "malloc_fill_byte=127";
}

namespace {

/// A file that is gone at the end of the test.
class File {
 public:
  explicit File(const std::string& name) : path_(folder_.path() / name) {}
  const std::filesystem::path& path() const { return path_; }

 private:
  tests::TemporaryFolder folder_;
  std::filesystem::path path_;
};

constexpr std::size_t kReadBytes = std::size_t{1} << 30;

StockModel slotted_block() {
  const StockModel raw(model::BoxStock{{-10, -8, -6}, {20, 16, 6}}, 0.5, kReadBytes);
  auto path = std::make_shared<model::Toolpath>();
  path->start = {-14, 0, -1.9};
  tests::feed_to(*path, {14, 1, -2.3});
  tests::feed_to(*path, {3, -12, -3.1});
  return raw.cut({tests::ball_cutter(3), path}, {});
}

// How many triangles there are at an edge, by the number of edges with so many.
std::map<int, int> triangles_at_edges(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> at;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++at[std::minmax(t[k], t[(k + 1) % 3])];
  std::map<int, int> counts;
  for (const auto& [edge, count] : at) ++counts[count];
  return counts;
}

void write(const std::filesystem::path& path, const openvdb::GridPtrVec& grids) {
  openvdb::io::File out(path.string());
  out.write(grids);
  out.close();
}

openvdb::FloatGrid::Ptr ball(const std::string& name = "stock") {
  auto grid = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(5, {1, 2, 3}, 0.5F);
  grid->setName(name);
  return grid;
}

std::string refusal(const openvdb::GridPtrVec& grids) {
  const File file("limitgauge_vdb_refusal.vdb");
  write(file.path(), grids);
  try {
    read_vdb_stock(file.path());
  } catch (const model::InputError& error) {
    return std::string(error.what()).substr(file.path().string().size());
  }
  return "no error";
}

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

}  // namespace

TEST_CASE("the stock of a run comes back as its zero set", "[property][mesh][vdb]") {
  const File file("limitgauge_vdb_stock.vdb");
  const StockModel stock = slotted_block();
  stock.write_vdb(file.path());
  const VdbStock back = read_vdb_stock(file.path());
  CHECK(back.voxel_mm == 0.5);
  CHECK(back.blunt_mm == Approx(0.5 * std::sqrt(3)));
  CHECK_FALSE(find_defect(back.mesh).has_value());
  // The file holds the level set alone, linear within its cells: edges are cut off by half a voxel
  // squared at most, which the stock's own volume knows better. Edges here: the block's 12 and the
  // slot's, some 260 mm.
  const double edges_mm = 260;
  CHECK(std::abs(volume_mm3(back.mesh) - stock.volume_mm3()) < edges_mm * 0.5 * 0.5 * 0.5);
  // Two triangles at every edge.
  const auto at_edges = triangles_at_edges(back.mesh);
  CHECK(at_edges.size() == 1);
  CHECK(at_edges.begin()->first == 2);
  // Vertices lie on the stock's surface but for what interpolating its level set in a cell is off
  // (edges cut by no more than a voxel).
  double far = 0, sum = 0;
  for (const Vec3& v : back.mesh.vertices) {
    const double off = std::abs(stock.exact_value(v));
    far = std::max(far, off), sum += off;
  }
  CHECK(far < 0.5);
  CHECK(sum / static_cast<double>(back.mesh.vertices.size()) < 0.01);
  CHECK(model::bounding_box(back.mesh).high.z <= 0);
}

TEST_CASE("OpenVDB reads the stock of a run by itself", "[unit][vdb]") {
  const File file("limitgauge_vdb_plain.vdb");
  const StockModel stock = slotted_block();
  stock.write_vdb(file.path());
  openvdb::io::File in(file.path().string());
  in.open();
  const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(in.readGrid("stock"));
  in.close();
  REQUIRE(grid);
  CHECK(grid->getGridClass() == openvdb::GRID_LEVEL_SET);
  CHECK(grid->voxelSize() == openvdb::Vec3d(0.5));
  const openvdb::tools::GridSampler<openvdb::FloatGrid, openvdb::tools::BoxSampler> at(*grid);
  std::mt19937_64 random(7);
  std::uniform_real_distribution<> x(-12, 12), y(-10, 10), z(-8, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p{x(random), y(random), z(random)};
    CHECK(at.wsSample({p.x, p.y, p.z}) == Approx(stock.value(p)).margin(1e-5));
  }
}

TEST_CASE("the zero set of a ball", "[unit][mesh][vdb]") {
  const File file("limitgauge_vdb_ball.vdb");
  write(file.path(), {ball()});
  const VdbStock back = read_vdb_stock(file.path());
  // Chords of a voxel's length in a ball of ten voxels, as OpenVDB centres it.
  CHECK(volume_mm3(back.mesh) == Approx(4.0 / 3 * M_PI * 125).epsilon(0.01));
  CHECK(distance(model::bounding_box(back.mesh).centre(), {1, 2, 3}) < 0.01);
  CHECK(triangles_at_edges(back.mesh).begin()->first == 2);
}

TEST_CASE("of several grids the stock is taken", "[unit][mesh][vdb]") {
  const File file("limitgauge_vdb_two.vdb");
  write(file.path(), {ball("other"), ball("stock")});
  CHECK(read_vdb_stock(file.path()).voxel_mm == 0.5);
  CHECK(refusal({ball("one"), ball("two")}) ==
        ": error: the file has 2 grids; expected one, or one named \"stock\"");
  CHECK(refusal({ball("whatever")}) == "no error");
}

TEST_CASE("a grid that lies turned is read where it lies", "[unit][mesh][vdb]") {
  const File file("limitgauge_vdb_turned.vdb");
  const auto read = [&](const openvdb::FloatGrid::Ptr& grid) {
    write(file.path(), {grid});
    return read_vdb_stock(file.path());
  };
  const VdbStock upright = read(ball());
  for (const double turn : {0.3, std::numbers::pi / 2, std::numbers::pi}) {
    auto grid = ball();
    grid->transform().postRotate(turn, openvdb::math::X_AXIS);
    grid->transform().postTranslate({0.5, -7, 2});
    const VdbStock turned = read(grid);
    CHECK(turned.voxel_mm == Approx(0.5).epsilon(1e-14));
    CHECK_FALSE(find_defect(turned.mesh).has_value());
    REQUIRE(turned.mesh.triangles == upright.mesh.triangles);
    const double c = std::cos(turn), s = std::sin(turn);
    for (std::size_t i = 0; i < upright.mesh.vertices.size(); ++i) {
      const Vec3& v = upright.mesh.vertices[i];
      const Vec3 there{v.x + 0.5, c * v.y - s * v.z - 7, s * v.y + c * v.z + 2};
      CHECK(length(turned.mesh.vertices[i] - there) < 1e-12);
    }
  }
}

TEST_CASE("a .vdb that is no stock is refused", "[unit][mesh][vdb]") {
  auto fog = ball();
  openvdb::tools::sdfToFogVolume(*fog);
  CHECK(refusal({fog}) ==
        ": error: the grid is no level set but 'fog volume'; expected a level set");
  CHECK(refusal({openvdb::DoubleGrid::create(1.0)}) ==
        ": error: the grid holds values of type 'double'; expected float");
  auto empty = openvdb::FloatGrid::create(1.0F);
  empty->setGridClass(openvdb::GRID_LEVEL_SET);
  CHECK(refusal({empty}) ==
        ": error: the grid holds no material; expected a level set, negative inside");
  auto flat = ball();
  flat->transform().preScale({1, 1, 0.5});
  CHECK(refusal({flat}) ==
        ": error: the grid is mirrored, sheared or unevenly scaled; expected cubic voxels, turned "
        "and moved at most");
  auto mirrored = ball();
  mirrored->transform().preScale({1, -1, 1});
  CHECK_THAT(refusal({mirrored}), ContainsSubstring("mirrored, sheared or unevenly scaled"));
  auto sheared = ball();
  sheared->transform().preShear(0.1, openvdb::math::X_AXIS, openvdb::math::Y_AXIS);
  CHECK_THAT(refusal({sheared}), ContainsSubstring("mirrored, sheared or unevenly scaled"));
  auto nan = ball();
  nan->tree().beginValueOn().setValue(std::numeric_limits<float>::quiet_NaN());
  CHECK_THAT(refusal({nan}), ContainsSubstring("a distance is not a finite number"));
  // A leaf in the band goes missing: what was inside beside it now ends at nothing.
  auto torn = ball();
  torn->tree().addTile(1, {2, 12, 6}, torn->background(), false);
  torn->tree().addTile(1, torn->tree().cbeginLeaf()->origin(), -torn->background(), false);
  CHECK_THAT(refusal({torn}), ContainsSubstring("from one node to the next, 0.5 mm on, values "));
}

TEST_CASE("a .vdb whose inside was left empty is refused: it is a shell", "[unit][mesh][vdb]") {
  auto hollow = ball();
  const float outside = hollow->background();
  for (auto off = hollow->beginValueOff(); off; ++off) off.setValue(outside);
  CHECK_THAT(refusal({hollow}), ContainsSubstring("expected signed distances in mm, negative all "
                                                  "through the inside"));
  // Distances that were drawn out by half still are some.
  auto drawn_out = ball();
  for (auto on = drawn_out->beginValueOn(); on; ++on) on.setValue(1.5F * *on);
  CHECK(refusal({drawn_out}) == "no error");
}

TEST_CASE("a .vdb whose mesh would not fit is refused beforehand", "[unit][mesh][vdb]") {
  const File file("limitgauge_vdb_large.vdb");
  write(file.path(), {ball()});
  CHECK_THROWS_AS(read_vdb_stock(file.path(), 100000), model::ResourceError);
  CHECK_THROWS_WITH(read_vdb_stock(file.path(), 100000),
                    ContainsSubstring("voxels, whose triangles"));
}

TEST_CASE("files that are no .vdb, or half of one", "[unit][mesh][vdb]") {
  const File file("limitgauge_vdb_half.vdb");
  CHECK_THROWS_WITH(read_vdb_stock(file.path()), ContainsSubstring("there is no such file"));
  write(file.path(), {ball()});
  const std::string whole = text_of_file(file.path());
  const auto put = [&](const std::string& bytes) {
    std::ofstream(file.path(), std::ios::binary | std::ios::trunc) << bytes;
  };
  put("solid a\nendsolid\n");
  CHECK_THROWS_WITH(read_vdb_stock(file.path()), ContainsSubstring("the file is no .vdb"));
  for (std::size_t part = 1; part < 40; ++part) {
    put(whole.substr(0, whole.size() * part / 40));
    CHECK_THROWS_AS(read_vdb_stock(file.path()), model::InputError);
  }
}

TEST_CASE("what voxels make blunt adds up from file to file", "[property][mesh][vdb]") {
  const File file("limitgauge_vdb_blunt.vdb");
  slotted_block().write_vdb(file.path());
  const VdbStock first = read_vdb_stock(file.path());
  model::MeshStock again{std::make_shared<const model::TriangleMesh>(first.mesh), "a.vdb", 0.5};
  again.blunt_mm = first.blunt_mm;
  StockModel(again, 1, std::size_t{1} << 30, {}).write_vdb(file.path());
  CHECK(read_vdb_stock(file.path()).blunt_mm == Approx(1.5 * std::sqrt(3)));
}

TEST_CASE("a file that says how blunt it is, and what makes no sense", "[property][mesh][vdb]") {
  const File file("limitgauge_vdb_said.vdb");
  const auto with = [&](double said) {
    const auto grid = ball();
    grid->insertMeta("limitgauge_blunt_mm", openvdb::DoubleMetadata(said));
    write(file.path(), {grid});
    return read_vdb_stock(file.path());
  };
  CHECK(with(3).blunt_mm == 3);
  // No less than its own voxels allow.
  const double voxel = with(0).voxel_mm;
  CHECK(with(0).blunt_mm == Approx(voxel * std::sqrt(3)));
  for (const double wrong : {-1.0, 1e9, std::nan(""), HUGE_VAL})
    CHECK_THROWS_WITH(with(wrong), ContainsSubstring("limitgauge_blunt_mm"));
}

/// Has memory that is asked for next hold `value`, as if a stock had stood there.
void fill_free_memory(float value) {
  std::vector<std::vector<float>> blocks;
  for (int i = 0; i < 2000; ++i) blocks.emplace_back(512 + i % 3, value);
}

TEST_CASE("distances that a file lacks are not taken from memory", "[property][mesh][vdb]") {
  const File file("limitgauge_vdb_short.vdb");
  openvdb::io::File out(file.path().string());
  out.setCompression(openvdb::io::COMPRESS_ACTIVE_MASK);
  out.write(openvdb::GridPtrVec{ball()});
  out.close();
  const std::string whole = text_of_file(file.path());
  for (std::size_t part = 1; part < 40; ++part) {
    std::ofstream(file.path(), std::ios::binary | std::ios::trunc)
        << whole.substr(0, whole.size() * part / 40);
    for (const float value : {1.0F, -1.0F}) {
      fill_free_memory(value);
      CHECK_THROWS_AS(read_vdb_stock(file.path()), model::InputError);
    }
  }
}

TEST_CASE("damaged files are refused or read, never worse", "[property][mesh][vdb]") {
  const File file("limitgauge_vdb_damaged.vdb");
  write(file.path(), {ball()});
  const std::string whole = text_of_file(file.path());
  std::mt19937 random(11);
  const int kDamages = tests::by_effort(24, 60);
  int refused = 0;
  for (int n = 0; n < kDamages; ++n) {
    std::string bytes = whole;
    // Behind the header, where the damage meets OpenVDB's buffers.
    for (int flips = 1 + static_cast<int>(random() % 4); flips > 0; --flips)
      bytes[1000 + random() % (bytes.size() - 1000)] = static_cast<char>(random());
    std::ofstream(file.path(), std::ios::binary | std::ios::trunc) << bytes;
    try {
      const VdbStock back = read_vdb_stock(file.path());
      CHECK_FALSE(find_defect(back.mesh).has_value());
    } catch (const model::InputError&) {
      ++refused;
    }
  }
  CHECK(refused > kDamages / 6);
}
