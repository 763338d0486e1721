#include "model/mesh/mesh_polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/base/error.h"

namespace limitgauge::model {
namespace {

/// Newell's normal: twice the vector area. About the first corner, so that nothing cancels.
Vec3 vector_area(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices) {
  const Vec3& o = vertices[corners[0]];
  Vec3 sum;
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    sum += cross(vertices[corners[k]] - o, vertices[corners[k + 1]] - o);
  return sum;
}

bool is_plane(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices,
              const Vec3& normal) {
  Vec3 middle;
  for (const std::uint32_t v : corners) middle += vertices[v];
  middle = middle / static_cast<double>(corners.size());
  for (const std::uint32_t v : corners)
    if (!(std::abs(dot(vertices[v] - middle, normal)) <= kPlanarity_mm)) return false;
  return true;
}

/// Whether corners without a vector area lie on one line; else the polygon crosses itself.
bool is_on_a_line(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices) {
  const Vec3& o = vertices[corners[0]];
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    if (length(cross(vertices[corners[k]] - o, vertices[corners[k + 1]] - o)) > 0) return false;
  return true;
}

/// The fan about corner `about`; false where a triangle faces away from `normal`, or, if
/// `strictly`, has its corners on one line.
bool fan_about(std::size_t about, std::span<const std::uint32_t> corners,
               const std::vector<Vec3>& vertices, const Vec3& normal, bool strictly,
               PolygonFan& fan) {
  fan.triangles.clear();
  const std::size_t n = corners.size();
  const std::uint32_t apex = corners[about];
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const std::uint32_t b = corners[(about + k) % n], c = corners[(about + k + 1) % n];
    const Vec3 facing = cross(vertices[b] - vertices[apex], vertices[c] - vertices[apex]);
    const double towards = dot(facing, normal);
    if (strictly ? !(towards > 0) : towards < 0) return false;
    fan.triangles.push_back({apex, b, c});
  }
  return true;
}

[[noreturn]] void fail(const PolygonSoup& soup, std::size_t polygon, const std::string& wrong,
                       const std::string& expected) {
  const std::string what = "face " + std::to_string(polygon + 1) + ": " + wrong;
  if (soup.binary) fail_at_byte(soup.file, soup.places[polygon], what, expected);
  throw InputError({soup.file, static_cast<int>(soup.places[polygon])}, what, expected);
}

void check_corners(const PolygonSoup& soup, std::size_t polygon,
                   std::span<const std::uint32_t> corners) {
  for (const std::uint32_t v : corners)
    if (v >= soup.vertices.size())
      fail(soup, polygon, "a corner names a vertex that does not exist",
           "one of the " + std::to_string(soup.vertices.size()) + " vertices");
}

}  // namespace

PolygonFan fan_of(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices) {
  PolygonFan fan;
  if (corners.size() == 3) {
    fan.triangles.push_back({corners[0], corners[1], corners[2]});
    return fan;
  }
  // Where the corners lie on a line, any fan will do.
  const Vec3 normal = normalized(vector_area(corners, vertices));
  if (normal == Vec3{} && !is_on_a_line(corners, vertices)) {
    fan.wrong = "a polygon crosses itself";
    return fan;
  }
  if (!is_plane(corners, vertices, normal)) {
    fan.wrong = "the corners of a polygon are more than 0.001 mm off a plane";
    return fan;
  }
  // A polygon of many corners that no fan covers must not take quadratic time.
  constexpr std::size_t kMostTries = 64;
  for (const bool strictly : {true, false})
    for (std::size_t about = 0; about < std::min(corners.size(), kMostTries); ++about)
      if (fan_about(about, corners, vertices, normal, strictly, fan)) return fan;
  fan.triangles.clear();
  fan.wrong = "a polygon is not convex and cannot be seen whole from one of its corners";
  return fan;
}

TriangleSoup fanned(PolygonSoup soup) {
  if (soup.ends.empty()) throw InputError({soup.file}, "the file has no faces", "a closed mesh");
  TriangleSoup out;
  std::uint64_t begin = 0;
  for (std::size_t i = 0; i < soup.ends.size(); begin = soup.ends[i], ++i) {
    const std::span corners(soup.corners.data() + begin, soup.ends[i] - begin);
    check_corners(soup, i, corners);
    const PolygonFan fan = fan_of(corners, soup.vertices);
    if (!fan.wrong.empty()) fail(soup, i, fan.wrong, "triangles, or plane convex polygons");
    for (const auto& triangle : fan.triangles) out.add(triangle, soup.places[i]);
  }
  out.vertices = std::move(soup.vertices);
  out.binary = soup.binary, out.file = std::move(soup.file);
  return out;
}

}  // namespace limitgauge::model
