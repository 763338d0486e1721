#pragma once

#include "reports/sarif/places.h"

namespace limitgauge::reports::sarif {

/// The level that SARIF gives a finding: "error", "warning" or "note".
const char* level_of(Significance significance);
/// One entry of "results". `ordinal` counts findings with the same fingerprint, from 1.
Json result_entry(const RunResult& result, const ListedFinding& finding, const Places& places,
                  int ordinal);
/// An entry for what no place explains: the stage's program as a whole.
Json stage_entry(const RunResult& result, std::size_t stage, const char* rule, const char* level,
                 const std::string& message, const Places& places);

}  // namespace limitgauge::reports::sarif
