// The witness of every run: right surfaces pass, wrong ones are caught, and all is counted.
#include "app/inputs/surface_witness.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

#include "model/part/cage_obj.h"
#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/feature_cages.h"
#include "tests/support/folders.h"
#include "verifier/gate/verify.h"

namespace limitgauge::app {
namespace {

using model::Cage;
using verifier::ReferenceSurface;
using witness::Agreement;

Agreement witnessed(const Cage& cage) {
  return app::witnessed(cage, ReferenceSurface(cage));
}

/// Every cage of a folder that can be read.
std::vector<Cage> cages_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Cage> cages;
  for (const auto& file : files) {
    try {
      cages.push_back(model::read_cage_obj(file));
      cages.back().name = file.filename().string();
    } catch (const std::exception&) {
      continue;  // broken on purpose
    }
  }
  return cages;
}

std::vector<Cage> all_cages() {
  std::vector<Cage> all = tests::feature_cages();
  for (Cage& cage : cages_of(tests::fixtures() / "cages")) all.push_back(std::move(cage));
  for (Cage& cage : cages_of(tests::fixtures() / "torture")) all.push_back(std::move(cage));
  if (const char* folder = std::getenv("LIMITGAUGE_CAGES"))
    for (Cage& cage : cages_of(folder)) all.push_back(std::move(cage));
  return all;
}

/// More faces about a vertex than OpenSubdiv counts, 65,535.
Cage endless_fan() {
  Cage fan;
  const model::Index faces = 70'000;
  fan.vertices.assign(faces + 1, {1, 0, 0});
  for (model::Index f = 0; f < faces; ++f)
    fan.add_face(std::array{model::Index{0}, f + 1, (f + 1) % faces + 1});
  return fan;
}

/// For cages of which no point is asked.
class NoSurface final : public witness::SurfaceUnderTest {
 public:
  int patch_count() const override { return 1; }
  bool has_surface(int) const override { return false; }
  Sample evaluate(int, double, double) const override { return {}; }
};

}  // namespace

TEST_CASE("the reference surface agrees with the witness on every cage", "[unit][witness][slow]") {
  std::size_t by_refinement = 0, normals = 0;
  for (const Cage& cage : all_cages()) {
    CAPTURE(cage.name);
    const Agreement found = witnessed(cage);
    CHECK(found.points > 0);
    CHECK(found.points_left_out == 0);
    CHECK(found.normals + found.normals_left_out == found.points);
    by_refinement += found.by_refinement;
    normals += found.normals;
    if (std::getenv("LIMITGAUGE_TABLES") != nullptr)
      WARN(cage.name << ": " << words_of(found) << "; bounds " << found.bound_mm << " mm, "
                     << found.normal_bound_rad << " rad; " << found.by_refinement
                     << " by refinement, normals left out " << found.normals_left_out << ", "
                     << found.seconds << " s");
  }
  CHECK(by_refinement > 0);
  CHECK(normals > 0);
}

TEST_CASE("vertices that no face has are none of the witness's business", "[unit][witness]") {
  Cage cage = tests::cube_cage();
  const Agreement without = witnessed(cage);
  cage.vertices.insert(cage.vertices.begin(), {5, 5, 5});
  for (model::Index& corner : cage.face_corners) ++corner;
  CHECK(witnessed(cage).points == without.points);
}

TEST_CASE("a reference surface of another cage is caught", "[unit][witness]") {
  const Cage cage = tests::scaled(tests::cube_cage(), 50);
  Cage moved = cage;
  moved.vertices[6].z += 1e-8;  // a hundredth of a nanometre
  CHECK_NOTHROW(app::witnessed(cage, ReferenceSurface(cage)));
  CHECK_THROWS_AS(app::witnessed(cage, ReferenceSurface(moved)), verifier::InstrumentDisagreement);
}

TEST_CASE("other rules of the surface are caught", "[unit][witness]") {
  const Cage cage = tests::cube_cage();
  Cage crease = cage, semi_sharp = cage, corner = cage, hole = cage;
  crease.creases = {{{4, 5}, 10}, {{5, 7}, 10}};
  semi_sharp.creases = {{{4, 5}, 0.01}};
  corner.corners = {{3, 10}};
  hole.holes = {2};
  for (const Cage& other : {crease, semi_sharp, corner, hole})
    CHECK_THROWS_AS(app::witnessed(cage, ReferenceSurface(other)),
                    verifier::InstrumentDisagreement);
  for (const auto rule : {model::BoundaryRule::none, model::BoundaryRule::edge_and_corner}) {
    const Cage open = tests::boundary_fan(1, model::BoundaryRule::edge_only);
    Cage other = open;
    other.boundary = rule;
    CHECK_THROWS_AS(app::witnessed(open, ReferenceSurface(other)),
                    verifier::InstrumentDisagreement);
  }
}

TEST_CASE("a contradiction names both surfaces, the place and the bound", "[unit][witness]") {
  const Cage cage = tests::cube_cage();
  Cage moved = cage;
  moved.vertices[0].x += 0.5;
  try {
    app::witnessed(cage, ReferenceSurface(moved));
    FAIL("not caught");
  } catch (const verifier::InstrumentDisagreement& error) {
    const std::string said = error.what();
    for (const char* word : {"reference surface", "OpenSubdiv", " mm at (", "patch", "rounding"})
      CHECK_THAT(said, ContainsSubstring(word));
  }
}

TEST_CASE("a cage that OpenSubdiv refuses is not taken for seen", "[unit][witness]") {
  const Agreement found = hold_against(endless_fan(), NoSurface());
  REQUIRE(found.contradiction);
  CHECK_THAT(*found.contradiction, ContainsSubstring("OpenSubdiv refuses"));
  CHECK(found.points == 0);
}

}  // namespace limitgauge::app
