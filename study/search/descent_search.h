#pragma once

#include "study/search/section_search.h"

namespace limitgauge::study {

/// Of several axes, or of one without an order: every combination where there are no more than
/// cases, else a Latin hypercube, COBYLA and a pattern search. Throws what Trials::run throws.
SearchEnd descent_search(Trials& trials, const Plan& plan);

/// Goes on from the best row by COBYLA along the ordered axes, with at most `cases` more.
void constrained_descent(Trials& trials, std::size_t cases);

}  // namespace limitgauge::study
