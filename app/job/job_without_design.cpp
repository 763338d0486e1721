#include "app/job/job_parts.h"
#include "app/toml/toml_table.h"

namespace limitgauge::app {
namespace {

constexpr const char* kRemedy =
    "it only in a job with [surface]; without one programs are cut and judged by what happens on "
    "the way";

constexpr const char* kGateKeys[] = {"gouge", "uncut", "coverage", "unreachable", "unavoidable"};

void refuse_gate(const toml::table& table) {
  const TomlTable gate(table, "[stage.gate]", {}, kGateKeys);
  for (const char* key : kGateKeys)
    if (gate.has(key))
      throw model::InputError(gate.place(key),
                              "\"" + std::string(key) +
                                  "\" in [stage.gate] limits what is measured against a surface, "
                                  "and the job has no [surface]",
                              kRemedy);
}

/// The stage's own reader has said what its other keys are.
void refuse_in_stage(const toml::table& stage) {
  const auto place = [&](const char* key) { return place_of(stage.get(key)->source()); };
  if (stage.contains("strategy"))
    throw model::InputError(place("strategy"),
                            "stage \"" + stage["name"].value_or(std::string()) +
                                "\" is to be planned, and the job has no [surface] to plan it for",
                            "a [surface] with the design, or \"program\" instead of \"strategy\"");
  if (stage.contains("allowance"))
    throw model::InputError(place("allowance"),
                            "\"allowance\" is material above a surface, and the job has no "
                            "[surface]",
                            kRemedy);
  if (const toml::table* gate = stage["gate"].as_table()) refuse_gate(*gate);
}

}  // namespace

void refuse_design_keys(const TomlTable& root) {
  if (root.has("verification"))
    throw model::InputError(root.place("verification"),
                            "[verification] is of what is measured against a surface, and the job "
                            "has no [surface]",
                            kRemedy);
  for (const toml::table* stage : root.tables("stage")) refuse_in_stage(*stage);
}

}  // namespace limitgauge::app
