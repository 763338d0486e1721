#pragma once

#include <optional>
#include <vector>

#include "study/search/analysis.h"

namespace limitgauge::study {

/// The responses of `figures` (into Table::figures) to every key that shows one, key by key; those
/// that go through a row do so through `reference`.
std::vector<Response> responses(const Plan& plan, const Table& table,
                                const std::vector<std::size_t>& figures,
                                std::optional<std::size_t> reference);

/// For each of `figures` its responses by falling change; those alike by key.
std::vector<Ranking> rankings(const std::vector<Response>& all,
                              const std::vector<std::size_t>& figures);

}  // namespace limitgauge::study
