// The simulator's stock and the verifier's distances, held against each other by rays: neither
// knows the other.
#include "verifier/gate/stock_rays.h"
#include <string>
#include <string_view>

#include "app/run/stock_probe.h"
#include "model/gcode/program.h"
#include "model/gcode/program_path.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/rasters.h"
#include "tests/support/solid_meshes.h"
#include "verifier/gate/field_samples.h"
#include "verifier/surface/surface_tree.h"

namespace limitgauge {
namespace {

using namespace tests;
using model::Vec3;

/// All samples count as in reach. A disagreement would throw.
verifier::RayFigures read(const verifier::ReferenceSurface& surface, const model::Stock& raw,
                          const verifier::Pass& pass, double voxel_mm, double allowance_mm = 0) {
  constexpr std::size_t kMemory = std::size_t{1} << 30;
  const app::StockRayProbe probe(
      simulator::StockModel(raw, voxel_mm, kMemory).cut({pass.cutter, pass.path}, {2}));
  const verifier::SurfaceCells cells(surface.tree(), 0.3);
  const verifier::RemovedSpace removed(raw, {&pass, 1}), outside(raw, {});
  verifier::RayRequest request;
  request.allowance_mm = allowance_mm;
  constexpr double kRaySpacing_mm = 0.25, kFar_mm = 60;
  return read_rays({cells, removed, outside, probe, kFar_mm},
                   verifier::sample_surface(surface, kRaySpacing_mm), request, {2});
}

}  // namespace

TEST_CASE("rays into the simulated stock agree with the analytic distances", "[property][rays]") {
  const verifier::ReferenceSurface dome(paraboloid_cage(5, -0.03));
  const model::Stock block = model::BoxStock{{-12, -12, -10}, {24, 24, 12}};
  const model::Stock bar = model::CylinderStock{{0, 0, -10}, 26, 12};
  const model::Stock mesh = mesh_stock(box_mesh({-12, -12, -10}, {24, 24, 12}));
  const auto height = [](double x, double y) { return -0.03 * (x * x + y * y) - 0.02; };
  for (const model::Stock& raw : {block, bar, mesh})
    for (const model::Cutter& c : {ball_cutter(1.5), flat_cutter(1)})
      for (const double allowance_mm : {0.0, 0.1}) {
        const verifier::Pass pass{c, shared(raster(6, 0.7, 0.5, height))};
        const verifier::RayFigures d = read(dome, raw, pass, 0.4, allowance_mm);
        CHECK(d.rays > 1000);
        CHECK(d.uncut_mm + d.gouge_mm > 0);
      }
}

TEST_CASE("fins thinner than any voxel read their height", "[unit][rays]") {
  // Flats of D4 at a step of 4 mm and 0.1 mm: fins 5 mm tall.
  const verifier::ReferenceSurface plane(plane_cage(4, 0, 0));
  const model::Stock block = model::BoxStock{{-20, -20, -10}, {40, 40, 15}};
  for (const double w : {0.002, 0.1}) {
    model::Toolpath path;
    path.start = {-2 - w / 2, -12, 10};
    for (const double x : {-6 - 1.5 * w, -2 - w / 2, 2 + w / 2, 6 + 1.5 * w}) {
      feed_to(path, {x, -12, 10});
      feed_to(path, {x, -12, 0});
      feed_to(path, {x, 12, 0});
      feed_to(path, {x, 12, 10});
    }
    const verifier::RayFigures d = read(plane, block, {flat_cutter(2), shared(path)}, 0.5);
    CHECK(d.uncut_mm == Approx(5).margin(1e-6));
    CHECK(d.gouge_mm == Approx(0).margin(1e-6));
  }
}

TEST_CASE("rays agree where the stock is cut by wider chords of arcs than the certificate has",
          "[unit][rays]") {
  // A flat of D4 along the walls of a cube, rolling round its corners, flush or this far off.
  constexpr double kChords_mm = 0.05;
  const verifier::ReferenceSurface cube(scaled(sharp_cube(true), 5));
  const model::Box3 box = cube.bounding_box();
  const model::Stock block = model::BoxStock{box.low - model::Vec3{1, 1, 1}, box.size() * 1.3};
  for (const double off_mm : {0.0, 0.03, -0.03}) {
    const double near = 2 + off_mm;
    const auto number = [](double value) { return std::to_string(value) + " "; };
    const std::string roll = number(near);
    const std::string left = number(box.low.x), right = number(box.high.x);
    const std::string low = number(box.low.y), high = number(box.high.y);
    const std::string program = "G0 X" + number(box.low.x - near) + "Y" + low + "Z" +
                                number(box.low.z + 2) + "\nF500 G1 Y" + high + "\nG2 X" + left +
                                "Y" + number(box.high.y + near) + "I" + roll + "J0\nG1 X" + right +
                                "\nG2 X" + number(box.high.x + near) + "Y" + high + "I0 J-" + roll +
                                "\nG1 Y" + low + "\n";
    const verifier::Pass pass{
        flat_cutter(2),
        shared(to_toolpath(model::read_program(std::string_view(program), "cube"), kChords_mm))};
    REQUIRE(pass.path->arcs.size() == 2);
    REQUIRE(pass.path->chord_error_mm > kChords_mm / 10);
    const verifier::RayFigures d = read(cube, block, pass, 0.5);
    CHECK(d.rays > 1000);
    // Off the walls nothing is cut, and what chords cut is not told as a gouge of theirs.
    if (off_mm >= 0) CHECK(d.gouge_mm <= kChords_mm);
    if (off_mm < 0) CHECK(d.gouge_mm > -off_mm - 1e-3);
  }
}

}  // namespace limitgauge
