#pragma once

#include <string>

#include "model/part/cage.h"
#include "verifier/gate/deviation.h"
#include "verifier/surface/reference_surface.h"
#include "witness/agreement.h"

namespace limitgauge::app {

/// Holds the reference surface against OpenSubdiv's on the cage that it was made of. Throws
/// verifier::InstrumentDisagreement where they differ by more than their errors: no verdict may
/// rest on either.
witness::Agreement witnessed(const model::Cage& cage, const verifier::ReferenceSurface& surface);
/// The same of facets and their faceted cage, at the corners of the patches: within a facet, the
/// two do not share their parameters.
witness::Agreement witnessed_facets(const model::Cage& faceted,
                                    const verifier::ReferenceSurface& surface);

/// The line of the uncertainty budget that states it.
verifier::UncertaintyTerm budget_term(const witness::Agreement& witness);

/// "OpenSubdiv 3.5.0: 1,234 points within 1.2e-14 mm, 1,200 normals within 3e-13 rad".
std::string words_of(const witness::Agreement& witness);

}  // namespace limitgauge::app
