#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/part/measured_points.h"
#include "verifier/gate/deviation.h"
#include "verifier/probe/probe_residual.h"
#include "verifier/probe/zero_shift.h"

/// Points that were measured on a part, held against the simulated stock of a result.
namespace limitgauge::reports::probe {

/// A file that was read, as it was stated.
struct ProbeInput {
  std::string file, sha256;
};

/// A stage whose cutter made the stock.
struct CutBy {
  std::string name, cutter;
  std::size_t moves = 0;
  double chord_error_mm = 0;
};

/// The move whose cutter made the surface nearest to a point.
struct NearestMove {
  std::size_t stage = 0;   ///< index into ProbeResult::stages
  std::size_t move = 0;    ///< index from 0, as in toolpath.vtp
  std::uint32_t line = 0;  ///< of the stage's program
  bool is_rapid = false;
};

struct ProbedPoint {
  model::MeasuredPoint measured;
  verifier::ProbeResidual before;  ///< where it was measured
  verifier::ProbeResidual after;   ///< with the zero shift taken back
  /// That made what is nearest once the shift is taken back; none: the raw stock's own surface.
  std::optional<NearestMove> nearest;
};

/// Expanded uncertainty over standard uncertainty: 95 % of a normal distribution (ISO 14253-1).
inline constexpr double kCoverageFactor = 2;

/// The residuals as measured against a limit, with the uncertainty on the safe side (ISO 14253-1).
struct ResidualGate {
  double limit_mm = 0;
  verifier::Verdict verdict = verifier::Verdict::pass;
  std::size_t beyond = 0;     ///< points that are beyond the limit whatever the uncertainty
  std::size_t undecided = 0;  ///< points that may be
};

struct ProbeResult {
  std::string version;  ///< of this program
  std::string job, result_version;
  ProbeInput result, points_file;
  std::vector<CutBy> stages;  ///< up to the one that the points are held against
  verifier::Verdict stage_verdict = verifier::Verdict::not_run;  ///< in the result
  bool has_uncertainty = false;
  std::vector<std::string> remarks;
  std::vector<ProbedPoint> points;  ///< in the order of the file, at least one
  verifier::ZeroShift shift;
  std::optional<ResidualGate> gate;
};

/// How one point stands to `limit_mm`: `fail` where |residual| exceeds it by more than the expanded
/// uncertainty, `pass` where it stays below by that, else `indeterminate`.
verifier::Verdict standing(const ProbedPoint& point, double limit_mm);
/// All points against the limit.
ResidualGate judged(const std::vector<ProbedPoint>& points, double limit_mm);

}  // namespace limitgauge::reports::probe
