#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/mesh/triangle_mesh.h"

namespace limitgauge::model {

/// What a mesh file says, triangle by triangle, before its vertices are joined.
struct TriangleSoup {
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Of each triangle, where the file says so: a line from 1, or in binary files the byte from 0.
  std::vector<std::uint64_t> places;
  bool binary = false;
  std::string file;  ///< in errors

  void add(const std::array<std::uint32_t, 3>& triangle, std::uint64_t place) {
    triangles.push_back(triangle);
    places.push_back(place);
  }
};

/// Throws InputError at a place of a mesh file: its line and column, or the byte in a binary one.
[[noreturn]] void fail_at_byte(const std::string& file, std::uint64_t byte,
                               const std::string& wrong, const std::string& expected);

/// Throws InputError at a triangle of the soup, from 0: with its number, and its place.
[[noreturn]] void fail_at_triangle(const TriangleSoup& soup, std::size_t triangle,
                                   const std::string& wrong, const std::string& expected);

/// A mesh, and what was left out of it.
struct MeshReading {
  TriangleMesh mesh;
  std::vector<std::size_t> numbers;  ///< of its triangles in the file, from 0
  /// Triangles two of whose corners are one point: they cover nothing and bound nothing.
  std::size_t dropped_triangles = 0;
};

/// Joins vertices of equal coordinates (bit by bit; -0 is 0), drops triangles with two equal
/// corners and vertices that no triangle uses. Triangles without area of three different corners
/// stay: without them the mesh would not be closed. Corners name vertices of the soup.
MeshReading joined(const TriangleSoup& soup);

/// Joined; throws InputError, with the triangle's number and place, for a mesh that bounds no solid
/// (mesh_defect.h).
MeshReading solid_of(const TriangleSoup& soup);

}  // namespace limitgauge::model
