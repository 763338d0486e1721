#include "reports/vtk/toolpath_reader.h"

#include <array>
#include <stdexcept>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "model/base/coordinate_limit.h"
#include "model/base/error.h"
#include "model/base/text_file.h"
#include "reports/vtk/vtk_support.h"

namespace limitgauge::reports {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& wrong) {
  throw model::InputError({file.string(), 0, 0}, wrong, "a toolpath.vtp as limitgauge writes it");
}

/// The array of that name with a value a move.
vtkDataArray& column_of(vtkPolyData& data, const char* name, const std::filesystem::path& file) {
  vtkDataArray* const array = data.GetCellData()->GetArray(name);
  if (array == nullptr || array->GetNumberOfComponents() != 1 ||
      array->GetNumberOfTuples() != data.GetNumberOfLines())
    refuse(file, std::string("has no \"") + name + "\" for each move");
  return *array;
}

/// The tip's places, one more than there are moves, in double precision.
vtkPoints& places_of(vtkPolyData& data, const std::filesystem::path& file) {
  vtkPoints* const points = data.GetPoints();
  if (points == nullptr || points->GetDataType() != VTK_DOUBLE)
    refuse(file, "has no places in double precision");
  if (points->GetNumberOfPoints() != data.GetNumberOfLines() + 1)
    refuse(file, "has not one place more than moves");
  return *points;
}

model::Vec3 place(vtkPoints& points, vtkIdType i, const std::filesystem::path& file) {
  double xyz[3];
  points.GetPoint(i, xyz);
  const model::Vec3 at{xyz[0], xyz[1], xyz[2]};
  if (!model::is_near(at)) refuse(file, "has a place too far from zero");
  return at;
}

/// One at each place, where the file has them.
std::optional<model::ToolAxes> axes_of(vtkPolyData& data, const model::Toolpath& path,
                                       const std::filesystem::path& file) {
  if (!data.GetPointData()->HasArray(kAxisColumns[0])) return std::nullopt;
  std::array<vtkDataArray*, 3> columns{};
  for (std::size_t k = 0; k < 3; ++k) {
    columns[k] = data.GetPointData()->GetArray(kAxisColumns[k]);
    if (columns[k] == nullptr || columns[k]->GetNumberOfComponents() != 1 ||
        columns[k]->GetNumberOfTuples() != data.GetNumberOfPoints())
      refuse(file, std::string("has no \"") + kAxisColumns[k] + "\" at each place");
  }
  model::ToolAxes axes;
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
    const model::Vec3 axis{columns[0]->GetTuple1(i), columns[1]->GetTuple1(i),
                           columns[2]->GetTuple1(i)};
    if (i == 0) axes.start = axis;
    if (i > 0) axes.to.push_back(axis);
  }
  try {
    require_axes(path, axes);
  } catch (const std::invalid_argument& wrong) {
    refuse(file, wrong.what());
  }
  return axes;
}

}  // namespace

ToolpathRead read_toolpath_vtp(const std::filesystem::path& file) {
  model::require_file(file);
  const QuietVtk quiet;
  const vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* const data = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || data == nullptr) refuse(file, "cannot be read");
  vtkPoints& points = places_of(*data, file);
  vtkDataArray& lines = column_of(*data, "line", file);
  vtkDataArray& kinds = column_of(*data, "kind", file);
  vtkDataArray& feeds = column_of(*data, "feed_mm_min", file);
  model::Toolpath path;
  path.start = place(points, 0, file);
  const vtkIdType count = data->GetNumberOfLines();
  path.moves.reserve(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i) {
    const auto kind = kinds.GetTuple1(i) == 0 ? model::MoveKind::rapid : model::MoveKind::feed;
    path.moves.emplace_back(place(points, i + 1, file), static_cast<float>(feeds.GetTuple1(i)),
                            static_cast<std::uint32_t>(lines.GetTuple1(i)), kind);
  }
  auto axes = axes_of(*data, path, file);
  return {std::move(path), std::move(axes)};
}

}  // namespace limitgauge::reports
