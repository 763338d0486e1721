#include "reports/vtk/vtp.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLMultiBlockDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>

#include "model/base/error.h"
#include "reports/run/report.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

/// The file as VTK's own reader sees it.
vtkSmartPointer<vtkPolyData> read_back(const std::filesystem::path& file) {
  vtkNew<vtkXMLPolyDataReader> reader;
  REQUIRE(reader->CanReadFile(file.c_str()));
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// A number of the field data; none where there is no such name.
std::optional<double> number(vtkFieldData* facts, const char* name) {
  vtkDataArray* array = facts->GetArray(name);
  if (!array) return std::nullopt;
  REQUIRE(array->GetNumberOfTuples() == 1);
  return array->GetTuple1(0);
}

std::string text(vtkFieldData* facts, const char* name) {
  auto* array = vtkStringArray::SafeDownCast(facts->GetAbstractArray(name));
  REQUIRE(array);
  REQUIRE(array->GetNumberOfValues() == 1);
  return array->GetValue(0);
}

vtkSmartPointer<vtkMultiBlockDataSet> collection(const std::filesystem::path& file) {
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  REQUIRE(reader->CanReadFile(file.c_str()));
  reader->SetFileName(file.c_str());
  reader->Update();
  return vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
}

std::string block_name(vtkMultiBlockDataSet* parent, unsigned i) {
  return parent->GetMetaData(i)->Get(vtkCompositeDataSet::NAME());
}

std::string content(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  REQUIRE(in);
  return {std::istreambuf_iterator<char>(in), {}};
}

double value(vtkDataSetAttributes* data, const char* name, vtkIdType i) {
  vtkDataArray* array = data->GetArray(name);
  REQUIRE(array);
  return array->GetTuple1(i);
}

}  // namespace

TEST_CASE("VTK reads a toolpath back", "[unit][vtk]") {
  const tests::TemporaryFolder folder;
  const RunResult result = sample_result(Outcome::passed, 3);
  const model::Toolpath& path = *result.stages[2].ran->path;
  write_toolpath_vtp(path, folder.path() / "toolpath.vtp");
  const auto mesh = read_back(folder.path() / "toolpath.vtp");
  REQUIRE(mesh->GetNumberOfPoints() == vtkIdType(path.moves.size() + 1));
  REQUIRE(mesh->GetNumberOfLines() == vtkIdType(path.moves.size()));
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const auto id = static_cast<vtkIdType>(i);
    const double* p = mesh->GetPoint(id + 1);
    CHECK(model::Vec3{p[0], p[1], p[2]} == path.moves[i].to);
    CHECK(value(mesh->GetCellData(), "line", id) == path.moves[i].line);
    CHECK(value(mesh->GetCellData(), "feed_mm_min", id) == path.moves[i].feed_mm_min);
    CHECK(value(mesh->GetCellData(), "kind", id) == double(path.moves[i].kind));
    CHECK(value(mesh->GetCellData(), "move", id) == double(i));
    vtkNew<vtkIdList> ends;
    mesh->GetLines()->GetCellAtId(id, ends);
    CHECK((ends->GetId(0) == id && ends->GetId(1) == id + 1));
  }
}

TEST_CASE("VTK reads what each move removed", "[unit][vtk]") {
  const tests::TemporaryFolder folder;
  const RunResult result = sample_result(Outcome::passed, 3);
  const model::Toolpath& path = *result.stages[2].ran->path;
  std::vector<simulator::MoveRemoval> removal;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const double n = double(i);
    removal.push_back({0.5 * n, 3 * n, 0.25 * n, 0.125 * n});
  }
  write_toolpath_vtp(path, folder.path() / "toolpath.vtp", removal);
  const auto mesh = read_back(folder.path() / "toolpath.vtp");
  vtkCellData* data = mesh->GetCellData();
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const auto id = static_cast<vtkIdType>(i);
    CHECK(value(data, "line", id) == path.moves[i].line);
    CHECK(value(data, "removed_volume_mm3", id) == removal[i].volume_mm3);
    CHECK(value(data, "removal_rate_mm3_min", id) == removal[i].rate_mm3_min);
    CHECK(value(data, "axial_engagement_mm", id) == removal[i].axial_mm);
    CHECK(value(data, "radial_engagement_mm", id) == removal[i].radial_mm);
  }
  // Figures for other moves than these would colour the wrong ones: they are left out.
  removal.pop_back();
  write_toolpath_vtp(path, folder.path() / "other.vtp", removal);
  CHECK_FALSE(
      read_back(folder.path() / "other.vtp")->GetCellData()->HasArray("removal_rate_mm3_min"));
}

TEST_CASE("VTK reads a deviation field back", "[unit][vtk]") {
  const tests::TemporaryFolder folder;
  // 43,320 samples: more than one compressed block an array.
  const RunResult result = sample_result(Outcome::failed, 38);
  const verifier::DeviationField& field = result.stages[1].ran->deviation->field;
  write_deviation_vtp(field, folder.path() / "deviation.vtp");
  const auto mesh = read_back(folder.path() / "deviation.vtp");
  REQUIRE(mesh->GetNumberOfPoints() == vtkIdType(field.samples.size()));
  REQUIRE(mesh->GetNumberOfPolys() == vtkIdType(field.quads.size()));
  vtkPointData* data = mesh->GetPointData();
  for (std::size_t i = 0; i < field.samples.size(); i += 97) {
    const auto& s = field.samples[i];
    const auto id = static_cast<vtkIdType>(i);
    CHECK(value(data, "deviation_mm", id) == s.deviation_mm);
    CHECK(value(data, "uncut_mm", id) - value(data, "gouge_mm", id) == s.deviation_mm);
    CHECK(std::min(value(data, "uncut_mm", id), value(data, "gouge_mm", id)) == 0);
    CHECK(value(data, "reachable", id) == double(s.reachable));
    CHECK(value(data, "patch", id) == s.place.patch);
    CHECK(value(data, "u", id) == s.place.u);
    CHECK(value(data, "v", id) == s.place.v);
    CHECK(mesh->GetPoint(id)[2] == s.place.point.z);
  }
  REQUIRE(data->GetScalars());
  CHECK(data->GetScalars()->GetName() == std::string("deviation_mm"));
  vtkNew<vtkIdList> corners;
  mesh->GetPolys()->GetCellAtId(37, corners);
  REQUIRE(corners->GetNumberOfIds() == 4);
  for (int k = 0; k < 4; ++k) CHECK(corners->GetId(k) == field.quads[37][k]);
}

TEST_CASE("the active normals are unit vectors on the machining side", "[unit][vtk]") {
  const tests::TemporaryFolder folder;
  const RunResult result = sample_result(Outcome::passed, 9);
  const verifier::DeviationField& field = result.stages[2].ran->deviation->field;
  write_deviation_vtp(field, folder.path() / "deviation.vtp");
  const auto mesh = read_back(folder.path() / "deviation.vtp");
  vtkDataArray* normals = mesh->GetPointData()->GetNormals();
  REQUIRE(normals);
  CHECK(normals->GetName() == std::string("normal"));
  REQUIRE(normals->GetNumberOfTuples() == vtkIdType(field.samples.size()));
  for (const auto& quad : field.quads) {
    // The diagonals' cross product is what the corners, counter-clockwise, say of the side.
    const auto at = [&](int k) { return field.samples[quad[k]].place.point; };
    const model::Vec3 side = model::normalized(model::cross(at(2) - at(0), at(3) - at(1)));
    for (int k = 0; k < 4; ++k) {
      const double* n = normals->GetTuple3(quad[k]);
      const model::Vec3 normal{n[0], n[1], n[2]};
      CHECK(model::length(normal) == Approx(1).margin(1e-6));  // single precision
      CHECK(model::dot(normal, side) > 0.9);
    }
  }
}

TEST_CASE("field data holds the stage's target, its stated limits and its verdict", "[unit][vtk]") {
  const tests::TemporaryFolder folder;
  StageResult stage = sample_result(Outcome::failed, 3).stages[1];
  stage.name = "semi: Ü & <2>";
  verifier::GateLimits& l = stage.limits;
  l = {};
  l.has_gouge = true, l.gouge_mm = 0.0125;
  l.has_unreachable = true, l.unreachable_is_share = false, l.unreachable = 17.5;
  write_deviation_vtp(stage.ran->deviation->field, folder.path() / "a.vtp", stage_facts(stage));
  const auto first = read_back(folder.path() / "a.vtp");
  vtkFieldData* facts = first->GetFieldData();
  CHECK(text(facts, "stage") == stage.name);
  CHECK(text(facts, "tool") == stage.tool);
  CHECK(text(facts, "verdict") == "fail");
  CHECK(text(facts, "units") == "mm");
  CHECK(number(facts, "allowance_mm") == stage.allowance_mm);
  CHECK(number(facts, "gouge_limit_mm") == 0.0125);
  CHECK(number(facts, "unreachable_limit_mm2") == 17.5);
  for (const char* name :
       {"uncut_limit_mm", "coverage_limit", "unreachable_limit", "unavoidable_limit_mm"})
    CHECK_FALSE(number(facts, name));
  l.has_uncut = true, l.uncut_mm = 0.03;
  l.has_coverage = true, l.coverage = 0.97;
  l.unreachable_is_share = true, l.unreachable = 0.05;
  l.has_unavoidable = true, l.unavoidable_mm = 0.3;
  write_toolpath_vtp(*stage.ran->path, folder.path() / "b.vtp", {}, stage_facts(stage));
  const auto second = read_back(folder.path() / "b.vtp");
  CHECK(second->GetCellData()->GetScalars()->GetName() == std::string("feed_mm_min"));
  facts = second->GetFieldData();
  CHECK(number(facts, "uncut_limit_mm") == 0.03);
  CHECK(number(facts, "coverage_limit") == 0.97);
  CHECK(number(facts, "unreachable_limit") == 0.05);
  CHECK(number(facts, "unavoidable_limit_mm") == 0.3);
  CHECK_FALSE(number(facts, "unreachable_limit_mm2"));
}

TEST_CASE("one file opens all stages of a run", "[unit][vtk]") {
  const tests::TemporaryFolder folder;
  RunResult result = sample_result(Outcome::failed, 3);  // the third stage was not run
  // Names that XML must escape, and that VTK's writer would take for its own folder of leaves.
  result.stages[0].name = "rough & <Ü>", result.stages[1].name = "stages";
  for (const StageResult& stage : result.stages)
    write_stage_files(stage, folder.path(), {.pictures = false});
  write_stages_vtm(result, folder.path());
  const auto stages = collection(folder.path() / "stages.vtm");
  REQUIRE(stages);
  REQUIRE(stages->GetNumberOfBlocks() == 2);
  for (unsigned i = 0; i < 2; ++i) {
    CHECK(block_name(stages, i) == result.stages[i].name);
    auto* block = vtkMultiBlockDataSet::SafeDownCast(stages->GetBlock(i));
    REQUIRE(block);
    REQUIRE(block->GetNumberOfBlocks() == 2);  // the sample has no stock
    CHECK(block_name(block, 0) == "deviation");
    CHECK(block_name(block, 1) == "toolpath");
    auto* surface = vtkPolyData::SafeDownCast(block->GetBlock(0));
    REQUIRE(surface);
    const auto& samples = result.stages[i].ran->deviation->field.samples;
    REQUIRE(surface->GetNumberOfPoints() == vtkIdType(samples.size()));
    CHECK(value(surface->GetPointData(), "deviation_mm", 5) == samples[5].deviation_mm);
    CHECK(text(surface->GetFieldData(), "stage") == result.stages[i].name);
  }
  CHECK(text(stages->GetFieldData(), "verdict") == "fail");
  CHECK(std::filesystem::is_directory(folder.path() / "stages"));
}

TEST_CASE("the file of all stages leaves nothing beside it and is the same every time",
          "[unit][vtk]") {
  const tests::TemporaryFolder a, b;
  const RunResult result = sample_result(Outcome::passed, 3);
  for (const auto* folder : {&a, &b}) {
    write_stages_vtm(result, folder->path());
    CHECK(std::filesystem::is_empty(folder->path()));  // no stage has a file
    for (const StageResult& stage : result.stages)
      write_stage_files(stage, folder->path(), {.pictures = false});
    write_stages_vtm(result, folder->path());
    CHECK_FALSE(std::filesystem::exists(folder->path() / "stages"));
  }
  CHECK(content(a.path() / "stages.vtm") == content(b.path() / "stages.vtm"));
}

TEST_CASE("VTK reads a stock surface back", "[unit][vtk]") {
  const tests::TemporaryFolder folder;
  const simulator::StockMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2.5}},
                                         {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  write_stock_vtp(tetrahedron, folder.path() / "stock.vtp");
  const auto mesh = read_back(folder.path() / "stock.vtp");
  REQUIRE(mesh->GetNumberOfPoints() == 4);
  REQUIRE(mesh->GetNumberOfPolys() == 4);
  CHECK(mesh->GetPoint(3)[2] == 2.5);
}

TEST_CASE("a file names the compressor that every reader knows, and is compressed", "[unit][vtk]") {
  const tests::TemporaryFolder folder;
  simulator::StockMesh mesh;
  for (std::uint32_t k = 0; k < 300000; ++k)
    mesh.vertices.push_back({0.1 * k, 0.25 * (k % 7), 1.0 * (k / 1000)});
  for (std::uint32_t k = 0; k + 2 < 300000; ++k) mesh.triangles.push_back({k, k + 1, k + 2});
  const auto file = folder.path() / "stock.vtp";
  write_stock_vtp(mesh, file);
  const auto read = read_back(file);
  REQUIRE(read->GetNumberOfPoints() == 300000);
  for (const vtkIdType k : {0, 1, 65536, 299999}) {
    CHECK(read->GetPoint(k)[0] == Approx(0.1 * static_cast<double>(k)));
    CHECK(read->GetPoint(k)[2] == static_cast<double>(k / 1000));
  }
  std::ifstream in(file, std::ios::binary);
  std::string head(1000, '\0');
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  CHECK(head.find("compressor=\"vtkZLibDataCompressor\"") != std::string::npos);
  // Plain, the points and the corners alone are 7.2 MB.
  CHECK(std::filesystem::file_size(file) < 3'600'000);
}

TEST_CASE("empty data makes a file that VTK reads", "[unit][vtk]") {
  const tests::TemporaryFolder folder;
  write_toolpath_vtp({}, folder.path() / "a.vtp");
  CHECK(read_back(folder.path() / "a.vtp")->GetNumberOfPoints() == 1);
  write_deviation_vtp({}, folder.path() / "b.vtp");
  CHECK(read_back(folder.path() / "b.vtp")->GetNumberOfPoints() == 0);
}

TEST_CASE("a file that cannot be written is out of resources", "[unit][vtk]") {
  CHECK_THROWS_AS(write_toolpath_vtp({}, "/nonexistent/folder/toolpath.vtp"), model::ResourceError);
}

TEST_CASE("a full disk is out of resources and leaves nothing", "[unit][vtk]") {
  const tests::TemporaryFolder folder;
  const std::filesystem::path full = folder.path() / "deviation.vtp";
  std::filesystem::create_symlink("/dev/full", full);
  const RunResult result = sample_result(Outcome::passed, 9);
  try {
    write_deviation_vtp(result.stages[2].ran->deviation->field, full);
    FAIL("was written");
  } catch (const model::ResourceError& error) {
    CHECK(std::string(error.what()).find("deviation.vtp") != std::string::npos);
    CHECK(std::string(error.what()).find("No space left") != std::string::npos);
  }
  CHECK_FALSE(std::filesystem::is_symlink(full));
  CHECK(std::filesystem::exists("/dev/full"));
}
