#include "verifier/surface/reference_surface.h"

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "model/base/error.h"
#include "model/part/cage_obj.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/uniform_refinement.h"
#include "tests/verifier/limit_samples.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Agreement asked for: 1e-12 of the model's size; both sides work in double precision with a few
/// thousand roundings at most.
constexpr double kExact = 1e-12;

}  // namespace

TEST_CASE("building the exact surface stops when told to", "[unit]") {
  std::atomic<bool> stop{true};
  for (const unsigned threads : {1U, 2U})
    CHECK_THROWS_AS(ReferenceSurface(tests::star_cage(5, 1), {threads, &stop, {}}),
                    model::Interrupted);
}

TEST_CASE("the exact surface is the same for any number of threads", "[unit][slow]") {
  // More faces than one thread takes at once, and irregular vertices among them.
  constexpr int kStars = 40;
  model::Cage cage;
  for (int star = 0; star < kStars; ++star) {
    const model::Cage one = tests::star_cage(3 + star % 5, 1);
    const auto first = static_cast<model::Index>(cage.vertices.size());
    for (Vec3 v : one.vertices) {
      v.x += 10.0 * star;
      cage.vertices.push_back(v);
    }
    for (model::Index f = 0; f < one.face_count(); ++f) {
      std::vector<model::Index> corners;
      for (const model::Index v : one.face(f)) corners.push_back(first + v);
      cage.add_face(corners);
    }
  }
  const ReferenceSurface one(cage, {1, nullptr, {}}), two(cage, {2, nullptr, {}});
  REQUIRE(one.patch_count() > 128);
  REQUIRE(two.patch_count() == one.patch_count());
  CHECK(one.area_mm2() == two.area_mm2());
  CHECK(one.bounding_box().low == two.bounding_box().low);
  CHECK(one.bounding_box().high == two.bounding_box().high);
  for (int patch = 0; patch < one.patch_count(); ++patch)
    for (const double t : {0.0, 1e-9, 0.001, 0.3, 1.0}) {
      CHECK(one.evaluate(patch, t, t).position == two.evaluate(patch, t, t).position);
      CHECK(one.evaluate(patch, t, t).normal == two.evaluate(patch, t, t).normal);
    }
}

TEST_CASE("the limit of the cube has its closed-form values", "[unit]") {
  const ReferenceSurface surface(tests::cube_cage());
  // Face 1 is z = 1 with corners in the order (−,−), (+,−), (+,+), (−,+).
  const Vec3 corner = surface.evaluate(1, 0, 0).position;
  CHECK(distance(corner, {-0.5, -0.5, 0.5}) < 1e-14);
  const Vec3 centre = surface.evaluate(1, 0.5, 0.5).position;
  CHECK(distance(centre, {0, 0, 68.0 / 81}) < 1e-14);
  const Vec3 edge = surface.evaluate(1, 0.5, 0).position;
  CHECK(distance(edge, {0, -395.0 / 648, 395.0 / 648}) < 1e-14);
  const Vec3 normal = surface.evaluate(1, 0, 0).normal;
  CHECK(distance(normal, normalized(Vec3{-1, -1, 1})) < 1e-12);
  CHECK(surface.bounding_box().high.z == Approx(68.0 / 81).margin(1e-10));
}

TEST_CASE("quadratic surfaces are reproduced exactly on regular grids", "[unit]") {
  const double k = 0.01;
  const ReferenceSurface surface(tests::paraboloid_cage(30, k));
  int patches = 0;
  for (int patch = 0; patch < surface.patch_count(); ++patch) {
    if (!surface.has_surface(patch)) continue;
    ++patches;
    for (double u = 0; u <= 1; u += 0.125)
      for (double v = 0; v <= 1; v += 0.125) {
        const SurfaceSample s = surface.evaluate(patch, u, v);
        CHECK(std::abs(s.position.z -
                       k * (s.position.x * s.position.x + s.position.y * s.position.y)) < 1e-12);
        const Vec3 n = normalized(Vec3{-2 * k * s.position.x, -2 * k * s.position.y, 1});
        CHECK(distance(s.normal, n) < 1e-12);
      }
  }
  CHECK(patches == 36);
}

TEST_CASE("area of a tilted plane", "[unit]") {
  const ReferenceSurface surface(tests::plane_cage(20, 0.5, 0));
  CHECK(surface.area_mm2() == Approx(1600 * std::sqrt(1.25)).epsilon(1e-9));
  CHECK(surface.bounding_box().high.x == Approx(20).margin(1e-9));
}

TEST_CASE("vertices of every valence agree with uniform refinement and limit masks", "[unit]") {
  for (const int valence : {3, 4, 5, 6, 7, 8, 12, 20, 50}) {
    CAPTURE(valence);
    CHECK(tests::evaluator_errors(tests::star_cage(valence, 2), valence > 12 ? 2 : 3).worst() <
          kExact);
  }
}

TEST_CASE("corner and boundary rules agree with uniform refinement", "[unit]") {
  for (const auto rule : {model::BoundaryRule::edge_only, model::BoundaryRule::edge_and_corner}) {
    model::Cage cage = tests::grid_cage(
        3, 2,
        [](int i, int j) {
          return Vec3{10.0 * i, 9.0 * j + i, 3.0 * ((i * 7 + j * 5) % 4)};
        },
        rule);
    CHECK(tests::evaluator_errors(cage, 4).worst() < kExact);
  }
}

TEST_CASE("normals at extraordinary vertices are the limit of those around", "[unit]") {
  for (const int valence : {3, 5, 6, 8}) {
    const ReferenceSurface surface(tests::star_cage(valence, 1));
    for (int patch = 0; patch < valence; ++patch) {
      const Vec3 at = surface.evaluate(patch, 0, 0).normal;
      const double d = std::ldexp(1.0, -26);
      const Vec3 near = surface.evaluate(patch, d, d).normal;
      CAPTURE(valence, patch);
      // The difference falls by (second over first eigenvalue) a level; 26 levels are enough for
      // these valences, and the digits lost there are about 1e-7.
      CHECK(distance(at, near) < 1e-4);
    }
  }
}

TEST_CASE("faces with corners of any number count one patch a corner", "[unit]") {
  model::Cage cage;
  cage.vertices = {{0, 0, 0}, {10, 0, 0}, {12, 9, 1}, {5, 14, 0}, {-2, 9, 1}};
  cage.add_face(std::array<model::Index, 5>{0, 1, 2, 3, 4});
  const ReferenceSurface surface(cage);
  CHECK(surface.patch_count() == 5);
  const auto limits = tests::limit_positions(tests::refine_uniformly(cage));
  for (int patch = 0; patch < 5; ++patch) {
    const auto& own = limits[cage.face(0)[patch]];
    REQUIRE(own);
    CHECK(distance(surface.evaluate(patch, 0, 0).position, *own) < 1e-12);
  }
}

TEST_CASE("stored limit values of real cages", "[unit]") {
  const char* folder = std::getenv("LIMITGAUGE_CAGES");
  if (folder == nullptr) return;  // only where such a folder is given
  int compared = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(folder) / "limits")) {
    const auto name = entry.path().stem().string();
    model::Cage cage;
    try {
      cage = model::read_cage_obj(std::filesystem::path(folder) / (name + ".obj"));
    } catch (const std::exception&) {
      continue;  // the deliberately broken ones
    }
    const ReferenceSurface surface(cage);
    std::vector<int> first_patch = {0};
    for (model::Index f = 0; f < cage.face_count(); ++f) {
      const int corners = static_cast<int>(cage.face(f).size());
      first_patch.push_back(first_patch.back() + (corners == 4 ? 1 : corners));
    }
    std::ifstream in(entry.path());
    std::string line;
    std::getline(in, line);
    double worst = 0;
    while (std::getline(in, line)) {
      for (char& c : line)
        if (c == ',') c = ' ';
      std::istringstream fields(line);
      int face = 0;
      double u = 0, v = 0;
      Vec3 p;
      fields >> face >> u >> v >> p.x >> p.y >> p.z;
      const int corners = static_cast<int>(cage.face(face).size());
      int patch = first_patch[face];
      if (corners != 4) {  // OpenSubdiv lays an n-gon's quads out as half unit tiles, row by row
        const int wide = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(corners))));
        const int tile_u = static_cast<int>(u), tile_v = static_cast<int>(v);
        patch += tile_u + wide * tile_v;
        u = 2 * (u - tile_u), v = 2 * (v - tile_v);
      }
      worst = std::max(worst, distance(surface.evaluate(patch, u, v).position, p));
      ++compared;
    }
    // The stored values hold sharpness in single precision and end at a finite level beside
    // infinitely sharp creases (see the folder's own note); smooth cages agree to rounding.
    const bool sharp = !cage.creases.empty() || !cage.corners.empty();
    const bool infinite = name == "catmark_cubes_infsharp" || name == "catmark_inf_crease0";
    CAPTURE(name);
    CHECK(worst < (infinite ? 3e-4 : sharp ? 1e-8 : 1e-12) * tests::size_of(cage));
  }
  CHECK(compared > 10000);
}

}  // namespace limitgauge::verifier
