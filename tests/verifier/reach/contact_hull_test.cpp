#include "verifier/reach/contact_hull.h"

#include "model/part/cutter.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {
namespace {

using namespace tests;
using model::Vec3;

/// Where the tip stands that touches a point with that normal, from the definition.
Vec3 touching(const CutterProfile& cutter, double allowance_mm, const Vec3& p, const Vec3& n) {
  const double level = std::hypot(n.x, n.y);
  const Vec3 core = p + n * (cutter.rounding_mm + allowance_mm) - Vec3{0, 0, cutter.core_mm};
  return core + Vec3{n.x, n.y, 0} * (cutter.flat_mm / level);
}

/// How far beyond a hull p lies in any of some directions.
double beyond(const ContactHull& hull, const Vec3& p) {
  double most = -1e300;
  for (int k = 0; k < 100; ++k) {
    const double z = -1 + (k + 0.5) / 50, angle = 2.399963 * k, r = std::sqrt(1 - z * z);
    const Vec3 g{r * std::cos(angle), r * std::sin(angle), z};
    double support = -1e300;
    for (const Vec3& tip : hull.tips) support = std::max(support, dot(g, tip));
    most = std::max(most, dot(g, p) - support);
  }
  return most;
}

}  // namespace

TEST_CASE("the tips that touch a cell lie within the stray of their hull", "[property]") {
  const ReferenceSurface surface(star_cage(5, 4));
  const char* const text = GENERATE("ball:D=6,L=20", "bull:D=8,r=1,L=20", "flat:D=8,L=20",
                                    "taper:D=2,r=0.5,angle=5,L=20");
  const double allowance = GENERATE(0.0, 0.3);
  const CutterProfile cutter(model::parse_cutter(text));
  CAPTURE(text, allowance);
  int hulls = 0;
  for (const double size_mm : {0.8, 0.2}) {
    const SurfaceCells cells(surface.tree(), size_mm);
    for (std::size_t i = 0; i < cells.cells().size(); i += 11) {
      const Bezier& shape = cells.cells()[i].shape;
      const auto hull = ContactHull::of(offset_cell(shape, {}), cutter, allowance);
      // Normals of less than a micrometre beside irregular vertices are rounding.
      if (!hull || length(cells.cells()[i].vertex_normal) > 0) continue;
      ++hulls;
      double most = 0;
      for (double s = 0; s <= 1; s += 0.25)
        for (double t = 0; t <= 1; t += 0.25) {
          const BezierJet j = jet(shape, s, t);
          const Vec3 n = normalized(cross(j.du, j.dv));
          most = std::max(most, beyond(*hull, touching(cutter, allowance, j.position, n)));
        }
      CHECK(most <= hull->stray_mm + 1e-9);
    }
  }
  CHECK(hulls > 100);
}

TEST_CASE("the stray of contact positions shrinks with the square of the cell", "[property]") {
  const ReferenceSurface surface(paraboloid_cage(10, 0.05));
  const CutterProfile cutter(model::parse_cutter("bull:D=8,r=1,L=20"));
  const auto stray_at = [&](double size_mm) {
    const SurfaceCells cells(surface.tree(), size_mm);
    double most = 0;
    for (const SurfaceCell& cell : cells.cells()) {
      const Vec3 m = middle(cell.shape);
      // Away from the bottom, where the flat's direction turns fast.
      if (std::hypot(m.x, m.y) < 5) continue;
      const auto hull = ContactHull::of(offset_cell(cell.shape, {}), cutter, 0);
      REQUIRE(hull.has_value());
      most = std::max(most, hull->stray_mm);
    }
    return most;
  };
  CHECK(stray_at(0.2) < 0.3 * stray_at(0.4));
}

}  // namespace limitgauge::verifier
