#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "model/base/run_control.h"
#include "reports/probe/probe_result.h"

namespace limitgauge::reports::probe {

/// Points that page and probe.json list, those that are farthest off; probe.csv has all.
inline constexpr std::size_t kMostListed = 200;

/// For a terminal of `width` columns: residuals as measured and after the shift, the zero shift,
/// what is undetermined and why, and the judgement.
std::string probe_table(const ProbeResult& result, bool colour, std::size_t width);
/// probe.csv, RFC 4180: a row a point, in the order of the file. Throws Interrupted.
void write_probe_csv(const ProbeResult& result, const model::RunControl& control,
                     std::ostream& out);
/// probe.json, schema limitgauge.probe/1.
void write_probe_json(const ProbeResult& result, std::ostream& out);
/// probe.html, one self-contained page without a script.
void write_probe_html(const ProbeResult& result, std::ostream& out);

/// The JSON Schema of probe.json.
const std::string& probe_schema();

}  // namespace limitgauge::reports::probe
