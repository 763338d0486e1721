#include "reports/vtk/vtp_file.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedIntArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <type_traits>

#include "reports/vtk/vtk_support.h"

namespace limitgauge::reports {
namespace {

template <typename T>
struct ArrayOf;
template <>
struct ArrayOf<float> {
  using type = vtkFloatArray;
};
template <>
struct ArrayOf<double> {
  using type = vtkDoubleArray;
};
template <>
struct ArrayOf<std::int32_t> {
  using type = vtkIntArray;
};
template <>
struct ArrayOf<std::uint32_t> {
  using type = vtkUnsignedIntArray;
};
template <>
struct ArrayOf<std::uint8_t> {
  using type = vtkUnsignedCharArray;
};

/// A negative zero becomes zero: the file states each array's range, and which zero is the lower
/// one depends on the order in which they are met.
template <typename T>
T plain(T value) {
  if constexpr (std::is_floating_point_v<T>) return value + T{0};
  return value;
}

template <typename T>
auto array_of(const std::string& name, std::span<const T> values, int components) {
  vtkNew<typename ArrayOf<T>::type> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::transform(values.begin(), values.end(), array->GetPointer(0), plain<T>);
  return array;
}

template <typename T>
void set_points_of(vtkPolyData& mesh, std::span<const T> xyz) {
  vtkNew<vtkPoints> points;
  points->SetData(array_of("Points", xyz, 3));
  mesh.SetPoints(points);
}

vtkNew<vtkCellArray> cells_of(std::span<const std::int32_t> corners, int size) {
  vtkNew<vtkTypeInt32Array> connectivity, offsets;
  connectivity->SetNumberOfTuples(static_cast<vtkIdType>(corners.size()));
  std::copy(corners.begin(), corners.end(), connectivity->GetPointer(0));
  const vtkIdType count = static_cast<vtkIdType>(corners.size()) / size;
  offsets->SetNumberOfTuples(count + 1);
  for (vtkIdType i = 0; i <= count; ++i) offsets->SetValue(i, static_cast<vtkTypeInt32>(i * size));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  return cells;
}

}  // namespace

struct VtpFile::Data {
  vtkNew<vtkPolyData> mesh;
};

VtpFile::VtpFile() : data_(std::make_unique<Data>()) {}

VtpFile::~VtpFile() = default;

void VtpFile::set_points(std::span<const double> xyz) {
  set_points_of(*data_->mesh, xyz);
}

void VtpFile::set_points(std::span<const float> xyz) {
  set_points_of(*data_->mesh, xyz);
}

void VtpFile::set_lines(std::span<const std::int32_t> corners, int size) {
  data_->mesh->SetLines(cells_of(corners, size));
}

void VtpFile::set_polygons(std::span<const std::int32_t> corners, int size) {
  data_->mesh->SetPolys(cells_of(corners, size));
}

template <typename T>
void VtpFile::add_point_data(const std::string& name, std::span<const T> values) {
  data_->mesh->GetPointData()->AddArray(array_of(name, values, 1));
}

template <typename T>
void VtpFile::add_cell_data(const std::string& name, std::span<const T> values) {
  data_->mesh->GetCellData()->AddArray(array_of(name, values, 1));
}

template void VtpFile::add_point_data(const std::string&, std::span<const float>);
template void VtpFile::add_point_data(const std::string&, std::span<const double>);
template void VtpFile::add_point_data(const std::string&, std::span<const std::int32_t>);
template void VtpFile::add_point_data(const std::string&, std::span<const std::uint32_t>);
template void VtpFile::add_point_data(const std::string&, std::span<const std::uint8_t>);
template void VtpFile::add_cell_data(const std::string&, std::span<const float>);
template void VtpFile::add_cell_data(const std::string&, std::span<const std::int32_t>);
template void VtpFile::add_cell_data(const std::string&, std::span<const std::uint32_t>);
template void VtpFile::add_cell_data(const std::string&, std::span<const std::uint8_t>);

void VtpFile::set_normals(const std::string& name, std::span<const float> xyz) {
  data_->mesh->GetPointData()->SetNormals(array_of(name, xyz, 3));
}

void VtpFile::colour_points_by(const std::string& name) {
  data_->mesh->GetPointData()->SetActiveScalars(name.c_str());
}

void VtpFile::colour_cells_by(const std::string& name) {
  data_->mesh->GetCellData()->SetActiveScalars(name.c_str());
}

void VtpFile::set_facts(std::span<const Fact> facts) {
  add_facts(*data_->mesh->GetFieldData(), facts);
}

void VtpFile::write(const std::filesystem::path& file) const {
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data_->mesh);
  writer->SetIdTypeToInt32();
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  write_xml(*writer, file);
}

}  // namespace limitgauge::reports
