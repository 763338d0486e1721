// The modes of a dart against uniform refinement written apart from the verifier.
#include "verifier/surface/ring_modes.h"

#include <cmath>
#include <vector>

#include "tests/support/cages.h"
#include "tests/support/catch.h"
#include "tests/support/uniform_refinement.h"

namespace limitgauge::verifier {
namespace {

using model::Cage;
using model::Vec3;

/// How far the star's points are from zero, about.
constexpr double kSize_mm = 30;

/// Vertex, edge ends and opposite corners of the star at vertex 0, whose faces come first.
struct Ring {
  Vec3 vertex;
  std::vector<Vec3> edge, face;
};

Ring ring_of(const Cage& cage, int faces) {
  Ring ring{cage.vertices[0], {}, {}};
  for (int k = 0; k < faces; ++k) {
    ring.edge.push_back(cage.vertices[cage.face(k)[1]]);
    ring.face.push_back(cage.vertices[cage.face(k)[2]]);
  }
  return ring;
}

/// One refinement on: the child at corner 0 of each face.
Ring refined_ring(const Cage& cage, int faces) {
  const Cage refined = tests::refine_uniformly(cage);
  const auto at = [&](int k, int corner) { return refined.vertices[refined.face(4 * k)[corner]]; };
  Ring ring{at(0, 0), {}, {}};
  for (int k = 0; k < faces; ++k) {
    ring.edge.push_back(at(k, 1));
    ring.face.push_back(at(k, 2));
  }
  return ring;
}

Vec3 sum(const RingWeights& w, const Ring& ring) {
  Vec3 total = ring.vertex * w.vertex;
  for (std::size_t i = 0; i < ring.edge.size(); ++i)
    total += ring.edge[i] * w.edge[i] + ring.face[i] * w.face[i];
  return total;
}

double sum_of_weights(const RingWeights& w) {
  double total = w.vertex;
  for (const double e : w.edge) total += e;
  for (const double f : w.face) total += f;
  return total;
}

}  // namespace

TEST_CASE("the modes of a dart are eigenvectors of its refinement", "[unit]") {
  for (const int n : {3, 4, 5, 6, 8, 13, 20, 50}) {
    CAPTURE(n);
    Cage cage = tests::star_cage(n, 2);
    cage.creases = {{{0, 1}, model::kInfiniteSharpness}};
    const Ring before = ring_of(cage, n), after = refined_ring(cage, n);
    const DartModes modes = dart_modes(n);

    CHECK(sum_of_weights(modes.limit) == Approx(1).epsilon(1e-14));
    CHECK(distance(sum(modes.limit, after), sum(modes.limit, before)) < 1e-13 * kSize_mm);

    const Vec3 along = sum(modes.along, before), next = sum(modes.along, after);
    const double shrinks = dot(next, along) / dot(along, along);
    CHECK(std::abs(sum_of_weights(modes.along)) < 1e-13);
    CHECK(distance(next, along * shrinks) < 1e-13 * length(along));
    // Neither the limit's own, 1, nor a quick one: no wave shrinks less than one of no turn.
    CHECK(shrinks > 0.4);
    CHECK(shrinks < ring_eigenvalue(1));
  }
}

}  // namespace limitgauge::verifier
