#include "simulator/instrument/turning_removal.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "model/base/chunks.h"
#include "simulator/sweep/sweep_index.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Interval;
using model::Vec3;

/// What one move took from one line.
struct TakenFromLine {
  std::uint32_t move = 0;
  double length_mm = 0;
  Vec3 foot;
};

/// What stands in `before` and not in `after`; both ascending.
std::vector<Interval> taken(const std::vector<Interval>& before,
                            const std::vector<Interval>& after) {
  std::vector<Interval> all;
  for (const Interval& m : before) {
    double from = m.low;
    for (const Interval& left : after) {
      if (left.high <= from || left.low >= m.high) continue;
      if (left.low > from) all.push_back({from, left.low});
      from = left.high;
    }
    if (from < m.high) all.push_back({from, m.high});
  }
  return all;
}

/// Of one line, by moves.
std::vector<TakenFromLine> taken_from(const SweepIndex& sweep, const Vec3& foot,
                                      const std::vector<Interval>& pieces, double step_mm) {
  std::map<std::uint32_t, double> by_move;
  for (const Interval& piece : pieces) {
    const double length = piece.high - piece.low;
    if (length < kThin_mm) continue;
    const auto count = static_cast<int>(std::ceil(length / step_mm));
    for (int k = 0; k < count; ++k) {
      const Vec3 p{foot.x, foot.y, piece.low + length * (k + 0.5) / count};
      if (const auto first = sweep.own().first_below(sweep.to_own(p), kTakenOver_mm))
        by_move[*first] += length / count;
    }
  }
  std::vector<TakenFromLine> all;
  for (const auto& [move, length] : by_move) all.push_back({move, length, foot});
  return all;
}

/// Sums of one move.
struct MoveSums {
  double length_mm = 0, deepest_mm = 0;
  Interval across{1, 0}, along{1, 0};

  void add(const TakenFromLine& t, const Vec3& from, const Vec3& way) {
    const double level = std::hypot(way.x, way.y);
    const double ux = level > kLeastRun_mm ? way.x / level : 1,
                 uy = level > kLeastRun_mm ? way.y / level : 0;
    const Vec3 q = t.foot - from;
    widen(across, q.y * ux - q.x * uy), widen(along, q.x * ux + q.y * uy);
    length_mm += t.length_mm;
    deepest_mm = std::max(deepest_mm, t.length_mm);
  }
  static void widen(Interval& range, double at) {
    if (range.low > range.high) range = {at, at};
    range.low = std::min(range.low, at), range.high = std::max(range.high, at);
  }
};

MoveRemoval removal_of(const model::Toolpath& path, std::size_t i, const MoveSums& sums,
                       double cell_mm2, double spacing_mm, double widest_mm) {
  MoveRemoval removal;
  if (sums.length_mm == 0) return removal;
  const Vec3 way = path.moves[i].to - move_from(path, i);
  removal.volume_mm3 = sums.length_mm * cell_mm2;
  removal.axial_mm = sums.deepest_mm;
  const model::Move& m = path.moves[i];
  if (m.kind == model::MoveKind::feed && m.feed_mm_min > 0 && length(way) > 0)
    removal.rate_mm3_min = removal.volume_mm3 * m.feed_mm_min / length(way);
  double width = sums.across.high - sums.across.low;
  if (std::hypot(way.x, way.y) <= kLeastRun_mm)
    width = std::max(width, sums.along.high - sums.along.low);
  removal.radial_mm = std::min(width + spacing_mm, widest_mm);
  return removal;
}

}  // namespace

Removal turning_removal(const DexelStock& before, const DexelStock& after, const Pass& pass,
                        const model::RunControl& control) {
  if (!pass.axes) throw std::invalid_argument("a pass without axes is cut by lines");
  if (before.nx() != after.nx() || before.ny() != after.ny() ||
      before.line_at(0, 0) != after.line_at(0, 0))
    throw std::invalid_argument("lines before and after a pass that are not the same");
  const SweepIndex sweep(pass, control);
  const double spacing = after.spacing_mm();
  const auto rows = static_cast<std::size_t>(after.ny());
  std::vector<std::vector<TakenFromLine>> found(rows);
  model::parallel_chunks(rows, 1, control, [&](std::size_t row, std::size_t) {
    const int j = static_cast<int>(row);
    for (int i = 0; i < after.nx(); ++i) {
      const auto some = taken_from(sweep, after.line_at(i, j),
                                   taken(before.material(i, j), after.material(i, j)), spacing);
      found[row].insert(found[row].end(), some.begin(), some.end());
    }
  });
  const model::Toolpath& path = *pass.path;
  std::vector<MoveSums> sums(path.moves.size());
  for (const auto& row : found)
    for (const TakenFromLine& t : row)
      sums[t.move].add(t, pass.pose.point(move_from(path, t.move)),
                       pass.pose.direction(path.moves[t.move].to - move_from(path, t.move)));
  const Vec3 apart = after.line_at(1, 1) - after.line_at(0, 0);
  Removal removal;
  for (std::size_t i = 0; i < sums.size(); ++i)
    removal.moves.push_back(removal_of(path, i, sums[i], apart.x * apart.y, spacing,
                                       2 * sweep.own().profile().largest_radius()));
  removal.totals = removal_totals(path, removal.moves, spacing);
  return removal;
}

}  // namespace limitgauge::simulator
