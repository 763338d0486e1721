#pragma once

#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>
#include <utility>

#include "reports/record/json_value.h"
#include "reports/record/run_record.h"

namespace limitgauge::reports::record {

/// Reads result.json, schema limitgauge.result/1 or /2; `shown` names it in errors. Keys that it
/// does not know are left alone. Throws model::InputError with line and column for text that is no
/// JSON, and naming the key for one that is missing, of another type or out of its range.
RunRecord read_result_json(std::istream& in, const std::string& shown);

/// The text of the program lines that a result holds, by stage and line.
using LineTexts = std::map<std::pair<std::string, std::uint32_t>, std::string>;

/// What of a result says how its stages are read.
struct StageContext {
  int schema = 2;
  bool has_design = true;  ///< the result has a "surface"
  /// The result says what its process was checked by: then it gathers what is wrong with it, too.
  bool has_process = false;
  const LineTexts& texts;
};
/// One entry of `stages`.
StageRecord read_stage(const JsonValue& stage, const StageContext& run);
/// `pass`, `fail`, `indeterminate` or `not_run`.
verifier::Verdict read_verdict(const JsonValue& value);

/// `robust` of the `deviation` of the stage `name`.
RobustMeasures read_robust(const JsonValue& robust, const std::string& name,
                           const LineTexts& texts);
/// `tolerances` of a run.
model::Tolerances read_tolerances(const JsonValue& tolerances);

/// The places of `gouges`, `uncuts` or `missing_stocks` of the stage `name`.
std::vector<Place> read_places(const std::vector<JsonValue>& findings, const std::string& name,
                               const LineTexts& texts);
/// Where a figure over tolerances is reached; nothing of a figure that names no place.
std::optional<Place> read_reached(const JsonValue& figure, const std::string& name,
                                  const LineTexts& texts);
/// What is wrong with the process; of results that need not gather it, from the two lists of
/// collisions where they do not.
std::vector<ProcessFinding> read_process(const JsonValue& simulation, const std::string& name,
                                         const StageContext& run);
/// Moves of each kind, by name.
std::vector<ProcessCount> count_process(const std::vector<ProcessFinding>& findings);

}  // namespace limitgauge::reports::record
