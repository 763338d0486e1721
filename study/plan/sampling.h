#pragma once

#include <vector>

#include "study/plan/plan.h"

namespace limitgauge::study {

/// plan.samples settings of all variables, drawn independently, no two alike.
std::vector<std::vector<Setting>> random_samples(const Plan& plan);

/// plan.samples settings of all variables, no two alike. Each range is cut into as many strata of
/// equal share, each of which has one sample; counted settings occur equally often, give or take
/// one. Where all variables are counted and more than half of all combinations are asked for, they
/// are drawn from those instead.
std::vector<std::vector<Setting>> latin_hypercube_samples(const Plan& plan);

/// Number of combinations of counted settings; nothing where a variable cannot be counted or there
/// are too many to tell.
std::optional<std::size_t> combinations(const Plan& plan);

}  // namespace limitgauge::study
