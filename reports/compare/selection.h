#pragma once

#include <string_view>

#include "reports/compare/comparison.h"

namespace limitgauge::reports::compare {

/// Whether `id` is judged with these options.
bool is_judged(const Options& options, std::string_view id);
/// `judgement` where `id` is judged.
Judgement if_judged(const Options& options, std::string_view id, Judgement judgement);

}  // namespace limitgauge::reports::compare
