// Worst error of the evaluator by kind of vertex, against deep uniform refinement.
#include <cstdlib>
#include <filesystem>

#include "model/base/error.h"
#include "model/part/cage_obj.h"
#include "tests/support/catch.h"
#include "tests/support/feature_cages.h"
#include "tests/verifier/limit_samples.h"

namespace limitgauge::tests {
namespace {

/// Agreement asked for: 1e-12 of the model's size; both sides work in double precision with a few
/// thousand roundings at most.
constexpr double kExact = 1e-12;

/// Deep enough to use up the sharpness and to leave several pieces a face, with a bounded number of
/// faces; where that is not deep enough, vertices that are still semi-sharp are left out.
int levels_for(const model::Cage& cage, int most_faces) {
  int levels = std::max(3, levels_of_sharpness(cage));
  while (levels > 1 && cage.face_count() * std::pow(4.0, levels) > most_faces) --levels;
  return levels;
}

}  // namespace

TEST_CASE("every kind of vertex agrees with uniform refinement", "[slow]") {
  ErrorTable all;
  for (const model::Cage& cage : feature_cages()) {
    const ErrorTable own = evaluator_errors(cage, levels_for(cage, 2500));
    CAPTURE(cage.name, own.text());
    CHECK(own.worst() < kExact);
    all.add(own);
  }
  // The cages are there for their kinds of vertices: all of them must have been met.
  for (const char* kind :
       {"regular", "regular boundary", "interior, valence 02", "interior, valence 03",
        "interior, valence 50", "boundary, faces 01", "boundary, faces 20", "crease, valence 03",
        "crease, valence 50", "dart, valence 03", "dart, valence 50", "corner", "semi-sharp",
        "n-gon centre, corners 3", "n-gon centre, corners 7"})
    CHECK(all.rows.contains(kind));
  if (std::getenv("LIMITGAUGE_TABLES") != nullptr) WARN("errors by kind of vertex\n" << all.text());
}

TEST_CASE("every kind of vertex of real cages agrees with uniform refinement", "[slow]") {
  const char* folder = std::getenv("LIMITGAUGE_CAGES");
  if (folder == nullptr) return;  // only where such a folder is given
  ErrorTable all;
  int refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    model::Cage cage;
    try {
      cage = model::read_cage_obj(entry.path());
    } catch (const model::InputError&) {
      ++refused;  // non-manifold ones
      continue;
    }
    const ErrorTable own = evaluator_errors(cage, levels_for(cage, 2500));
    CAPTURE(cage.name, own.text());
    CHECK(own.worst() < kExact);
    all.add(own);
  }
  CHECK(all.rows.size() > 10);
  if (std::getenv("LIMITGAUGE_TABLES") != nullptr)
    WARN("errors by kind of vertex; " << refused << " cages refused\n" << all.text());
}

}  // namespace limitgauge::tests
