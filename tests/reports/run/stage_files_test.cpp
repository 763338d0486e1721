#include <filesystem>
#include <fstream>

#include "model/base/error.h"
#include "reports/run/report.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The finish stage of the sample with a real, coarse stock: the raw block and one pass through it.
StageResult stage_with_stock() {
  StageResult stage = sample_result(Outcome::passed, 5).stages[2];
  auto slot = std::make_shared<model::Toolpath>();
  slot->start = {-60, 0, 5};
  slot->moves.push_back({{60, 0, 5}, 1000, 1, model::MoveKind::feed});
  const simulator::StockModel raw(model::BoxStock{{-45, -40, -20}, {90, 80, 30}}, 1.0,
                                  std::size_t(1) << 30);
  stage.ran->stock = raw.cut({stage.cutter, slot}, {});
  return stage;
}

}  // namespace

TEST_CASE("a stage that ran leaves its files, twice the same", "[unit][files]") {
  const tests::TemporaryFolder a, b;
  const StageResult stage = stage_with_stock();
  const auto [pictures, surface, path_view, stock_view] = write_stage_files(stage, a.path(), {});
  write_stage_files(stage, b.path(), {.control = {3}});
  for (const char* name : {"toolpath.vtp", "deviation.vtp", "stock.vtp", "deviation.png",
                           "perspective.png", "stock.png"}) {
    INFO(name);
    CHECK_FALSE(content(a.path() / "finish" / name).empty());
    CHECK(content(a.path() / "finish" / name) == content(b.path() / "finish" / name));
  }
  CHECK_FALSE(content(a.path() / "finish" / "stock.vdb").empty());
  CHECK(content(a.path() / "finish" / "stock.png") == pictures.stock_png);
  CHECK(content(a.path() / "finish" / "deviation.png") == pictures.deviation_png);
  CHECK(content(a.path() / "finish" / "perspective.png") == pictures.perspective_png);
  // Of a closed manifold without holes: 2 V - 4 triangles.
  REQUIRE(surface);
  CHECK(surface->triangles == 2 * surface->vertices - 4);
  CHECK(surface->voxel_mm == 1.0);
  CHECK(surface->unmoved_vertices == 0);
  REQUIRE(path_view);
  CHECK(path_view->segments.size() == stage.ran->path->moves.size());
  CHECK(path_view->segments.back().end_s == Approx(stage.ran->machining_time_s));
}

TEST_CASE("pictures of a page are those of the files", "[unit][files][slow]") {
  const tests::TemporaryFolder folder;
  const StageResult stage = stage_with_stock();
  const StagePictures written = write_stage_files(stage, folder.path(), {}).pictures;
  const StagePictures drawn = draw_pictures(stage);
  CHECK(drawn.stock_png == written.stock_png);
  CHECK(drawn.deviation_png == written.deviation_png);
  CHECK(drawn.perspective_png == written.perspective_png);
}

TEST_CASE("the stock's surface is written as far as it was cut, whole, or not at all",
          "[unit][files]") {
  const tests::TemporaryFolder folder;
  const StageResult stage = stage_with_stock();
  const auto size_of = [&](StockSurfaceFile which) -> std::uintmax_t {
    const std::filesystem::path into = folder.path() / std::to_string(static_cast<int>(which));
    const StageFiles files = write_stage_files(stage, into, {.pictures = false, .stock = which});
    // The figures are those of the stock, whatever is written of it.
    REQUIRE(files.surface);
    CHECK(files.surface->triangles == 2 * files.surface->vertices - 4);
    CHECK(std::filesystem::exists(into / "finish" / "stock.vdb"));
    const std::filesystem::path file = into / "finish" / "stock.vtp";
    return std::filesystem::exists(file) ? std::filesystem::file_size(file) : 0;
  };
  const std::uintmax_t cut = size_of(StockSurfaceFile::cut),
                       whole = size_of(StockSurfaceFile::whole);
  // A slot over the length of the block takes a small part of its sides.
  CHECK(cut > 0);
  CHECK(4 * cut < whole);
  CHECK(size_of(StockSurfaceFile::none) == 0);
}

TEST_CASE("pictures can be left out", "[unit][files]") {
  const tests::TemporaryFolder folder;
  write_stage_files(sample_result(Outcome::passed, 3).stages[0], folder.path(),
                    {.pictures = false});
  CHECK(std::filesystem::exists(folder.path() / "rough" / "deviation.vtp"));
  for (const char* name : {"deviation.png", "perspective.png", "stock.png"})
    CHECK_FALSE(std::filesystem::exists(folder.path() / "rough" / name));
}

TEST_CASE("a stage that was not run leaves nothing", "[unit][files]") {
  const tests::TemporaryFolder folder;
  const auto [pictures, surface, path_view, stock_view] =
      write_stage_files(sample_result(Outcome::failed, 3).stages[2], folder.path(), {});
  CHECK(std::filesystem::is_empty(folder.path()));
  CHECK((pictures.deviation_png.empty() && pictures.stock_png.empty() && !surface && !path_view &&
         !stock_view));
}

TEST_CASE("a stage's name never leads out of the folder", "[unit][files]") {
  const tests::TemporaryFolder folder;
  StageResult stage = sample_result(Outcome::passed, 3).stages[0];
  for (const char* name : {"..", ".", "", "../up", "/tmp", "a/b"}) {
    stage.name = name;
    CHECK_THROWS_AS(write_stage_files(stage, folder.path() / "in", {}), std::invalid_argument);
  }
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a folder that cannot be made is out of resources", "[unit][files]") {
  const tests::TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "in the way";
  CHECK_THROWS_AS(
      write_stage_files(sample_result(Outcome::passed, 3).stages[0], folder.path() / "file", {}),
      model::ResourceError);
}
