#pragma once
// Meshes as the bytes of a file.

#include <algorithm>
#include <array>
#include <bit>
#include <string>

#include "model/mesh/triangle_mesh.h"
#include "model/text/number_text.h"

namespace limitgauge::model::test {

template <class T>
void put(std::string& out, T value, std::endian order) {
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  out.append(raw.begin(), raw.end());
}

inline std::string binary_stl(const TriangleMesh& mesh, const std::string& header = "a test") {
  std::string out = header;
  out.resize(80, ' ');
  put(out, static_cast<std::uint32_t>(mesh.triangles.size()), std::endian::little);
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) put(out, 0.0F, std::endian::little);
    for (const std::uint32_t v : t)
      for (int a = 0; a < 3; ++a)
        put(out, static_cast<float>(mesh.vertices[v][a]), std::endian::little);
    put(out, std::uint16_t{0}, std::endian::little);
  }
  return out;
}

inline std::string numbers(const Vec3& p) {
  return shortest(p.x) + " " + shortest(p.y) + " " + shortest(p.z);
}

inline std::string ascii_stl(const TriangleMesh& mesh) {
  std::string out = "solid a test\n";
  for (const auto& t : mesh.triangles) {
    out += "facet normal 0 0 0\n outer loop\n";
    for (const std::uint32_t v : t) out += "  vertex " + numbers(mesh.vertices[v]) + "\n";
    out += " endloop\nendfacet\n";
  }
  return out + "endsolid a test\n";
}

inline std::string obj(const TriangleMesh& mesh) {
  std::string out = "# a test\no part\n";
  for (const Vec3& v : mesh.vertices) out += "v " + numbers(v) + "\n";
  for (const auto& t : mesh.triangles)
    out += "f " + std::to_string(t[0] + 1) + "/1/1 " + std::to_string(t[1] + 1) + "//1 " +
           std::to_string(t[2] + 1) + "\n";
  return out;
}

inline std::string ply_header(const TriangleMesh& mesh, const std::string& format) {
  return "ply\nformat " + format + " 1.0\ncomment a test\nelement vertex " +
         std::to_string(mesh.vertices.size()) +
         "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\n"
         "element face " +
         std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

inline std::string ascii_ply(const TriangleMesh& mesh) {
  std::string out = ply_header(mesh, "ascii");
  for (const Vec3& v : mesh.vertices) out += numbers(v) + " 255\n";
  for (const auto& t : mesh.triangles)
    out += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
           "\n";
  return out;
}

inline std::string binary_ply(const TriangleMesh& mesh, std::endian order) {
  std::string out =
      ply_header(mesh, order == std::endian::little ? "binary_little_endian" : "binary_big_endian");
  for (const Vec3& v : mesh.vertices) {
    for (int a = 0; a < 3; ++a) put(out, v[a], order);
    put(out, std::uint8_t{255}, order);
  }
  for (const auto& t : mesh.triangles) {
    put(out, std::uint8_t{3}, order);
    for (const std::uint32_t v : t) put(out, static_cast<std::int32_t>(v), order);
  }
  return out;
}

}  // namespace limitgauge::model::test
