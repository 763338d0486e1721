#include "verifier/gate/deviation_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/base/chunks.h"
#include "verifier/certificate/run_bounds.h"
#include "verifier/certificate/run_tracer.h"
#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// Signed run along the normal at a sample. Shorter ones are not held against crossings of S: a
/// surface folded so near to itself is not sampled finely enough to be seen here anyway.
double run_at(const DeviationField::Sample& s, RunBounds& uncut, RunBounds& gouge) {
  constexpr double kShort_mm = 0.02;
  if (!(length_squared(s.normal) > 0)) return 0;
  const double out = uncut.run(s.place.point, s.normal, kShort_mm).length_mm;
  return out > 0 ? out : -gouge.run(s.place.point, s.normal, kShort_mm).length_mm;
}

/// A sample of the same place and normal among the few before, from `first` on: the three patches
/// of a small facet share most of theirs.
std::optional<std::size_t> measured_before(std::span<const DeviationField::Sample> samples,
                                           std::size_t first, std::size_t i) {
  constexpr std::size_t kFew = 8;
  constexpr double kRounding = 1e-12;  // of a unit normal that is worked out from other points
  for (std::size_t k = i; k-- > std::max(first, i - std::min(i, kFew));)
    if (samples[k].place.point == samples[i].place.point &&
        distance(samples[k].normal, samples[i].normal) <= kRounding)
      return k;
  return std::nullopt;
}

/// All that is measured, of another sample of the same place and normal.
void copy_figures(const DeviationField::Sample& from, DeviationField::Sample& to) {
  const SurfacePlace place = to.place;
  const float area_mm2 = to.area_mm2;
  to = from;
  to.place = place, to.area_mm2 = area_mm2;
}

}  // namespace

std::vector<ReachQuery::Touch> measure_field(DeviationField& field, const SurfaceCells& cells,
                                             const Spaces& spaces, const ReachQuery& reach,
                                             std::span<const Pass> passes, double allowance_mm,
                                             const model::RunControl& control) {
  std::vector<ReachQuery::Touch> touches(field.samples.size());
  measure_samples(field, touches, 0, touches.size(), cells, spaces, reach, passes, allowance_mm,
                  control);
  return touches;
}

void measure_samples(DeviationField& field, std::vector<ReachQuery::Touch>& touches,
                     std::size_t begin, std::size_t end, const SurfaceCells& cells,
                     const Spaces& spaces, const ReachQuery& reach, std::span<const Pass> passes,
                     double allowance_mm, const model::RunControl& control) {
  model::parallel_chunks(end - begin, kFieldChunk, control, [&](std::size_t from, std::size_t to) {
    RunBounds uncut(cells, spaces.cut, Side::uncut, allowance_mm);
    RunBounds gouge(cells, spaces.swept, Side::gouge, allowance_mm);
    std::optional<BodyRef> hint;
    for (std::size_t i = begin + from; i < begin + to; ++i) {
      DeviationField::Sample& s = field.samples[i];
      if (const auto same = measured_before(field.samples, begin + from, i)) {
        copy_figures(field.samples[*same], s);
        touches[i] = touches[*same];
        continue;
      }
      const Nearest nearest = uncut.nearest(s.place.point, hint);
      hint = nearest.body;
      s.deviation_mm = static_cast<float>(run_at(s, uncut, gouge));
      s.raw_stock = spaces.cut.is_stock(nearest.body);
      if (!s.raw_stock) {
        s.stage = nearest.body.pass, s.move = spaces.cut.move_of(nearest.body);
        s.line = passes[s.stage].path->moves[s.move].line;
      }
      const auto touch = reach.touch(s.place, s.normal);
      s.reachable = touch.has_value();
      if (touch) touches[i] = *touch;
    }
  });
}

std::optional<StageDeviation::MissingAllowance> missing_allowance(
    const DeviationField& field, const SurfaceCells& cells, const RemovedSpace& raw,
    double allowance_mm, const model::RunControl& control) {
  if (!(allowance_mm > 0)) return std::nullopt;
  std::vector<double> depth_mm(field.samples.size());
  model::parallel_chunks(depth_mm.size(), kFieldChunk, control, [&](std::size_t i, std::size_t to) {
    const RunTracer tracer(cells, raw, std::make_shared<FarPasses>());
    for (; i < to; ++i) {
      const DeviationField::Sample& s = field.samples[i];
      if (!(length_squared(s.normal) > 0)) continue;
      depth_mm[i] =
          tracer.removed(s.place.point, s.normal, allowance_mm, allowance_mm, 0, true).length_mm;
    }
  });
  const auto deepest = std::max_element(depth_mm.begin(), depth_mm.end());
  if (deepest == depth_mm.end() || !(*deepest > kAgreement_mm)) return std::nullopt;
  return StageDeviation::MissingAllowance{*deepest,
                                          field.samples[deepest - depth_mm.begin()].place};
}

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

/// A sample is a distance kept as a float: one that is on a limit but for rounding is within it.
bool within(double deviation_mm, const GateLimits& limits) {
  const double rounding_mm =
      kDistanceRounding_mm + std::numeric_limits<float>::epsilon() * std::abs(deviation_mm);
  return (!limits.has_gouge || -deviation_mm <= limits.gouge_mm + rounding_mm) &&
         (!limits.has_uncut || deviation_mm <= limits.uncut_mm + rounding_mm);
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
