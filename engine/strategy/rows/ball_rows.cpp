#include "engine/strategy/rows/ball_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "engine/strategy/linking/least_links.h"
#include "engine/strategy/locations/ball_sections.h"
#include "engine/strategy/rows/drive_rows.h"
#include "model/base/chunks.h"
#include "model/geometry/segment.h"
#include "model/geometry/vec3.h"

namespace limitgauge::engine::strategy {
namespace {

/// Distances are taken this much smaller than the cusps tried ask for, so that few rows need
/// halving afterwards.
constexpr double kPrudence = 0.97;
constexpr std::size_t kPairsAChunk = 8, kCentresAChunk = 16;

std::vector<double> with_middles(const std::vector<double>& rows) {
  std::vector<double> all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i > 0) all.push_back((rows[i - 1] + rows[i]) / 2);
    all.push_back(rows[i]);
  }
  return all;
}

/// How far apart rows may be between each two of the rows tried.
std::vector<double> distances_allowed(const BallSections& sections, const CutOptions& cut,
                                      const std::vector<double>& tried,
                                      const model::RunControl& control) {
  const std::vector<CentreRow> rows = rows_at(sections, with_middles(tried), control);
  const double step = cut.step_mm;
  std::vector<double> allowed(tried.size() - 1, step);
  model::parallel_chunks(
      allowed.size(), kPairsAChunk, control, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const double cusp =
              cusp_between(rows[2 * i], rows[2 * i + 1], rows[2 * i + 2], sections.reach_mm());
          const double apart = tried[i + 1] - tried[i];
          const double wanted = kPrudence * apart * std::sqrt(*cut.scallop_mm / cusp);
          if (cusp > 0) allowed[i] = std::clamp(wanted, kClosestShare * step, step);
        }
      });
  return allowed;
}

/// Each row as far from the one before as every interval between them allows.
std::vector<double> placed(const std::vector<double>& tried, const std::vector<double>& allowed) {
  std::vector<double> rows = {tried.front()};
  std::size_t i = 0;
  while (rows.back() < tried.back()) {
    const double from = rows.back();
    while (i + 1 < allowed.size() && tried[i + 1] <= from) ++i;
    double way = allowed[i];
    for (std::size_t k = i + 1; k < allowed.size() && tried[k] < from + way; ++k)
      way = std::min(way, std::max(allowed[k], tried[k] - from));
    rows.push_back(std::min(from + way, tried.back()));
  }
  return rows;
}

/// Puts rows into the middle of pairs whose cusp is too high; whether any was.
bool halve(const BallSections& sections, const CutOptions& cut, std::vector<CentreRow>& rows,
           std::vector<char>& settled, const model::RunControl& control) {
  std::vector<double> middles;
  std::vector<std::size_t> pairs;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    if (settled[i] || rows[i + 1].across_mm - rows[i].across_mm < 2 * kClosestShare * cut.step_mm)
      continue;
    pairs.push_back(i);
    middles.push_back((rows[i].across_mm + rows[i + 1].across_mm) / 2);
  }
  std::vector<CentreRow> between = rows_at(sections, middles, control);
  std::vector<char> needed(pairs.size(), 0);
  model::parallel_chunks(
      pairs.size(), kPairsAChunk, control, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          needed[k] = cusp_between(rows[pairs[k]], between[k], rows[pairs[k] + 1],
                                   sections.reach_mm()) > *cut.scallop_mm;
      });
  std::vector<CentreRow> all;
  std::vector<char> known;
  std::size_t k = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool pair = k < pairs.size() && pairs[k] == i;
    all.push_back(std::move(rows[i]));
    known.push_back(!(pair && needed[k]));
    if (pair && needed[k]) {
      all.push_back(std::move(between[k]));
      known.push_back(0);
    }
    if (pair) ++k;
  }
  rows = std::move(all);
  settled = std::move(known);
  return std::find(needed.begin(), needed.end(), 1) != needed.end();
}

}  // namespace

std::vector<CentreRow> rows_at(const BallSections& sections, const std::vector<double>& across_mm,
                               const model::RunControl& control) {
  std::vector<Envelope> envelopes = sections.envelopes(across_mm, control);
  std::vector<CentreRow> rows;
  for (std::size_t i = 0; i < across_mm.size(); ++i)
    rows.push_back({across_mm[i], std::move(envelopes[i])});
  return rows;
}

std::vector<double> even_rows(const BallSections& sections, double step_mm) {
  const double reach = sections.reach_mm();
  return even_places(sections.low_mm() - reach, sections.high_mm() + reach, step_mm);
}

std::vector<CentreRow> scallop_rows(const BallSections& sections, const CutOptions& cut,
                                    const model::RunControl& control) {
  const std::vector<double> tried = even_rows(sections, cut.step_mm);
  if (tried.size() < 2) return rows_at(sections, tried, control);
  const std::vector<double> allowed = distances_allowed(sections, cut, tried, control);
  std::vector<CentreRow> rows = rows_at(sections, placed(tried, allowed), control);
  std::vector<char> settled(rows.size(), 0);
  while (halve(sections, cut, rows, settled, control)) control.check();
  return rows;
}

namespace {

/// The run, nowhere lower than `floor`.
std::vector<PlanePoint> raised(const std::vector<PlanePoint>& run, double floor) {
  std::vector<PlanePoint> line;
  for (std::size_t i = 0; i < run.size(); ++i) {
    const PlanePoint& b = run[i];
    if (i > 0 && (run[i - 1].z < floor) != (b.z < floor)) {
      const PlanePoint& a = run[i - 1];
      line.push_back({a.s + (b.s - a.s) * ((floor - a.z) / (b.z - a.z)), floor});
    }
    line.push_back({b.s, std::max(b.z, floor)});
  }
  return line;
}

DriveRow tip_row(const CentreRow& row, const StageRequest& request, const DriveFrame& frame,
                 double reduction_mm) {
  const double radius = request.cutter.radius_mm();
  DriveRow tips{row.across_mm, {}};
  for (const auto& run : row.centre.runs) {
    tips.runs.emplace_back();
    for (const PlanePoint& p : least_links(raised(run, request.floor_z_mm + radius), reduction_mm))
      tips.runs.back().push_back(frame.to_part({p.s, row.across_mm, p.z - radius}));
  }
  return tips;
}

using Reduce = std::function<DriveRow(const CentreRow&)>;

/// Rows are reduced as soon as they are cut: few envelopes are held whole.
std::vector<DriveRow> even_tips(const BallSections& sections, const CutOptions& cut,
                                const model::RunControl& control, const Reduce& reduced) {
  const std::vector<double> across = even_rows(sections, cut.step_mm);
  std::vector<DriveRow> rows(across.size());
  sections.each_envelope(across, control, [&](std::size_t plane, Envelope envelope) {
    rows[plane] = reduced({across[plane], std::move(envelope)});
  });
  return rows;
}

/// Cusps are measured between rows as they are cut, so all envelopes are held until the last row
/// has its place.
std::vector<DriveRow> scallop_tips(const BallSections& sections, const CutOptions& cut,
                                   const model::RunControl& control, const Reduce& reduced) {
  const std::vector<CentreRow> centres = scallop_rows(sections, cut, control);
  std::vector<DriveRow> rows(centres.size());
  model::parallel_chunks(rows.size(), kCentresAChunk, control, [&](std::size_t i, std::size_t end) {
    for (; i < end; ++i) rows[i] = reduced(centres[i]);
  });
  return rows;
}

}  // namespace

DriveRows make_ball_rows(const surface::PatchModel& model, const StageRequest& request,
                         const model::RunControl& control, const RowShares& shares,
                         std::size_t most_points) {
  const DriveFrame frame(request.cut.angle_deg);
  const double reduction_mm = shares.reduction * request.cut.tolerance_mm;
  const double bow_mm = shares.bow * request.cut.tolerance_mm;
  const BallSections sections(model, request, frame, reduction_mm + bow_mm, control, most_points);
  const auto reduced = [&](const CentreRow& row) {
    return tip_row(row, request, frame, reduction_mm);
  };
  std::vector<DriveRow> rows = request.cut.scallop_mm
                                   ? scallop_tips(sections, request.cut, control, reduced)
                                   : even_tips(sections, request.cut, control, reduced);
  return {std::move(rows), sections.sampling_intervals()};
}

namespace {

using model::Vec3;
using Run = std::vector<PlanePoint>;

/// Places looked at, as a share of the rows' distance: the cusp's height varies with the surface,
/// over lengths far greater than the distance of rows.
constexpr double kSpacing = 0.25;

bool before(const PlanePoint& p, double s) {
  return p.s < s;
}

/// Height of a row at `s`, the higher one at a step.
std::optional<double> height_at(const Envelope& row, double s) {
  for (const Run& run : row.runs) {
    if (s < run.front().s || s > run.back().s) continue;
    const auto b = std::lower_bound(run.begin(), run.end(), s, before);
    if (b == run.begin() || b->s == s) return b->z;
    const auto a = b - 1;
    return a->z + (b->z - a->z) * ((s - a->s) / (b->s - a->s));
  }
  return std::nullopt;
}

/// Least distance from `p` to the row at places within `window_mm` of `s`: an upper bound of the
/// distance to the whole row.
double distance_to_row(const CentreRow& row, const Vec3& p, double s, double window_mm) {
  double least = std::numeric_limits<double>::infinity();
  const auto at = [&](const PlanePoint& q) { return Vec3{q.s, row.across_mm, q.z}; };
  for (const Run& run : row.centre.runs) {
    auto b = std::lower_bound(run.begin(), run.end(), s - window_mm, before);
    if (b == run.begin()) ++b;
    for (; b != run.end(); ++b) {
      least = std::min(least, distance_to_segment(p, at(*(b - 1)), at(*b)));
      if (b->s > s + window_mm) break;
    }
  }
  return least;
}

/// Rise of the centre's surface across the rows at `s` of the middle one.
std::optional<double> rise_across(const CentreRow& left, const CentreRow& middle,
                                  const CentreRow& right, double s, double z) {
  const auto zl = height_at(left.centre, s), zr = height_at(right.centre, s);
  if (zl && zr) return (*zr - *zl) / (right.across_mm - left.across_mm);
  if (zl) return (z - *zl) / (middle.across_mm - left.across_mm);
  if (zr) return (*zr - z) / (right.across_mm - middle.across_mm);
  return std::nullopt;
}

}  // namespace

double cusp_between(const CentreRow& left, const CentreRow& middle, const CentreRow& right,
                    double reach_mm) {
  const double distance_mm = right.across_mm - left.across_mm, spacing = kSpacing * distance_mm;
  double highest = 0;
  for (const Run& run : middle.centre.runs) {
    const double length = run.back().s - run.front().s;
    const int steps = static_cast<int>(length / spacing);
    for (int i = 1; i < steps; ++i) {
      const double s = run.front().s + length * i / steps;
      const auto z = height_at(middle.centre, s);
      const auto z0 = height_at(middle.centre, s - spacing / 2);
      const auto z1 = height_at(middle.centre, s + spacing / 2);
      if (!z || !z0 || !z1) continue;
      const auto rise = rise_across(left, middle, right, s, *z);
      if (!rise) continue;
      const Vec3 normal = normalized(Vec3{-(*z1 - *z0) / spacing, -*rise, 1});
      const Vec3 touched = Vec3{s, middle.across_mm, *z} - normal * reach_mm;
      const double near = std::min(distance_to_row(left, touched, s, 2 * distance_mm),
                                   distance_to_row(right, touched, s, 2 * distance_mm));
      if (std::isfinite(near)) highest = std::max(highest, near - reach_mm);
    }
  }
  return highest;
}

}  // namespace limitgauge::engine::strategy
