#include "reports/record/stock_record.h"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "model/base/error.h"
#include "reports/run/report.h"
#include "reports/vtk/toolpath_reader.h"
#include "reports/vtk/vtp.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::reports::record {
namespace {

using StockJson = nlohmann::json;

std::string stock_text_of(const RunResult& result) {
  std::ostringstream out;
  write_result_json(result, out);
  return out.str();
}

StockRecord stock_of(const std::string& text) {
  std::istringstream in(text);
  return read_stock_record(in, "r.json");
}

/// What is said of the sample once `value` stands at `where`, a JSON pointer.
std::string stock_error(const std::string& where, const StockJson& value) {
  StockJson tree = StockJson::parse(stock_text_of(cut_result()));
  tree[StockJson::json_pointer(where)] = value;
  try {
    stock_of(tree.dump());
  } catch (const model::InputError& error) {
    return error.what();
  }
  return "none";
}

TEST_CASE("a result says what it was cut with, to the last bit", "[unit][stock_record]") {
  for (RunResult result : {sample_result(Outcome::passed, 3), cut_result()}) {
    result.stages[0].cutter.diameter_mm = 12.1;
    const StockRecord record = stock_of(stock_text_of(result));
    CHECK(record.job == result.job);
    REQUIRE(record.stages.size() == result.stages.size());
    for (std::size_t i = 0; i < record.stages.size(); ++i) {
      const StageResult& stage = result.stages[i];
      REQUIRE(record.stages[i].ran == stage.ran.has_value());
      CHECK(record.stages[i].name == stage.name);
      if (!stage.ran) continue;
      CHECK(record.stages[i].moves == stage.ran->path->moves.size());
      CHECK(record.stages[i].chord_error_mm == stage.ran->path->chord_error_mm);
      CHECK(record.stages[i].cutter.diameter_mm == stage.cutter.diameter_mm);
      CHECK(record.stages[i].cutter.corner_radius_mm == stage.cutter.corner_radius_mm);
      CHECK(record.stages[i].cutter.flute_length_mm == stage.cutter.flute_length_mm);
    }
  }
}

TEST_CASE("raw stock of every shape is read back", "[unit][stock_record]") {
  RunResult result = cut_result();
  result.raw_stock = model::BoxStock{{-1.1, 2, 3}, {4, 5.3, 6}};
  const StockRecord box = stock_of(stock_text_of(result));
  CHECK(std::get<model::BoxStock>(box.raw).corner_mm == model::Vec3{-1.1, 2, 3});
  CHECK(std::get<model::BoxStock>(box.raw).size_mm == model::Vec3{4, 5.3, 6});
  result.raw_stock = model::CylinderStock{{1, 2, 3}, 40.1, 20};
  const StockRecord bar = stock_of(stock_text_of(result));
  CHECK(std::get<model::CylinderStock>(bar.raw).diameter_mm == 40.1);
  StockJson tree = StockJson::parse(stock_text_of(result));
  tree["stock"] = {{"shape", "mesh"},         {"file", "a.stl"},         {"triangles", 12},
                   {"corner_mm", {0, 0, -1}}, {"size_mm", {10, 20, 30}}, {"volume_mm3", 6000}};
  const StockRecord mesh = stock_of(tree.dump());
  const auto& file = std::get<StockFileRecord>(mesh.raw);
  CHECK(file.file == "a.stl");
  CHECK_FALSE(file.is_vdb);
  CHECK(file.box_mm.high == model::Vec3{10, 20, 29});
}

TEST_CASE("a result that makes no stock is refused with its place", "[unit][stock_record]") {
  CHECK_THAT(stock_error("/schema", "limitgauge.result/1"),
             ContainsSubstring("schema is another one"));
  CHECK_THAT(stock_error("/stock/size_mm/0", 0), ContainsSubstring("r.json: error: stock is none"));
  CHECK_THAT(stock_error("/stock/shape", "ring"), ContainsSubstring("stock.shape"));
  CHECK_THAT(stock_error("/stages/0/cutter/type", "saw"),
             ContainsSubstring("stages[0].cutter.type"));
  CHECK_THAT(stock_error("/stages/0/cutter/diameter_mm", -1),
             ContainsSubstring("stages[0].cutter.diameter_mm"));
  CHECK_THAT(stock_error("/stages/0/cutter/corner_radius_mm", 1e5),
             ContainsSubstring("stages[0].cutter"));
  CHECK_THAT(stock_error("/stages/0/toolpath/moves", -3),
             ContainsSubstring("stages[0].toolpath.moves"));
  CHECK_THAT(stock_error("/stages/0/toolpath/chord_error_mm", "x"),
             ContainsSubstring("stages[0].toolpath.chord_error_mm is a text"));
}

TEST_CASE("moves are read back to the last bit", "[unit][stock_record]") {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "toolpath.vtp";
  model::Toolpath path;
  path.start = {0.1, -1.0 / 3, 1e-7};
  path.moves.emplace_back(model::Vec3{1234.000000000123, 2.0 / 3, -9.87654321012345e-9}, 0.F, 7,
                          model::MoveKind::rapid);
  path.moves.emplace_back(model::Vec3{-0.30000000000000004, 1e-300, 5}, 333.3F, 12,
                          model::MoveKind::feed);
  write_toolpath_vtp(path, file);
  const model::Toolpath read = read_toolpath_vtp(file).path;
  CHECK(read.start == path.start);
  REQUIRE(read.moves.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(read.moves[i].to == path.moves[i].to);
    CHECK(read.moves[i].line == path.moves[i].line);
    CHECK(read.moves[i].kind == path.moves[i].kind);
    CHECK(read.moves[i].feed_mm_min == path.moves[i].feed_mm_min);
  }
}

TEST_CASE("a toolpath.vtp of a tool that turns says how it stands", "[unit][stock_record]") {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "toolpath.vtp";
  model::Toolpath path;
  path.moves.resize(2);
  path.moves[1].to = {1, 2, 3};
  const model::ToolAxes axes{{0.6, 0, 0.8}, {{0, 0.6, 0.8}, {1.0 / 3, 2.0 / 3, 2.0 / 3}}};
  write_toolpath_vtp(path, file, {}, {}, &axes);
  const ToolpathRead read = read_toolpath_vtp(file);
  REQUIRE(read.axes.has_value());
  CHECK(read.axes->start == axes.start);
  CHECK(read.axes->to == axes.to);
  write_toolpath_vtp(path, file);
  CHECK_FALSE(read_toolpath_vtp(file).axes.has_value());
  const model::ToolAxes wrong{{0, 0, 1}, {{0, 0, 2}, {0, 0, 1}}};
  write_toolpath_vtp(path, file, {}, {}, &wrong);
  CHECK_THROWS_AS(read_toolpath_vtp(file), model::InputError);
}

TEST_CASE("what is no toolpath is refused", "[unit][stock_record]") {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "toolpath.vtp";
  CHECK_THROWS_AS(read_toolpath_vtp(file), model::InputError);
  std::ofstream(file) << "no XML";
  CHECK_THROWS_AS(read_toolpath_vtp(file), model::InputError);
  std::ofstream(file) << "<VTKFile type=\"PolyData\" version=\"1.0\"><PolyData/></VTKFile>";
  CHECK_THROWS_AS(read_toolpath_vtp(file), model::InputError);
}

}  // namespace
}  // namespace limitgauge::reports::record
