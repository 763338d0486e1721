#include "app/probe/probe_points.h"

#include <utility>

#include "model/base/chunks.h"
#include "model/text/message_text.h"
#include "verifier/probe/probe_residual.h"
#include "verifier/probe/zero_shift.h"

namespace limitgauge::app {
namespace {

using reports::probe::ProbedPoint;
using reports::probe::ProbeResult;

constexpr std::size_t kProbedChunk = 64;

std::optional<reports::probe::NearestMove> nearest_move(const ResultStock& stock,
                                                        verifier::BodyRef body) {
  if (stock.removed.is_stock(body)) return std::nullopt;
  const std::uint32_t index = stock.removed.move_of(body);
  const model::Move& move = stock.passes[body.pass].path->moves[index];
  return reports::probe::NearestMove{body.pass, index, move.line,
                                     move.kind == model::MoveKind::rapid};
}

std::string ignored_words(const std::vector<std::string>& columns) {
  std::string names;
  for (const std::string& column : columns)
    names += (names.empty() ? "" : ", ") + model::in_quotes(column);
  return "columns of the points' file that were passed over: " + names;
}

void measure_before(const ResultStock& stock, const model::RunControl& control,
                    std::vector<ProbedPoint>& points) {
  parallel_chunks(points.size(), kProbedChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      points[i].before = probe_residual(stock.removed, points[i].measured.at_mm);
  });
}

void measure_after(const ResultStock& stock, const model::Vec3& shift_mm,
                   const model::RunControl& control, std::vector<ProbedPoint>& points) {
  parallel_chunks(points.size(), kProbedChunk, control, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      points[i].after = probe_residual(stock.removed, points[i].measured.at_mm - shift_mm);
      points[i].nearest = nearest_move(stock, points[i].after.gap.body);
    }
  });
}

verifier::ZeroShift fitted(const ResultStock& stock, const ProbeResult& result,
                           const model::RunControl& control) {
  std::vector<double> u_mm;
  if (result.has_uncertainty)
    for (const ProbedPoint& point : result.points) u_mm.push_back(point.measured.u_mm);
  verifier::FitProblem problem;
  problem.points = result.points.size();
  problem.u_mm = u_mm;
  problem.gap = [&](std::size_t i, const model::Vec3& shift_mm) {
    const ProbedPoint& point = result.points[i];
    const verifier::SurfaceGap gap =
        surface_gap(stock.removed, point.measured.at_mm - shift_mm, point.before.gap.body);
    return verifier::FitGap{gap.value_mm, gap.normal};
  };
  return *fit_zero_shift(problem, control);
}

}  // namespace

ProbeResult probe_points(const ResultStock& stock, const model::MeasuredPoints& measured,
                         const ProbeWatch& watch) {
  ProbeResult result;
  result.job = stock.job;
  result.result_version = stock.version;
  result.stage_verdict = stock.verdict;
  result.stages = stock.stages;
  result.remarks = stock.remarks;
  result.has_uncertainty = measured.has_uncertainty;
  if (!measured.ignored.empty()) result.remarks.push_back(ignored_words(measured.ignored));
  for (const model::MeasuredPoint& point : measured.points)
    result.points.push_back({point, {}, {}, {}});
  watch.phase("certifying residuals");
  measure_before(stock, watch.control, result.points);
  watch.phase("fitting the zero shift");
  result.shift = fitted(stock, result, watch.control);
  watch.phase("certifying what is left");
  measure_after(stock, result.shift.shift_mm, watch.control, result.points);
  return result;
}

}  // namespace limitgauge::app
