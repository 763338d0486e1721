#include "tests/reports/sample_probe.h"

#include <cmath>
#include <functional>

namespace limitgauge::reports {
namespace {

using model::Vec3;
using probe::ProbedPoint;
using probe::ProbeResult;

/// The face that point i lies on, and how far it is off.
struct Measured {
  Vec3 normal;
  double off_mm = 0;
};
using MeasuredAt = std::function<Measured(std::size_t i)>;

/// A scatter that is the same on every machine: −1 to 1.
double scatter(std::size_t i) {
  return std::sin(12.9898 * static_cast<double>(i + 1));
}

verifier::ProbeResidual residual(const Measured& at, const Vec3& shift_mm) {
  verifier::ProbeResidual out;
  out.gap.normal = at.normal;
  out.gap.value_mm = at.off_mm - dot(at.normal, shift_mm);
  out.low_mm = out.gap.value_mm - 1e-9;
  out.high_mm = out.gap.value_mm + 1e-9;
  return out;
}

ProbeResult held_against(std::size_t points, double u_mm, const MeasuredAt& at) {
  ProbeResult result;
  result.version = "0.1.0";
  result.result_version = "0.1.0";
  result.job = "plate";
  result.result = {"plate", std::string(64, 'a')};
  result.points_file = {"plate.csv", std::string(64, 'b')};
  result.stages = {{"rough", "flat:D=12,L=20", 40, 0}, {"finish", "ball:D=6,L=20", 900, 2e-4}};
  result.stage_verdict = verifier::Verdict::pass;
  result.has_uncertainty = u_mm > 0;
  verifier::FitProblem problem;
  const std::vector<double> u(points, u_mm);
  problem.points = points;
  if (u_mm > 0) problem.u_mm = u;
  problem.gap = [&](std::size_t i, const Vec3& shift_mm) {
    const verifier::ProbeResidual one = residual(at(i), shift_mm);
    return verifier::FitGap{one.gap.value_mm, one.gap.normal};
  };
  result.shift = *fit_zero_shift(problem, {1});
  for (std::size_t i = 0; i < points; ++i) {
    const double x = static_cast<double>(i);
    ProbedPoint& point = result.points.emplace_back();
    point.measured = {{x, 0.5 * x, -3}, u_mm, static_cast<int>(i) + 2};
    point.before = residual(at(i), {});
    point.after = residual(at(i), result.shift.shift_mm);
    if (i % 11 != 10) point.nearest = {{i % 2, i, static_cast<std::uint32_t>(i + 5), i % 7 == 6}};
  }
  return result;
}

}  // namespace

ProbeResult sample_probe(std::size_t points) {
  return held_against(points, 3e-4, [](std::size_t i) {
    constexpr double kShift_mm[] = {0.003, -0.004, 0};
    Measured at;
    at.normal[static_cast<int>(i % 3)] = 1;
    at.off_mm = kShift_mm[i % 3] + 4e-4 * scatter(i);
    return at;
  });
}

ProbeResult floor_probe(std::size_t points) {
  return held_against(points, 0, [](std::size_t i) {
    return Measured{{0, 0, 1}, 0.002 + 4e-4 * scatter(i)};
  });
}

ProbeResult slanted_probe(std::size_t points) {
  return held_against(points, 3e-4, [](std::size_t i) {
    return Measured{{0.6, 0.8, 0}, 0.01 + 4e-4 * scatter(i)};
  });
}

ProbeResult hostile_probe() {
  const std::string evil = "<img src=x onerror=window.hostile=1>";
  ProbeResult result = sample_probe(30);
  result.job = result.result_version = result.result.file = result.points_file.file = evil;
  for (probe::CutBy& stage : result.stages) stage.name = stage.cutter = evil;
  result.remarks = {evil};
  result.points[3].before.high_mm.reset();
  result.points[3].after.high_mm.reset();
  result.gate = probe::judged(result.points, 0.01);
  return result;
}

}  // namespace limitgauge::reports
