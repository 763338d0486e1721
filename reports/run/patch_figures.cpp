#include "reports/run/patch_figures.h"

#include <algorithm>
#include <map>

#include "reports/tolerance.h"

namespace limitgauge::reports {
namespace {

void add(PatchFigures& figures, const verifier::DeviationField::Sample& sample) {
  ++figures.samples;
  figures.area_mm2 += sample.area_mm2;
  figures.gouge_mm = std::max(figures.gouge_mm, -double(sample.deviation_mm));
  if (sample.reachable) {
    figures.uncut_mm = std::max(figures.uncut_mm, double(sample.deviation_mm));
  } else {
    figures.unreachable_mm2 += sample.area_mm2;
  }
}

/// How often a limit holds `mm`; any gouge is far beyond a limit of zero.
double times(double mm, double limit_mm) {
  return mm / std::max(limit_mm, kZeroLimit_mm);
}

double badness(const PatchFigures& f, const verifier::GateLimits& limits) {
  if (!limits.has_gouge && !limits.has_uncut) return std::max(f.gouge_mm, f.uncut_mm);
  return std::max(limits.has_gouge ? times(f.gouge_mm, limits.gouge_mm) : 0.0,
                  limits.has_uncut ? times(f.uncut_mm, limits.uncut_mm) : 0.0);
}

}  // namespace

std::vector<PatchFigures> patch_figures(const verifier::DeviationField& field,
                                        const verifier::GateLimits& limits, int together) {
  std::map<int, PatchFigures> by_patch;
  for (const verifier::DeviationField::Sample& sample : field.samples)
    add(by_patch[sample.place.patch / together * together], sample);
  std::vector<PatchFigures> all;
  for (auto& [patch, figures] : by_patch) {
    figures.patch = patch;
    all.push_back(figures);
  }
  std::stable_sort(all.begin(), all.end(), [&](const PatchFigures& a, const PatchFigures& b) {
    return badness(a, limits) > badness(b, limits);
  });
  return all;
}

}  // namespace limitgauge::reports
