#include "app/inputs/surface_witness.h"

#include <sstream>

#include "verifier/gate/verify.h"

namespace limitgauge::app {
namespace {

/// The reference surface, as the witness asks it.
class ReferenceUnderTest final : public witness::SurfaceUnderTest {
 public:
  explicit ReferenceUnderTest(const verifier::ReferenceSurface& surface) : surface_(surface) {}
  int patch_count() const override { return surface_.patch_count(); }
  bool has_surface(int patch) const override { return surface_.has_surface(patch); }
  Sample evaluate(int patch, double u, double v) const override {
    const verifier::SurfaceSample s = surface_.evaluate(patch, u, v);
    const bool flat = length(s.normal) == 0;
    if (flat || s.plane != verifier::TangentPlane::everywhere) return {s.position, std::nullopt};
    return {s.position, s.normal};
  }

 private:
  const verifier::ReferenceSurface& surface_;
};

}  // namespace

namespace {

witness::Agreement witnessed_to(const model::Cage& cage, const verifier::ReferenceSurface& surface,
                                int levels) {
  witness::Agreement found = hold_against(cage, ReferenceUnderTest(surface), levels);
  if (found.contradiction)
    throw verifier::InstrumentDisagreement("the reference surface and " + found.evaluator +
                                           "'s, of the same cage, " + *found.contradiction +
                                           "; please report this");
  return found;
}

}  // namespace

witness::Agreement witnessed(const model::Cage& cage, const verifier::ReferenceSurface& surface) {
  return witnessed_to(cage, surface, witness::kMostLevels);
}

witness::Agreement witnessed_facets(const model::Cage& faceted,
                                    const verifier::ReferenceSurface& surface) {
  return witnessed_to(faceted, surface, 1);
}

verifier::UncertaintyTerm budget_term(const witness::Agreement& witness) {
  return {"reference surface against " + witness.evaluator + ": worst difference found",
          witness.worst_mm, false, true};
}

std::string words_of(const witness::Agreement& witness) {
  std::ostringstream words;
  words << witness.evaluator << ": " << witness.points << " points within " << witness.worst_mm
        << " mm, " << witness.normals << " normals within " << witness.worst_normal_rad << " rad";
  return words.str();
}

}  // namespace limitgauge::app
