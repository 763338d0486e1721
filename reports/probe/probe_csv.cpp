#include <ostream>

#include "model/text/number_text.h"
#include "reports/probe/probe_report.h"
#include "reports/text/text.h"

namespace limitgauge::reports::probe {
namespace {

using model::shortest;

constexpr const char* kProbeHeader =
    "file_line,x_mm,y_mm,z_mm,u_mm,residual_mm,residual_low_mm,residual_high_mm,shifted_mm,"
    "shifted_low_mm,shifted_high_mm,normal_x,normal_y,normal_z,made_by,stage,tool,program_line,"
    "move\r\n";

constexpr std::size_t kRowsAtOnce = 4096;

std::string vector_cells(const model::Vec3& v) {
  return shortest(v.x) + "," + shortest(v.y) + "," + shortest(v.z);
}

std::string residual_cells(const verifier::ProbeResidual& residual) {
  return shortest(residual.gap.value_mm) + "," + shortest(residual.low_mm) + "," +
         (residual.high_mm ? shortest(*residual.high_mm) : std::string());
}

/// A normal of no length is none.
std::string normal_cells(const model::Vec3& normal) {
  return normal == model::Vec3{} ? ",," : vector_cells(normal);
}

std::string nearest_cells(const ProbeResult& result, const ProbedPoint& point) {
  if (!point.nearest) return csv_text_cell("raw stock") + ",,,,";
  const NearestMove& move = *point.nearest;
  const CutBy& stage = result.stages[move.stage];
  return csv_text_cell(move.is_rapid ? "rapid" : "feed") + "," + csv_text_cell(stage.name) + "," +
         csv_text_cell(stage.cutter) + "," + (move.line > 0 ? std::to_string(move.line) : "") +
         "," + std::to_string(move.move);
}

}  // namespace

void write_probe_csv(const ProbeResult& result, const model::RunControl& control,
                     std::ostream& out) {
  out << kProbeHeader;
  for (std::size_t i = 0; i < result.points.size(); ++i) {
    if (i % kRowsAtOnce == 0) control.check();
    const ProbedPoint& point = result.points[i];
    out << point.measured.line << ',' << vector_cells(point.measured.at_mm) << ','
        << (result.has_uncertainty ? shortest(point.measured.u_mm) : std::string()) << ','
        << residual_cells(point.before) << ',' << residual_cells(point.after) << ','
        << normal_cells(point.after.gap.normal) << ',' << nearest_cells(result, point) << "\r\n";
  }
}

}  // namespace limitgauge::reports::probe
