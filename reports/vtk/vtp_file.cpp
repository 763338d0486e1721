#include "reports/vtk/vtp_file.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <type_traits>

#include "model/base/error.h"

namespace limitgauge::reports {
namespace {

static_assert(std::endian::native == std::endian::little, "the header says LittleEndian");

constexpr std::size_t kBlockBytes = 1 << 18;

template <typename T>
constexpr const char* vtk_type() {
  if constexpr (std::is_same_v<T, float>) return "Float32";
  if constexpr (std::is_same_v<T, double>) return "Float64";
  if constexpr (std::is_same_v<T, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<T, std::uint32_t>) return "UInt32";
  if constexpr (std::is_same_v<T, std::uint8_t>) return "UInt8";
}

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> block) {
  uLongf size = compressBound(block.size());
  std::vector<std::uint8_t> out(size);
  // Level 1: toolpaths and meshes are large, and a level more saves a few percent for twice the
  // time.
  if (compress2(out.data(), &size, block.data(), block.size(), 1) != Z_OK)
    throw model::ResourceError("zlib could not compress a block");
  out.resize(size);
  return out;
}

/// vtkZLibDataCompressor's layout: number of blocks, block size, size of the last block where it is
/// shorter, compressed sizes, then the blocks.
void append_compressed(std::vector<std::uint8_t>& out, std::span<const std::uint8_t> bytes) {
  const std::size_t blocks = (bytes.size() + kBlockBytes - 1) / kBlockBytes;
  std::vector<std::uint64_t> header{blocks, kBlockBytes, bytes.size() % kBlockBytes};
  std::vector<std::uint8_t> data;
  for (std::size_t i = 0; i < blocks; ++i) {
    const std::size_t from = i * kBlockBytes;
    const auto packed = deflated(bytes.subspan(from, std::min(kBlockBytes, bytes.size() - from)));
    header.push_back(packed.size());
    data.insert(data.end(), packed.begin(), packed.end());
  }
  const auto* head = reinterpret_cast<const std::uint8_t*>(header.data());
  out.insert(out.end(), head, head + header.size() * sizeof(header[0]));
  out.insert(out.end(), data.begin(), data.end());
}

std::string section(const char* tag, const std::string& content) {
  return std::string("<").append(tag).append(">\n").append(content).append("</").append(tag).append(
      ">\n");
}

}  // namespace

VtpFile::VtpFile(std::size_t points, std::size_t lines, std::size_t polygons)
    : point_count_(points), line_count_(lines), polygon_count_(polygons) {}

template <typename T>
void VtpFile::add(std::string& xml, const std::string& name, int components,
                  std::span<const T> values) {
  xml.append("<DataArray type=\"").append(vtk_type<T>()).append("\" Name=\"").append(name);
  xml.append("\" NumberOfComponents=\"").append(std::to_string(components));
  xml.append("\" format=\"appended\" offset=\"").append(std::to_string(appended_.size()));
  xml.append("\"/>\n");
  append_compressed(appended_,
                    {reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()});
}

template void VtpFile::add(std::string&, const std::string&, int, std::span<const float>);
template void VtpFile::add(std::string&, const std::string&, int, std::span<const double>);
template void VtpFile::add(std::string&, const std::string&, int, std::span<const std::int32_t>);
template void VtpFile::add(std::string&, const std::string&, int, std::span<const std::uint32_t>);
template void VtpFile::add(std::string&, const std::string&, int, std::span<const std::uint8_t>);

void VtpFile::add_lines(std::span<const std::int32_t> corners, std::span<const std::int32_t> ends) {
  add(lines_, "connectivity", 1, corners);
  add(lines_, "offsets", 1, ends);
}

void VtpFile::add_polygons(std::span<const std::int32_t> corners,
                           std::span<const std::int32_t> ends) {
  add(polygons_, "connectivity", 1, corners);
  add(polygons_, "offsets", 1, ends);
}

void VtpFile::write(const std::filesystem::path& file) const {
  std::ofstream out(file, std::ios::binary);
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n"
      << "<Piece NumberOfPoints=\"" << point_count_ << "\" NumberOfVerts=\"0\" NumberOfLines=\""
      << line_count_ << "\" NumberOfStrips=\"0\" NumberOfPolys=\"" << polygon_count_ << "\">\n"
      << section("PointData", point_data_) << section("CellData", cell_data_)
      << section("Points", points_) << section("Lines", lines_) << section("Polys", polygons_)
      << "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  out.write(reinterpret_cast<const char*>(appended_.data()),
            static_cast<std::streamsize>(appended_.size()));
  out << "\n</AppendedData>\n</VTKFile>\n";
  out.close();
  if (!out) throw model::ResourceError("cannot write " + file.string());
}

}  // namespace limitgauge::reports
