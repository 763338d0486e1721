#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "reports/vtk/stage_facts.h"

namespace limitgauge::reports {

/// A VTK PolyData file (.vtp) in the making, written by VTK's own writer: compressed raw appended
/// data. Arrays are copied in; write() puts out the file. The same data gives the same bytes.
class VtpFile {
 public:
  VtpFile();
  ~VtpFile();
  VtpFile(const VtpFile&) = delete;
  VtpFile& operator=(const VtpFile&) = delete;

  /// xyz of each point, mm; three values a point.
  void set_points(std::span<const double> xyz);
  void set_points(std::span<const float> xyz);
  /// Cells of `size` corners each, one after another in `corners`.
  void set_lines(std::span<const std::int32_t> corners, int size);
  void set_polygons(std::span<const std::int32_t> corners, int size);
  /// T: float, double, std::int32_t, std::uint32_t or std::uint8_t.
  template <typename T>
  void add_point_data(const std::string& name, std::span<const T> values);
  template <typename T>
  void add_cell_data(const std::string& name, std::span<const T> values);
  /// Unit vectors at the points, three values a point: the file's active normals.
  void set_normals(const std::string& name, std::span<const float> xyz);
  /// The array, added before, that viewers colour by until they are told otherwise.
  void colour_points_by(const std::string& name);
  void colour_cells_by(const std::string& name);
  void set_facts(std::span<const Fact> facts);

  /// Throws model::ResourceError when the file cannot be written; nothing of it is left then.
  void write(const std::filesystem::path& file) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace limitgauge::reports
