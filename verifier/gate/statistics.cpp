#include "verifier/gate/statistics.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::verifier {
namespace {

constexpr std::size_t kBins = 64;

struct Weighted {
  double value = 0, area = 0;
};

double percentile(const std::vector<Weighted>& sorted, double total, double share) {
  double sum = 0;
  for (const Weighted& w : sorted) {
    sum += w.area;
    if (sum >= share * total) return w.value;
  }
  return sorted.empty() ? 0 : sorted.back().value;
}

/// Equal bins over all but the last thousandth at each end, which the outermost bins take in.
Histogram histogram(const std::vector<Weighted>& sorted, double total) {
  Histogram h;
  if (sorted.empty()) return h;
  double low = percentile(sorted, total, 0.001), high = percentile(sorted, total, 0.999);
  if (!(high > low)) low -= 0.5e-6, high += 0.5e-6;
  h.area_mm2.assign(kBins, 0);
  for (std::size_t k = 0; k <= kBins; ++k)
    h.edges_mm.push_back(low + (high - low) * static_cast<double>(k) / kBins);
  for (const Weighted& w : sorted) {
    const double at = std::floor((w.value - low) / (high - low) * kBins);
    h.area_mm2[static_cast<std::size_t>(std::clamp(at, 0.0, kBins - 1.0))] += w.area;
  }
  h.edges_mm.front() = std::min(low, sorted.front().value);
  h.edges_mm.back() = std::max(high, sorted.back().value);
  return h;
}

bool within(double deviation_mm, const GateLimits& limits) {
  return (!limits.has_gouge || -deviation_mm <= limits.gouge_mm) &&
         (!limits.has_uncut || deviation_mm <= limits.uncut_mm);
}

}  // namespace

void summarize_field(StageDeviation& out, const GateLimits& limits) {
  std::vector<Weighted> reachable;
  double covered = 0, sum = 0, squares = 0;
  out.surface_area_mm2 = out.reachable_area_mm2 = 0;
  for (const DeviationField::Sample& s : out.field.samples) {
    const Weighted w{static_cast<double>(s.deviation_mm), static_cast<double>(s.area_mm2)};
    out.surface_area_mm2 += w.area;
    if (!s.reachable) continue;
    out.reachable_area_mm2 += w.area;
    if (within(w.value, limits)) covered += w.area;
    sum += w.value * w.area, squares += w.value * w.value * w.area;
    reachable.push_back(w);
  }
  out.unreachable_area_mm2 = out.surface_area_mm2 - out.reachable_area_mm2;
  if (reachable.empty()) return;
  std::sort(reachable.begin(), reachable.end(),
            [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  const double total = out.reachable_area_mm2;
  out.coverage = covered / total;
  out.mean_mm = sum / total;
  out.rms_mm = std::sqrt(squares / total);
  out.p01_mm = percentile(reachable, total, 0.01);
  out.p50_mm = percentile(reachable, total, 0.50);
  out.p99_mm = percentile(reachable, total, 0.99);
  out.histogram = histogram(reachable, total);
}

}  // namespace limitgauge::verifier
