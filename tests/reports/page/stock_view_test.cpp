#include "reports/page/stock_view.h"

#include <algorithm>
#include <cmath>

#include "reports/page/mesh_reduction.h"
#include "tests/support/catch.h"

namespace limitgauge::reports::page {
namespace {

using model::Vec3;

/// A slot of 6 mm along X through a block of 30 x 20 x 10 mm, its floor 3 mm below the top at zero;
/// then a second pass across it, 1 mm deep.
struct Slotted {
  std::vector<model::Pass> passes;
  simulator::StockModel stock;
};

model::Pass pass_along(const Vec3& from, const Vec3& to, std::uint32_t line) {
  model::Toolpath path;
  path.start = {from.x, from.y, 5};
  for (const Vec3& place : {from, to})
    path.moves.emplace_back(place, 500.0F, line++, model::MoveKind::feed);
  return {model::parse_cutter("flat:D=6,L=12"), std::make_shared<const model::Toolpath>(path)};
}

Slotted slotted(unsigned threads = 1) {
  const model::RunControl control{threads, nullptr, {}};
  std::vector<model::Pass> passes = {pass_along({-5, 10, -3}, {35, 10, -3}, 7),
                                     pass_along({15, -5, -1}, {15, 25, -1}, 9)};
  simulator::StockModel stock(model::BoxStock{{0, 0, -10}, {30, 20, 10}}, 0.2, std::size_t{1} << 30,
                              control);
  for (const model::Pass& pass : passes) stock = std::move(stock).cut(pass, control);
  return {std::move(passes), std::move(stock)};
}

StockView view_of(const Slotted& made, unsigned threads = 1) {
  const model::RunControl control{threads, nullptr, {}};
  return stock_view(made.stock, made.stock.surface(control).mesh, made.passes, control);
}

TEST_CASE("A stock's picture is thinned out where it is flat, and near the stock", "[unit][page]") {
  const Slotted made = slotted();
  const StockView view = view_of(made);
  CHECK(view.surface_triangles > 20'000);
  CHECK(view.mesh.triangles.size() < view.surface_triangles / 10);
  CHECK(view.makers.size() == view.mesh.triangles.size());
  CHECK(view.checked > 100);
  CHECK(view.within_mm > 0);
  CHECK(view.within_mm < 0.2);
  const model::Box3 box = bounding_box(view.mesh);
  CHECK(length(box.low - Vec3{0, 0, -10}) < 0.2);
  CHECK(length(box.high - Vec3{30, 20, 0}) < 0.2);
}

TEST_CASE("The distance stated holds at places that were not asked for it", "[property][page]") {
  const Slotted made = slotted();
  const StockView view = view_of(made);
  for (const auto& t : view.mesh.triangles) {
    const Vec3 &a = view.mesh.vertices[t[0]], &b = view.mesh.vertices[t[1]],
               &c = view.mesh.vertices[t[2]];
    // \u03c6 is no more than the distance: within it, or what is stated would be wrong.
    CHECK(std::abs(made.stock.exact_value(a * 0.2 + b * 0.3 + c * 0.5)) <= view.within_mm + 0.05);
  }
}

TEST_CASE("Every triangle names what cut it", "[unit][page]") {
  const StockView view = view_of(slotted());
  std::size_t raw = 0, slot = 0, across = 0;
  for (std::size_t i = 0; i < view.makers.size(); ++i) {
    const auto& t = view.mesh.triangles[i];
    const Vec3 middle =
        (view.mesh.vertices[t[0]] + view.mesh.vertices[t[1]] + view.mesh.vertices[t[2]]) / 3;
    const StockView::Maker& maker = view.makers[i];
    if (maker.pass == 0) {
      CHECK(maker.line == 0);
      ++raw;
    } else if (std::abs(middle.z + 3) < 0.01) {
      CHECK(maker.pass == 1);
      CHECK((maker.line == 7 || maker.line == 8));
      ++slot;
    } else if (std::abs(middle.z + 1) < 0.01) {
      CHECK(maker.pass == 2);
      CHECK((maker.line == 9 || maker.line == 10));
      ++across;
    }
  }
  CHECK((raw > 10 && slot > 0 && across > 0));
}

TEST_CASE("A stock's picture is the same for any number of threads", "[unit][page]") {
  const StockView one = view_of(slotted()), two = view_of(slotted(2), 2);
  CHECK(one.mesh.triangles == two.mesh.triangles);
  CHECK(one.mesh.vertices == two.mesh.vertices);
  CHECK(one.within_mm == two.within_mm);
  CHECK(std::equal(one.makers.begin(), one.makers.end(), two.makers.begin(), two.makers.end(),
                   [](const StockView::Maker& a, const StockView::Maker& b) {
                     return a.pass == b.pass && a.move == b.move && a.line == b.line;
                   }));
}

/// A ball of 20 mm radius: `rows` rows of squares between its poles, each two triangles.
model::TriangleMesh ball(std::uint32_t rows) {
  model::TriangleMesh mesh;
  const std::uint32_t columns = 2 * rows;
  const double step = M_PI / (rows + 1);
  for (std::uint32_t i = 1; i <= rows; ++i)
    for (std::uint32_t k = 0; k < columns; ++k) {
      const double across = 2 * M_PI * k / columns;
      mesh.vertices.push_back(Vec3{std::sin(i * step) * std::cos(across),
                                   std::sin(i * step) * std::sin(across), std::cos(i * step)} *
                              20.0);
    }
  const std::uint32_t top = rows * columns, bottom = top + 1;
  mesh.vertices.push_back({0, 0, 20}), mesh.vertices.push_back({0, 0, -20});
  for (std::uint32_t k = 0; k < columns; ++k) {
    const std::uint32_t next = (k + 1) % columns, last = (rows - 1) * columns;
    mesh.triangles.push_back({top, k, next});
    mesh.triangles.push_back({bottom, last + next, last + k});
    for (std::uint32_t row = 0; row < last; row += columns) {
      mesh.triangles.push_back({row + k, row + columns + k, row + columns + next});
      mesh.triangles.push_back({row + k, row + columns + next, row + next});
    }
  }
  return mesh;
}

TEST_CASE("A mesh comes down to what is asked for, with its own vertices", "[unit][page]") {
  const model::TriangleMesh mesh = ball(100);
  const model::TriangleMesh less = reduced(mesh, 2'000);
  CHECK(less.triangles.size() <= 2'000);
  CHECK(less.triangles.size() > 500);
  for (const Vec3& v : less.vertices)
    CHECK(std::find(mesh.vertices.begin(), mesh.vertices.end(), v) != mesh.vertices.end());
  CHECK(area_mm2(less) == Approx(area_mm2(mesh)).epsilon(0.02));
  for (const auto& t : less.triangles) {
    const Vec3 &a = less.vertices[t[0]], &b = less.vertices[t[1]], &c = less.vertices[t[2]];
    CHECK(dot(cross(b - a, c - a), a + b + c) > 0);  // none has turned over
  }
}

TEST_CASE("A mesh of millions is gathered first", "[unit][page]") {
  const model::TriangleMesh mesh = ball(500);  // a million triangles
  const model::TriangleMesh less = reduced(mesh, 20'000);
  CHECK(less.triangles.size() <= 20'000);
  CHECK(area_mm2(less) == Approx(area_mm2(mesh)).epsilon(0.02));
  CHECK(reduced({}, 100).triangles.empty());
}

}  // namespace
}  // namespace limitgauge::reports::page
