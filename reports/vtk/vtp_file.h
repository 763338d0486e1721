#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace limitgauge::reports {

/// A VTK PolyData file (.vtp) in the making: XML with zlib-compressed raw appended data, as VTK's
/// own writer would make it. Arrays are copied in by the add functions; write() puts out the file.
class VtpFile {
 public:
  VtpFile(std::size_t points, std::size_t lines, std::size_t polygons);

  void add_points(std::span<const double> xyz) { add(points_, "Points", 3, xyz); }
  void add_points(std::span<const float> xyz) { add(points_, "Points", 3, xyz); }
  /// `ends` holds for each line (or polygon) where it ends in `corners`.
  void add_lines(std::span<const std::int32_t> corners, std::span<const std::int32_t> ends);
  void add_polygons(std::span<const std::int32_t> corners, std::span<const std::int32_t> ends);
  template <typename T>
  void add_point_data(const std::string& name, std::span<const T> values, int components = 1) {
    add(point_data_, name, components, values);
  }
  template <typename T>
  void add_cell_data(const std::string& name, std::span<const T> values) {
    add(cell_data_, name, 1, values);
  }
  /// Throws model::ResourceError when the file cannot be written.
  void write(const std::filesystem::path& file) const;

 private:
  template <typename T>
  void add(std::string& section, const std::string& name, int components,
           std::span<const T> values);

  std::size_t point_count_, line_count_, polygon_count_;
  std::string points_, lines_, polygons_, point_data_, cell_data_;  ///< XML of each section
  std::vector<std::uint8_t> appended_;
};

}  // namespace limitgauge::reports
