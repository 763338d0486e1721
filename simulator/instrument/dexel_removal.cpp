#include "simulator/instrument/dexel_removal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "simulator/instrument/dexel_tile.h"

namespace limitgauge::simulator {
namespace {

constexpr double kMostLines = 4e6, kMostVisits = 1.5e9;
constexpr double kLinesPerRadius = 5, kLeastLinesPerSide = 20;
constexpr double kStretchSpacings = 10;

double length_of(const model::Toolpath& path, std::size_t i) {
  return distance(move_from(path, i), path.moves[i].to);
}

bool timed(const model::Move& move) {
  return move.kind == model::MoveKind::feed && move.feed_mm_min > 0;
}

/// A run of consecutive feed moves that grows at its end and shrinks at its start.
struct Stretch {
  std::size_t first = 0;
  double volume_mm3 = 0, length_mm = 0, time_min = 0;

  void add(double volume, double length, double feed, double sign) {
    volume_mm3 += sign * volume, length_mm += sign * length, time_min += sign * length / feed;
  }
  void note(RemovalTotals& totals) const {
    if (!(time_min > 0) || !(volume_mm3 / time_min > totals.largest_rate_mm3_min)) return;
    totals.largest_rate_mm3_min = volume_mm3 / time_min;
    totals.largest_rate_move = first;
  }
};

void find_largest_rate(const model::Toolpath& path, const std::vector<MoveRemoval>& moves,
                       RemovalTotals& totals) {
  const double least = kStretchSpacings * totals.spacing_mm;
  Stretch stretch;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!timed(path.moves[i])) {
      // What ends here without having become long enough is taken as it is.
      if (stretch.length_mm < least) stretch.note(totals);
      stretch = {};
      stretch.first = i + 1;
      continue;
    }
    stretch.add(moves[i].volume_mm3, length_of(path, i), path.moves[i].feed_mm_min, 1);
    for (; stretch.first < i; ++stretch.first) {
      const double drop = length_of(path, stretch.first);
      if (stretch.length_mm - drop < least) break;
      stretch.add(moves[stretch.first].volume_mm3, drop, path.moves[stretch.first].feed_mm_min, -1);
    }
    if (stretch.length_mm >= least) stretch.note(totals);
  }
  if (stretch.length_mm < least) stretch.note(totals);
}

/// Area over which a cutter passes, summed over the moves, mm²: lines visited times their cell.
double covered_mm2(const Pass& pass, const DexelProfile& profile) {
  const double r = profile.largest_radius();
  double sum = 0;
  for (std::size_t i = 0; i < pass.path->moves.size(); ++i)
    sum += 2 * r * model::level_distance(move_from(*pass.path, i), pass.path->moves[i].to);
  return sum + std::numbers::pi * r * r * static_cast<double>(pass.path->moves.size());
}

}  // namespace

RemovalTotals removal_totals(const model::Toolpath& path, const std::vector<MoveRemoval>& moves,
                             double spacing_mm) {
  RemovalTotals totals;
  totals.spacing_mm = spacing_mm;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const MoveRemoval& m = moves[i];
    totals.volume_mm3 += m.volume_mm3;
    if (path.moves[i].kind != model::MoveKind::feed) continue;
    totals.largest_axial_mm = std::max(totals.largest_axial_mm, m.axial_mm);
    totals.largest_radial_mm = std::max(totals.largest_radial_mm, m.radial_mm);
    if (m.volume_mm3 > 0) continue;
    const double length_mm = length_of(path, i);
    totals.air_length_mm += length_mm;
    if (timed(path.moves[i])) totals.air_time_s += 60 * length_mm / path.moves[i].feed_mm_min;
  }
  find_largest_rate(path, moves, totals);
  return totals;
}

double removal_spacing_mm(double voxel_mm, const model::Stock& stock,
                          const std::vector<Pass>& passes) {
  const model::Vec3 size = bounding_box(stock).size();
  double radius = std::numeric_limits<double>::infinity(), covered = 0;
  for (const Pass& pass : passes) {
    const DexelProfile profile(pass.cutter);
    radius = std::min(radius, profile.largest_radius());
    covered = std::max(covered, covered_mm2(pass, profile));
  }
  const double for_visits = std::min(std::sqrt(covered / kMostVisits), radius / kLinesPerRadius);
  const double for_lines = std::sqrt(size.x * size.y / kMostLines);
  return std::min(std::max({voxel_mm, for_visits, for_lines}),
                  std::max(size.x, size.y) / kLeastLinesPerSide);
}

double removal_bytes(const model::Stock& stock, double spacing_mm, std::size_t moves) {
  const model::Vec3 size = bounding_box(stock).size();
  const double edge = DexelTile::kEdge * spacing_mm;
  const double tiles = std::ceil(size.x / edge) * std::ceil(size.y / edge);
  return 2 * tiles * sizeof(DexelTile) + static_cast<double>(moves) * sizeof(MoveRemoval) +
         static_cast<double>(kDexelWindowBytes);
}

}  // namespace limitgauge::simulator
