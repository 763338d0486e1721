#include "reports/picture/stock_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/base/memory.h"
#include "reports/picture/marker.h"
#include "reports/picture/raster.h"
#include "reports/tolerance.h"

namespace limitgauge::reports {
namespace {

using model::Vec3;

constexpr int kOversampling = 2;
constexpr int kMargin = 24;

/// A parallel view: where the viewer stands, and what is right and up on the screen.
struct View {
  Vec3 towards = model::normalized({0.52, -0.95, 0.80});
  Vec3 right = model::normalized(model::cross({0, 0, 1}, towards));
  Vec3 up = model::cross(towards, right);
  double scale = 1, left = 0, top = 0;  ///< pixels per mm, then mm on the screen's axes

  ScreenPoint project(const Vec3& p) const {
    return {(model::dot(p, right) - left) * scale, (top - model::dot(p, up)) * scale,
            model::dot(p, towards)};
  }
};

/// Sets the view so that all of `mesh` fits `width` pixels; gives the height.
int fit(View& view, const simulator::StockMesh& mesh, int width) {
  model::Box3 seen;
  for (const Vec3& p : mesh.vertices)
    seen.add(Vec3{model::dot(p, view.right), model::dot(p, view.up), 0});
  const Vec3 size = seen.size();
  view.scale = (width - 2.0 * kMargin) / std::max({size.x, size.y, kLeastExtent_mm});
  view.left = seen.low.x - kMargin / view.scale, view.top = seen.high.y + kMargin / view.scale;
  return int(std::ceil(size.y * view.scale)) + 2 * kMargin;
}

/// Millions of them: half the room, and far finer than a pixel.
struct Small {
  float x = 0, y = 0, z = 0;

  Small() = default;
  Small(double px, double py, double pz)
      : x(static_cast<float>(px)), y(static_cast<float>(py)), z(static_cast<float>(pz)) {}
  Vec3 vec() const { return {x, y, z}; }
};

/// Area-weighted normals at the vertices: what the stock's facets stand for.
std::vector<Small> vertex_normals(const simulator::StockMesh& mesh) {
  std::vector<Small> normals;
  model::reserve_large(normals, mesh.vertices.size());
  normals.resize(mesh.vertices.size());
  for (const auto& t : mesh.triangles) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 n = model::cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
    for (const auto corner : t) {
      const Vec3 sum = normals[corner].vec() + n;
      normals[corner] = {sum.x, sum.y, sum.z};
    }
  }
  return normals;
}

std::vector<Small> screen_points(const simulator::StockMesh& mesh, const View& view) {
  std::vector<Small> points;
  model::reserve_large(points, mesh.vertices.size());
  for (const Vec3& vertex : mesh.vertices) {
    const ScreenPoint p = view.project(vertex);
    points.push_back({p.x, p.y, p.z});
  }
  return points;
}

/// x to the fortieth.
double shine_of(double x) {
  const double x2 = x * x, x4 = x2 * x2, x8 = x4 * x4, x16 = x8 * x8;
  return x16 * x16 * x8;
}

/// Steel in the light of a window behind the viewer's left shoulder and of the sky.
struct Lights {
  explicit Lights(const View& view)
      : window(model::normalized(view.towards * 0.5 + view.up * 0.75 - view.right * 0.7)),
        half(model::normalized(window + view.towards)) {}
  Vec3 window, half;

  Rgba on(const Vec3& normal) const {
    const Vec3 n = model::normalized(normal);
    const double sky = 0.5 + 0.5 * n.z, lit = std::max(0.0, model::dot(n, window));
    const double shine = 0.22 * shine_of(std::max(0.0, model::dot(n, half)));
    const auto tone = [&](double base) {
      const double value = base * (0.26 + 0.24 * sky + 0.55 * lit) + 255 * shine;
      return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0) + 0.5);
    };
    return {tone(196), tone(204), tone(216)};
  }
};

/// On a closed surface something else hides it. Rows of the screen go down.
bool is_turned_away(const std::array<ScreenPoint, 3>& t) {
  return (t[1].x - t[0].x) * (t[2].y - t[0].y) >= (t[2].x - t[0].x) * (t[1].y - t[0].y);
}

/// Triangles that follow each other lie near each other: most bunches of them reach few rows.
constexpr std::size_t kBunch = 4096;
struct Bunch {
  std::size_t begin = 0, end = 0;
  float top, bottom;  ///< rows of the screen

  bool reaches(const DepthBuffer& depth) const {
    const int first = depth.first_row();
    return bottom >= static_cast<float>(first) && top <= static_cast<float>(first + depth.height());
  }
};

std::vector<Bunch> bunches_of(const simulator::StockMesh& mesh, const std::vector<Small>& points) {
  std::vector<Bunch> bunches;
  for (std::size_t begin = 0; begin < mesh.triangles.size(); begin += kBunch) {
    Bunch bunch{begin, std::min(begin + kBunch, mesh.triangles.size()),
                std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
    for (std::size_t i = begin; i < bunch.end; ++i)
      for (const std::uint32_t corner : mesh.triangles[i]) {
        bunch.top = std::min(bunch.top, points[corner].y);
        bunch.bottom = std::max(bunch.bottom, points[corner].y);
      }
    bunches.push_back(bunch);
  }
  return bunches;
}

/// What the picture is drawn from.
struct Scene {
  const simulator::StockMesh& mesh;
  std::vector<Small> points, normals;
  std::vector<Bunch> bunches;
  Lights lights;
};

/// Those triangles of a bunch that are nearest in the rows of `depth`, as normals.
void fill(const Scene& scene, const Bunch& bunch, DepthBuffer& depth, std::vector<Small>& seen) {
  const auto corner = [&](std::uint32_t k) {
    return ScreenPoint{scene.points[k].x, scene.points[k].y, scene.points[k].z};
  };
  for (std::size_t n = bunch.begin; n < bunch.end; ++n) {
    const auto& t = scene.mesh.triangles[n];
    const std::array at{corner(t[0]), corner(t[1]), corner(t[2])};
    if (is_turned_away(at)) continue;
    depth.fill_triangle(at, [&](std::size_t i, const auto& w) {
      const auto normal = [&](int k) { return scene.normals[t[k]].vec() * w[k]; };
      const Vec3 sum = normal(0) + normal(1) + normal(2);
      seen[i] = {sum.x, sum.y, sum.z};
    });
  }
}

/// Puts what is nearest in the rows of `depth` into `image`: all that is seen is lit, once. `seen`
/// is room for the normals of as many pixels.
void light_rows(const Scene& scene, DepthBuffer& depth, std::vector<Small>& seen, Image& image) {
  for (const Bunch& bunch : scene.bunches)
    if (bunch.reaches(depth)) fill(scene, bunch, depth, seen);
  const std::size_t pixels = std::size_t(depth.width()) * depth.height();
  for (std::size_t i = 0; i < pixels; ++i)
    image.pixels()[i] = depth.is_empty(i) ? Rgba{0, 0, 0, 0} : scene.lights.on(seen[i].vec());
}

}  // namespace

Image draw_stock_picture(const simulator::StockMesh& mesh, int largest_width,
                         const model::Pose& from_part) {
  View view;
  const int fine_width = largest_width * kOversampling;
  const int fine_height = fit(view, mesh, fine_width) / 2 * 2;
  Scene scene{mesh, screen_points(mesh, view), vertex_normals(mesh), {}, Lights(view)};
  scene.bunches = bunches_of(mesh, scene.points);
  Image image(fine_width / kOversampling, std::max(fine_height / kOversampling, 1));
  DepthBuffer depth(fine_width, kRowsAtOnce);
  std::vector<Small> seen(std::size_t(fine_width) * kRowsAtOnce);
  Image lit(fine_width, kRowsAtOnce);
  by_rows(image.height() * kOversampling, [&](int first_row, int rows) {
    depth.restart(first_row, rows);
    light_rows(scene, depth, seen, lit);
    image.put_halved(lit, rows, first_row / kOversampling);
  });
  // An axis of a part that was turned may lead down.
  const double room = from_part.turns() ? 2.0 * kMargin : 0;
  draw_axes(image, from_part.direction_back(view.right), from_part.direction_back(view.up),
            {kMargin + 34.0, image.height() - kMargin - 26.0 - room});
  return image;
}

}  // namespace limitgauge::reports
