#include "reports/vtk/vtp.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <fstream>

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
  const verifier::DeviationField& field = result.stages[1].ran->deviation.field;
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
  vtkNew<vtkIdList> corners;
  mesh->GetPolys()->GetCellAtId(37, corners);
  REQUIRE(corners->GetNumberOfIds() == 4);
  for (int k = 0; k < 4; ++k) CHECK(corners->GetId(k) == field.quads[37][k]);
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
