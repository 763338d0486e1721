#include "tests/defects/surfaces/raster.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;

constexpr double kCoarse_mm = 0.5;
constexpr double kChord_mm = 0.00015;
constexpr int kMostHalvings = 6;
/// A cutter that touches with its side only rolls off an edge there: the row ends.
constexpr double kLastOfCorner = 0.95;

class RowTracer {
 public:
  RowTracer(const SampledSurface& surface, const RasterRequest& request)
      : surface_(surface),
        nose_(request.cutter, request.allowance_mm),
        lowest_(surface.surface().bounding_box().low.z - 1),
        across_(request.across) {
    last_rho_ = nose_.flat() + kLastOfCorner * nose_.corner() *
                                   std::sqrt(1 - nose_.wall_sine() * nose_.wall_sine());
  }

  /// The runs of one row between `from` and `to` along it.
  void trace(double across, double from, double to, std::vector<std::vector<Vec3>>& out) {
    at_ = across;
    std::vector<Vec3> run;
    const int steps = static_cast<int>(std::ceil((to - from) / kCoarse_mm));
    std::optional<Vec3> before;
    double before_along = from;
    for (int k = 0; k <= steps; ++k) {
      const double along = from + (to - from) * k / steps;
      const auto tip = touch(along);
      if (tip && !before && k > 0) run.push_back(edge(along, before_along));
      if (tip) run.push_back(*tip);
      if (!tip && before) run.push_back(edge(before_along, along));
      if (!tip || k == steps) close(run, out);
      before = tip, before_along = along;
    }
  }

 private:
  Vec3 point(double along, double z) const {
    return across_ == 0 ? Vec3{at_, along, z} : Vec3{along, at_, z};
  }
  std::optional<Vec3> touch(double along) const {
    const Vec3 p = point(along, 0);
    const auto touched = surface_.drop(nose_, p.x, p.y);
    if (!touched || touched->rho > last_rho_ || touched->tip_z < lowest_) return std::nullopt;
    if (rolls_off_rim(p, touched->place)) return std::nullopt;
    return point(along, touched->tip_z);
  }
  /// Where S ends, a cutter that comes from beyond touches the rim with another normal than S has
  /// there, and passes under it: a gouge along S's own.
  bool rolls_off_rim(const Vec3& axis, const Place& place) const {
    // Twice as much is gouged.
    constexpr double kAside_mm = 5e-5, kLevel = 1e-9;
    if (!surface_.is_on_rim(place)) return false;
    const verifier::SurfaceSample s = surface_.at(place);
    const double level = std::hypot(s.normal.x, s.normal.y);
    if (level < kLevel) return false;
    const double out = nose_.corner() + nose_.flat() / level;
    const double x = s.position.x + s.normal.x * out - axis.x,
                 y = s.position.y + s.normal.y * out - axis.y;
    return std::hypot(x, y) > kAside_mm;
  }
  /// The last tip that touches, between one that does and one that does not.
  Vec3 edge(double touching, double missing) const {
    const auto along_of = [&](const Vec3& p) { return across_ == 0 ? p.y : p.x; };
    Vec3 last = *touch(touching);
    for (double good = touching, bad = missing; std::abs(bad - good) > 1e-4;) {
      const auto tip = touch((good + bad) / 2);
      if (tip)
        last = *tip, good = along_of(*tip);
      else
        bad = (good + bad) / 2;
    }
    return last;
  }
  void close(std::vector<Vec3>& run, std::vector<std::vector<Vec3>>& out) const {
    if (run.size() > 1) {
      std::vector<Vec3> fine = {run.front()};
      for (std::size_t k = 0; k + 1 < run.size(); ++k) halve(run[k], run[k + 1], 0, fine);
      out.push_back(std::move(fine));
    }
    run.clear();
  }
  /// Appends the tips from a (not included) to b, between which every chord clears the surface.
  void halve(const Vec3& a, const Vec3& b, int depth, std::vector<Vec3>& out) const {
    double deepest = 0;
    std::optional<Vec3> middle;
    for (const double t : {0.5, 0.25, 0.75}) {
      const Vec3 chord = lerp(a, b, t);
      const auto tip = surface_.drop(nose_, chord.x, chord.y);
      if (!tip) continue;
      deepest = std::max(deepest, tip->tip_z - chord.z);
      if (t == 0.5) middle = Vec3{chord.x, chord.y, tip->tip_z};
      if (deepest > kChord_mm && depth < kMostHalvings) break;
    }
    if (deepest <= kChord_mm || depth == kMostHalvings || !middle) {
      if (deepest > kChord_mm) out.back().z += deepest;
      out.push_back(b);
      if (deepest > kChord_mm) out.back().z += deepest;
      return;
    }
    halve(a, *middle, depth + 1, out);
    halve(*middle, b, depth + 1, out);
  }

  const SampledSurface& surface_;
  Nose nose_;
  double lowest_ = 0, last_rho_ = 0, at_ = 0;
  int across_ = 0;
};

}  // namespace

Rows gouge_free_rows(const SampledSurface& surface, const RasterRequest& request) {
  const model::Box3 box = surface.surface().bounding_box();
  const Nose nose(request.cutter, request.allowance_mm);
  // The outermost rows still touch the rim of the surface with the edge of the cutter.
  const double reach = nose.flat() + kLastOfCorner * nose.corner() - 1e-4;
  const int across = request.across, along = 1 - across;
  const double low = box.low[across] - reach, high = box.high[across] + reach;
  const int rows = static_cast<int>(std::ceil((high - low) / request.step_mm));
  Rows out{{}, across};
  RowTracer tracer(surface, request);
  for (int k = 0; k <= rows; ++k) {
    std::vector<std::vector<Vec3>> runs;
    tracer.trace(low + (high - low) * k / rows, box.low[along] - reach - kCoarse_mm,
                 box.high[along] + reach + kCoarse_mm, runs);
    if (k % 2 == 1) {
      std::reverse(runs.begin(), runs.end());
      for (auto& run : runs) std::reverse(run.begin(), run.end());
    }
    for (auto& run : runs) out.tips.push_back(std::move(run));
  }
  return out;
}

}  // namespace limitgauge::tests::defects
