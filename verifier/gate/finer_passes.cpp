#include "verifier/gate/finer_passes.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <set>

#include "verifier/gate/findings.h"

namespace limitgauge::verifier {

std::vector<Pass> without(std::span<const Pass> passes, std::span<const std::size_t> left_out) {
  std::vector<Pass> out(passes.begin(), passes.end());
  for (const std::size_t k : left_out) {
    model::Toolpath none;
    none.start = out[k].path->start;
    none.start.z = std::numeric_limits<double>::max();
    out[k].axes.reset();
    out[k].path = std::make_shared<const model::Toolpath>(std::move(none));
  }
  return out;
}

std::vector<Pass> gouging(std::span<const Pass> passes, std::span<const FinerPass> finer) {
  std::vector<std::size_t> left_out;
  for (const FinerPass& f : finer) left_out.push_back(f.pass);
  return without(passes, left_out);
}

namespace {

/// Finer passes with one allowance.
struct FinerLevel {
  double allowance_mm = 0, limit_mm = 0;
  std::vector<std::size_t> still_finer;
};

std::vector<FinerLevel> levels_of(std::span<const FinerPass> finer) {
  std::set<double> allowances;
  for (const FinerPass& f : finer) allowances.insert(f.allowance_mm);
  std::vector<FinerLevel> levels;
  for (const double allowance_mm : allowances) {
    FinerLevel level{allowance_mm, 0, {}};
    for (const FinerPass& f : finer) {
      if (f.allowance_mm == allowance_mm)
        level.limit_mm = std::max(level.limit_mm, f.gouge_limit_mm);
      if (f.allowance_mm < allowance_mm) level.still_finer.push_back(f.pass);
    }
    levels.push_back(std::move(level));
  }
  return levels;
}

std::vector<Finding> findings_below(const FinerScene& scene, const RemovedSpace& space,
                                    const FinerLevel& level, const Certificate& found,
                                    double resolution_mm, const model::RunControl& control) {
  ExceedanceRequest request;
  request.side = Side::gouge;
  request.allowance_mm = level.allowance_mm;
  request.threshold_mm = level.limit_mm;
  request.slack_mm = resolution_mm;
  return gather_findings(find_exceedance(scene.cells, space, nullptr, request, control),
                         found.witness, scene.passes, scene.parts, space);
}

/// All but the still finer passes.
RemovedSpace space_of(const FinerScene& scene, const FinerLevel& level) {
  std::vector<Sweep> parts;
  for (const AssemblySweep& part : scene.parts) parts.push_back(part.sweep);
  return RemovedSpace(scene.raw_stock, without(scene.passes, level.still_finer)).with(parts);
}

CertificateRequest request_of(const FinerScene& scene, const FinerLevel& level) {
  GateLimits limits;
  limits.has_gouge = true, limits.gouge_mm = level.limit_mm;
  CertificateRequest request = scene.request;
  request.allowance_mm = level.allowance_mm;
  request.gouge_limit_mm = level.limit_mm;
  request.resolution_mm = std::min(request.resolution_mm, automatic_resolution_mm(limits));
  return request;
}

}  // namespace

std::vector<Finding> gouge_below_finer(const FinerScene& scene, std::span<const FinerPass> finer,
                                       Certificate& gouge, const model::RunControl& control) {
  std::vector<Finding> findings;
  for (const FinerLevel& level : levels_of(finer)) {
    const RemovedSpace space = space_of(scene, level);
    const CertificateRequest request = request_of(scene, level);
    const Certificate found = certify(scene.cells, space, Side::gouge, nullptr, request, control);
    gouge.cells += found.cells;
    if (found.figure_mm.high <= level.limit_mm) continue;
    const double more_mm = scene.request.allowance_mm - level.allowance_mm;
    gouge.figure_mm.high = std::max(gouge.figure_mm.high, more_mm + found.figure_mm.high);
    gouge.reached_resolution = gouge.reached_resolution && found.reached_resolution;
    if (found.figure_mm.low <= level.limit_mm) continue;
    gouge.figure_mm.low = std::max(gouge.figure_mm.low, more_mm + found.figure_mm.low);
    for (Finding& f : findings_below(scene, space, level, found, request.resolution_mm, control)) {
      f.depth_mm += more_mm;
      findings.push_back(std::move(f));
    }
  }
  return findings;
}

}  // namespace limitgauge::verifier
