#include "simulator/instrument/dexel_cut.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

// A window of moves is closed when it holds so many visits of tiles; one move more may be in it.
constexpr std::size_t kWindowVisits = std::size_t{1} << 20, kWindowMoves = kWindowVisits / 4;

void merge(TileRemoval& sum, const TileRemoval& part) {
  if (part.length_mm == 0) return;
  if (sum.length_mm == 0) {
    sum = part;
    return;
  }
  sum.length_mm += part.length_mm;
  sum.deepest_mm = std::max(sum.deepest_mm, part.deepest_mm);
  sum.across_low = std::min(sum.across_low, part.across_low);
  sum.across_high = std::max(sum.across_high, part.across_high);
  sum.along_low = std::min(sum.along_low, part.along_low);
  sum.along_high = std::max(sum.along_high, part.along_high);
}

/// First and last of a range of tiles or lines; empty where first > last.
struct Range {
  int first, last;
};

class PassCut {
 public:
  PassCut(const DexelLattice& lattice, DexelTiles& tiles, const Pass& pass,
          const model::RunControl& control)
      : lattice_(lattice),
        tiles_(tiles),
        path_(*pass.path),
        control_(control),
        profile_(pass.cutter),
        own_(tiles.size()),
        start_(tiles.size() + 1),
        top_(tiles.size()) {
    for (std::size_t t = 0; t < tiles.size(); ++t) top_[t] = tiles[t]->highest();
  }

  std::vector<MoveRemoval> run();

 private:
  struct Visit {
    std::uint32_t tile, move;  // the move counts from the window's first
  };
  DexelSweep sweep(std::size_t move) const {
    return {profile_, move_from(path_, move), path_.moves[move].to};
  }
  std::size_t fill_window(std::size_t first);
  void add_visits(const DexelSweep& sweep, std::uint32_t move);
  void sort_visits();
  void cut_window(std::size_t first, std::size_t end);
  void cut_tile(std::size_t tile, std::size_t first);
  Range lines(double low, double high, double corner, double step, int n) const;
  MoveRemoval finished(std::size_t move, const TileRemoval& sum) const;

  const DexelLattice& lattice_;
  DexelTiles& tiles_;
  const model::Toolpath& path_;
  const model::RunControl& control_;
  DexelProfile profile_;
  std::vector<std::shared_ptr<DexelTile>> own_;  // tiles that have been cut
  std::vector<Visit> visits_;
  std::vector<std::uint32_t> moves_;  // of the visits, by tile and then in order
  std::vector<std::uint32_t> start_;  // where a tile's visits begin in it
  std::vector<TileRemoval> taken_;    // by the visits
  std::vector<double> top_;           // of each tile's material
};

Range PassCut::lines(double low, double high, double corner, double step, int n) const {
  // A line on the edge may be missed by rounding: it would lose nothing but rounding.
  const double first = std::max(0.0, std::ceil((low - corner) / step - 0.5 - kLineOnEdge));
  const double last = std::min(n - 1.0, std::floor((high - corner) / step - 0.5 + kLineOnEdge));
  if (!(first <= last)) return {0, -1};
  return {static_cast<int>(first), static_cast<int>(last)};
}

void PassCut::add_visits(const DexelSweep& sweep, std::uint32_t move) {
  constexpr int kEdge = DexelTile::kEdge;
  const Range rows =
      lines(sweep.lowest_y(), sweep.highest_y(), lattice_.corner.y, lattice_.dy, lattice_.ny);
  if (rows.first > rows.last) return;
  for (int ty = rows.first / kEdge; ty <= rows.last / kEdge; ++ty) {
    const double y0 = lattice_.line_at(0, std::max(rows.first, ty * kEdge)).y;
    const double y1 = lattice_.line_at(0, std::min(rows.last, ty * kEdge + kEdge - 1)).y;
    const model::Interval span = sweep.span(y0, y1);
    const Range columns = lines(span.low, span.high, lattice_.corner.x, lattice_.dx, lattice_.nx);
    if (columns.first > columns.last) continue;
    for (int tx = columns.first / kEdge; tx <= columns.last / kEdge; ++tx) {
      const std::size_t tile = lattice_.tile(tx, ty);
      if (sweep.lowest_tip() < top_[tile])
        visits_.push_back({static_cast<std::uint32_t>(tile), move});
    }
  }
}

std::size_t PassCut::fill_window(std::size_t first) {
  visits_.clear();
  std::size_t end = first;
  while (end < path_.moves.size() && end - first < kWindowMoves && visits_.size() < kWindowVisits)
    add_visits(sweep(end), static_cast<std::uint32_t>(end - first)), ++end;
  return end;
}

void PassCut::sort_visits() {
  std::fill(start_.begin(), start_.end(), 0);
  for (const Visit& v : visits_) ++start_[v.tile + 1];
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  moves_.resize(visits_.size());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (const Visit& v : visits_) moves_[next[v.tile]++] = v.move;
}

void PassCut::cut_tile(std::size_t tile, std::size_t first) {
  if (!own_[tile]) own_[tile] = std::make_shared<DexelTile>(*tiles_[tile]);
  const auto columns = static_cast<std::size_t>(lattice_.tiles_x);
  const DexelFrame frame =
      lattice_.frame(static_cast<int>(tile % columns), static_cast<int>(tile / columns));
  for (std::size_t k = start_[tile]; k < start_[tile + 1]; ++k)
    taken_[k] = cut(*own_[tile], frame, sweep(first + moves_[k]));
  top_[tile] = own_[tile]->highest();
}

void PassCut::cut_window(std::size_t first, std::size_t end) {
  sort_visits();
  taken_.resize(visits_.size());
  std::vector<std::size_t> busy;
  for (std::size_t t = 0; t < tiles_.size(); ++t)
    if (start_[t] < start_[t + 1]) busy.push_back(t);
  // The busiest first, so that no thread is left with one at the end.
  std::stable_sort(busy.begin(), busy.end(), [&](std::size_t a, std::size_t b) {
    return start_[a + 1] - start_[a] > start_[b + 1] - start_[b];
  });
  std::atomic<std::size_t> done{0};
  model::parallel_for(busy.size(), control_.threads, [&](std::size_t i) {
    control_.check();
    cut_tile(busy[i], first);
    const double part = static_cast<double>(++done) / static_cast<double>(busy.size());
    control_.report((static_cast<double>(first) + part * static_cast<double>(end - first)) /
                    static_cast<double>(path_.moves.size()));
  });
}

MoveRemoval PassCut::finished(std::size_t move, const TileRemoval& sum) const {
  if (sum.length_mm == 0) return {};
  const model::Move& m = path_.moves[move];
  const model::Vec3& from = move_from(path_, move);
  MoveRemoval removal;
  removal.volume_mm3 = sum.length_mm * lattice_.cell_mm2();
  removal.axial_mm = sum.deepest_mm;
  const double length = distance(from, m.to);
  if (m.kind == model::MoveKind::feed && m.feed_mm_min > 0 && length > 0)
    removal.rate_mm3_min = removal.volume_mm3 * m.feed_mm_min / length;
  double width = double{sum.across_high} - double{sum.across_low};
  if (sweep(move).vertical())
    width = std::max(width, double{sum.along_high} - double{sum.along_low});
  removal.radial_mm =
      std::min(width + std::max(lattice_.dx, lattice_.dy), 2 * profile_.largest_radius());
  return removal;
}

std::vector<MoveRemoval> PassCut::run() {
  std::vector<MoveRemoval> removals(path_.moves.size());
  std::vector<TileRemoval> sums;
  for (std::size_t first = 0; first < path_.moves.size();) {
    control_.check();
    const std::size_t end = fill_window(first);
    cut_window(first, end);
    sums.assign(end - first, {});
    for (std::size_t k = 0; k < moves_.size(); ++k) merge(sums[moves_[k]], taken_[k]);
    for (std::size_t i = first; i < end; ++i) removals[i] = finished(i, sums[i - first]);
    first = end;
  }
  for (std::size_t t = 0; t < tiles_.size(); ++t)
    if (own_[t]) tiles_[t] = std::move(own_[t]);
  control_.report(1);
  return removals;
}

}  // namespace

std::vector<MoveRemoval> cut_tiles(const DexelLattice& lattice, DexelTiles& tiles, const Pass& pass,
                                   const model::RunControl& control) {
  return PassCut(lattice, tiles, pass, control).run();
}

}  // namespace limitgauge::simulator
