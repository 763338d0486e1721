#include "verifier/stock_readings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/model/chunks.h"
#include "verifier/closest_point.h"

namespace limitgauge::verifier {
namespace {

using model::Vec3;

/// What two evaluations of the same swept surface may differ by, beyond the projection's residual:
/// both work in double precision, so this is far above rounding and far below any gate.
constexpr double kAgreement_mm = 1e-6;

struct Reading {
  bool counts = false;      ///< has a foot on S whose machining side it faces
  double deviation_mm = 0;  ///< δ − a as this point shows it
  double gouge_mm = 0;      ///< depth of the foot beyond the stock's tangent plane at this point
  double mismatch_mm = 0;   ///< beyond what is allowed for
  SurfacePlace foot;
  Vec3 normal;
};

class Reader {
 public:
  Reader(const SurfaceCells& cells, const RemovedSpace& space, const Certificate& certificate,
         const StageCheck& check)
      : cells_(cells),
        space_(space),
        certificate_(certificate),
        allowance_mm_(check.allowance_mm),
        sight_mm_(sight_mm(certificate, check)) {}

  Reading read(const StockReading& point) {
    Reading out;
    const Nearest removed = space_.nearest(point.position, hint_);
    hint_ = removed.body;
    out.mismatch_mm = std::abs(removed.distance.value) - point.error_mm - kAgreement_mm;
    const Vec3 air = -removed.distance.gradient;
    // The underside of the raw stock faces nothing that a cutter from above is to leave. Upright
    // walls of a mesh are upright within rounding.
    constexpr double kUpright = 1e-6;
    if (space_.is_stock(removed.body) && air.z < -kUpright) return out;
    const auto foot = closest_point(cells_, point.position, sight_mm_);
    if (!foot) return out;
    const double facing = dot(air, foot->normal);
    if (!foot->perpendicular || facing <= 0) return out;
    out.foot = foot->place, out.normal = foot->normal;
    const double side = dot(point.position - out.foot.point, out.normal) >= 0 ? 1 : -1;
    out.deviation_mm = side * foot->distance_mm - allowance_mm_;
    // How far the allowance surface lies beyond the plane of the stock there: no cut from aside,
    // under an edge of S, counts as one from above.
    out.gouge_mm = -out.deviation_mm * facing;
    out.counts = is_certified(out) || is_one_piece(out, point.position);
    return out;
  }

 private:
  /// Far enough to see what the certificate speaks of, and leftovers and holes well away from S.
  static double sight_mm(const Certificate& certificate, const StageCheck& check) {
    const double deepest = std::max(certificate.gouge_mm.high, certificate.uncut_mm.high);
    return std::max(kStockSight_mm, 2 * (check.allowance_mm + deepest) + 10 * check.voxel_mm);
  }
  bool is_certified(const Reading& r) const {
    return r.gouge_mm <= certificate_.gouge_mm.high && r.deviation_mm <= certificate_.uncut_mm.high;
  }
  /// Between the allowance surface and the stock point all is material (of a leftover) or none (of
  /// a gouge): no stock that stands elsewhere over S, with air between, and no floor beside the
  /// part.
  bool is_one_piece(const Reading& r, const Vec3& point) const {
    constexpr int kParts = 8;
    const Vec3 from = r.foot.point + r.normal * allowance_mm_;
    for (int k = 1; k < kParts; ++k) {
      const double delta =
          space_.nearest(lerp(from, point, double(k) / kParts), hint_).distance.value;
      if ((delta > 0) != (r.deviation_mm > 0)) return false;
    }
    return r.deviation_mm > 0 || lies_under_surface(point);
  }
  /// Whether S passes straight above the point. A cutter that reached it took all above it away as
  /// well: with S there, it went through S; without, it came past the rim. (One whose side leans
  /// inwards need not have: then what lies beside S is left to the certificate.) By steps upwards
  /// that are no longer than S is far.
  bool lies_under_surface(Vec3 point) const {
    constexpr double kOn_mm = 1e-6;
    constexpr int kMostSteps = 200;  // enough for walls of 5 degrees; steeper ones count as above
    const double top = cells_.nodes().front().box.high.z;
    for (int step = 0; step < kMostSteps && point.z <= top; ++step) {
      const auto nearest = closest_point(cells_, point, top - point.z + kOn_mm);
      if (!nearest) return false;
      if (nearest->distance_mm <= kOn_mm) return true;
      point.z += nearest->distance_mm;
    }
    return point.z <= top;
  }

  const SurfaceCells& cells_;
  const RemovedSpace& space_;
  const Certificate& certificate_;
  double allowance_mm_, sight_mm_;
  std::optional<BodyRef> hint_;
};

std::string place_text(const Vec3& p) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.4f, %.4f, %.4f)", p.x, p.y, p.z);
  return text;
}

[[noreturn]] void disagree(const Vec3& p, const char* what, double analytic_mm, double voxel_mm) {
  char text[160];
  std::snprintf(text, sizeof text, "%s: analytic instrument %.6f mm, voxel instrument %.6f mm",
                what, analytic_mm, voxel_mm);
  throw InstrumentDisagreement("the two instruments disagree at " + place_text(p) + ": " + text);
}

void require_agreement(const std::vector<Reading>& read, std::span<const StockReading> readings,
                       const RemovedSpace& space) {
  std::size_t worst = 0;
  for (std::size_t i = 0; i < read.size(); ++i)
    if (read[i].mismatch_mm > read[worst].mismatch_mm) worst = i;
  if (read.empty() || read[worst].mismatch_mm <= 0) return;
  const Vec3& p = readings[worst].position;
  disagree(p, "distance of a simulated stock point from the cut surface",
           space.nearest(p).distance.value, readings[worst].error_mm);
}

/// The surface of the stock passes within δ of the witness: the voxel instrument must have seen it.
void require_seen(const Certificate& certificate, std::span<const StockReading> readings,
                  const StageCheck& check) {
  if (!certificate.uncut || readings.empty() || check.voxel_mm <= 0) return;
  const Vec3& at = certificate.uncut->place.point;
  double squared = std::numeric_limits<double>::infinity();
  for (const StockReading& r : readings)
    squared = std::min(squared, length_squared(r.position - at));
  const double expected = certificate.uncut->depth_mm + check.allowance_mm;
  // A voxel that the surface crosses has a point on it within two of its diagonals.
  const double reach = expected + 2 * std::numbers::sqrt3 * check.voxel_mm;
  // Readings further away than they were asked for prove nothing by being absent.
  if (std::sqrt(squared) > reach && reach <= check.readings_within_mm)
    disagree(at, "distance to the cut surface from the certified leftover", expected,
             std::sqrt(squared));
}

/// All within its depth of the deepest gouge has been removed: no point of the stock lies there.
void require_gone(const Certificate& certificate, std::span<const StockReading> readings,
                  const StageCheck& check) {
  if (!certificate.gouge) return;
  const Vec3& at = certificate.gouge->place.point;
  const double gone = certificate.gouge->depth_mm - check.allowance_mm;
  for (const StockReading& r : readings) {
    const double near = distance(r.position, at);
    if (near + r.error_mm + kAgreement_mm < gone)
      disagree(at, "distance of the stock from the certified gouge", gone, near);
  }
}

/// The largest leftover whose foot can be touched.
double largest_reachable(const std::vector<Reading>& read, const ReachQuery& reach) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < read.size(); ++i)
    if (read[i].counts && read[i].deviation_mm > 0) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return read[i].deviation_mm > read[j].deviation_mm;
  });
  for (const std::size_t i : order)
    if (reach.can_be_touched(read[i].foot, read[i].normal)) return read[i].deviation_mm;
  return 0;
}

}  // namespace

VoxelFigures read_stock(const SurfaceCells& cells, const RemovedSpace& space,
                        const ReachQuery& reach, const Certificate& certificate,
                        std::span<const StockReading> readings, const StageCheck& check,
                        const model::RunControl& control) {
  std::vector<Reading> read(readings.size());
  constexpr std::size_t kChunk = 1024;
  model::parallel_chunks(read.size(), kChunk, control, [&](std::size_t begin, std::size_t end) {
    Reader reader(cells, space, certificate, check);
    for (std::size_t i = begin; i < end; ++i) read[i] = reader.read(readings[i]);
  });
  require_agreement(read, readings, space);
  require_seen(certificate, readings, check);
  require_gone(certificate, readings, check);
  VoxelFigures figures;
  for (std::size_t i = 0; i < read.size(); ++i) {
    figures.largest_error_mm = std::max(figures.largest_error_mm, readings[i].error_mm);
    if (read[i].counts) figures.gouge_mm = std::max(figures.gouge_mm, read[i].gouge_mm);
  }
  figures.uncut_mm = largest_reachable(read, reach);
  return figures;
}

}  // namespace limitgauge::verifier
