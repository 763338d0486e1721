#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "app/inputs/stock_file.h"
#include "model/base/error.h"
#include "simulator/stock/stock_model.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"
#include "tests/support/mesh_shapes.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::app {
namespace {

/// A folder with a block as OBJ and as stock of a run.
class Folder {
 public:
  Folder() {
    std::ofstream obj(folder_.path() / "block.obj");
    const model::TriangleMesh mesh = tests::block_between({0, 0, 0}, {4, 3, 2});
    for (const model::Vec3& v : mesh.vertices)
      obj << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
    for (const auto& t : mesh.triangles)
      obj << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    obj << "f 1 1 2\n";
    simulator::StockModel(model::BoxStock{{0, 0, 0}, {4, 3, 2}}, 0.25, std::size_t{1} << 30)
        .write_vdb(folder_.path() / "stock.vdb");
  }

  Job read_with(const std::string& stock) const {
    std::string text = good_job();
    const std::size_t begin = text.find("[stock]"), end = text.find("[[tool]]");
    text.replace(begin, end - begin, "[stock]\n" + stock + "\n");
    const std::string cage = (tests::fixtures() / "cages/quick-dome.obj").string();
    return read_job_text(with(text, "cages/quick-dome.obj", cage), "job.toml", folder_.path(), {});
  }
  std::string error_with(const std::string& stock) const {
    try {
      read_with(stock);
    } catch (const model::InputError& error) {
      return error.what();
    }
    return "no error";
  }
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }

 private:
  tests::TemporaryFolder folder_;
};

bool says(const Job& job, const std::string& text) {
  return std::find(job.defaulted.begin(), job.defaulted.end(), text) != job.defaulted.end();
}

}  // namespace

TEST_CASE("stock from a mesh beside the job", "[unit][job][stock]") {
  const Folder folder;
  const Job job =
      folder.read_with("shape = \"mesh\"\nfile = \"block.obj\"\nscale = 2\ntranslate = [1, 0, -3]");
  const auto& stock = std::get<model::MeshStock>(job.stock);
  CHECK(stock.file == "block.obj");
  CHECK(stock.voxel_mm == 0);
  CHECK(stock.mesh->triangles.size() == 12);
  CHECK(bounding_box(job.stock).low == model::Vec3{1, 0, -3});
  CHECK(bounding_box(job.stock).high == model::Vec3{9, 6, 1});
  CHECK(says(job, "stock block.obj: left out are triangles with two equal corners, 1 in number"));
  CHECK(says(job,
             "toolpaths that are planned here clear the box about the stock's mesh, not the mesh "
             "itself"));
  const auto planned = std::get<model::BoxStock>(planned_stock(job.stock));
  CHECK(planned.corner_mm == model::Vec3{1, 0, -3});
  CHECK(planned.size_mm == model::Vec3{8, 6, 4});
}

TEST_CASE("stock from an earlier run", "[unit][job][stock]") {
  const Folder folder;
  const Job job = folder.read_with("shape = \"vdb\"\nfile = \"stock.vdb\"");
  const auto& stock = std::get<model::MeshStock>(job.stock);
  CHECK(stock.voxel_mm == 0.25);
  CHECK(stock.blunt_mm == Approx(0.25 * std::sqrt(3)));
  CHECK(volume_mm3(*stock.mesh) == Approx(24).epsilon(1e-6));
  CHECK(says(
      job,
      "stock stock.vdb: taken as the triangle mesh of its zero set at a voxel of 0.25 mm; "
      "nothing is known of what cut it, nor of fins, pins, slots and sharp tips into which no "
      "ball of 0.434 mm fits, which such a file may lack altogether; other edges are blunt by up "
      "to 0.434 mm, so that leftovers of it are taken to stand out that much more, and by as much "
      "grooves may be deeper and contacts with it be missed"));
}

TEST_CASE("stock files that are wrong", "[unit][job][stock]") {
  const Folder folder;
  CHECK(folder.error_with("shape = \"mesh\"\nfile = \"none.stl\"") ==
        "job.toml:6:8: error: no file \"none.stl\"; expected a closed mesh as STL, OBJ or PLY, in "
        "millimetres");
  CHECK(folder.error_with("shape = \"vdb\"\nfile = \"none.vdb\"") ==
        "job.toml:6:8: error: no file \"none.vdb\"; expected the stock.vdb of an earlier run");
  CHECK(folder.error_with("shape = \"vdb\"\nfile = \"block.obj\"") ==
        folder.file("block.obj") +
            ": error: the file is no .vdb; expected a stock.vdb of an "
            "earlier run");
  CHECK(folder.error_with("shape = \"mesh\"\nfile = \"stock.vdb\"") ==
        folder.file("stock.vdb") +
            ": error: the file is no mesh of a known kind; expected STL, "
            "OBJ or PLY");
  CHECK_THAT(folder.error_with("shape = \"mesh\"\nfile = \"block.obj\"\ntranslate = [1e7, 0, 0]"),
             ContainsSubstring("scaled and moved: the vertex"));
  CHECK_THAT(folder.error_with("shape = \"mesh\"\nfile = \"block.obj\"\nscale = 0"),
             ContainsSubstring("job.toml:7:9: error: \"scale\" in [stock] is 0"));
  CHECK_THAT(folder.error_with("shape = \"vdb\"\nfile = \"stock.vdb\"\nscale = 2"),
             ContainsSubstring("unknown key \"scale\" in [stock]"));
}

}  // namespace limitgauge::app
