#include "simulator/instrument/dexel_tile.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// `intervals` less `taken`, and how much that was.
double subtract(std::vector<model::Interval>& intervals, const model::Interval& taken) {
  std::vector<model::Interval> left;
  double before = 0, after = 0;
  for (const model::Interval& m : intervals) {
    before += m.high - m.low;
    for (const model::Interval part : {model::Interval{m.low, std::min(m.high, taken.low)},
                                       model::Interval{std::max(m.low, taken.high), m.high}}) {
      if (part.high - part.low < kDexelRounding_mm) continue;
      left.push_back(part);
      after += part.high - part.low;
    }
  }
  if (before - after < kDexelRounding_mm) return 0;
  intervals = std::move(left);
  return before - after;
}

// Adds up what a sweep takes from line after line.
class Cutting {
 public:
  Cutting(DexelTile& tile, const DexelFrame& frame, const DexelSweep& sweep)
      : tile_(tile), frame_(frame), sweep_(sweep) {}

  void row(int j);
  const TileRemoval& removal() const { return removal_; }

 private:
  double take(int line, double x, double y, double low);
  void note_place(double x, double y);
  void cut_lines(int first, int n, int j);

  DexelTile& tile_;
  const DexelFrame& frame_;
  const DexelSweep& sweep_;
  TileRemoval removal_;
};

// Places across and along the move are linear in x: the outermost lines of a row tell them.
void Cutting::note_place(double x, double y) {
  const auto across = static_cast<float>(sweep_.across(x, y));
  const auto along = static_cast<float>(sweep_.along(x, y));
  TileRemoval& r = removal_;
  if (r.length_mm == 0) r.across_low = r.across_high = across, r.along_low = r.along_high = along;
  r.across_low = std::min(r.across_low, across), r.across_high = std::max(r.across_high, across);
  r.along_low = std::min(r.along_low, along), r.along_high = std::max(r.along_high, along);
}

double Cutting::take(int line, double x, double y, double low) {
  double& top = tile_.top[line];
  // Down from the top and not through the interval: what nearly all moves do.
  if (sweep_.least_upper() >= top && low > tile_.bottom[line] + kDexelRounding_mm) {
    const double removed = top - low;
    top = low;
    return removed;
  }
  const auto taken = sweep_.interval(x, y);
  if (!taken) return 0;
  std::vector<model::Interval> material = tile_.material(line);
  const double removed = subtract(material, *taken);
  if (removed > 0) tile_.set_material(line, material);
  return removed;
}

void Cutting::row(int j) {
  const double y = frame_.y + j * frame_.dy;
  if (sweep_.least_lower(y) >= tile_.row_top[j]) return;
  const model::Interval span = sweep_.row(y);
  const double from = std::max(0.0, std::ceil((span.low - frame_.x) / frame_.dx - kLineOnEdge));
  const double to = std::min(DexelTile::kEdge - 1.0,
                             std::floor((span.high - frame_.x) / frame_.dx + kLineOnEdge));
  if (!(from <= to)) return;
  cut_lines(static_cast<int>(from), static_cast<int>(to - from) + 1, j);
}

void Cutting::cut_lines(int first, int n, int j) {
  const int line0 = DexelTile::line(first, j);
  const double x0 = frame_.x + first * frame_.dx, y = frame_.y + j * frame_.dy;
  const double* top = &tile_.top[line0];
  std::array<double, DexelTile::kEdge> low;
  sweep_.lower_ends(x0, y, frame_.dx, n, top, low.data());
  // Which lines lose something is as good as random: collected without branches.
  std::array<int, DexelTile::kEdge> hit;
  int hits = 0;
  for (int i = 0; i < n; ++i) hit[hits] = i, hits += low[i] < top[i] - kDexelRounding_mm;
  double sum = 0, deepest = 0, first_x = 0, last_x = 0;
  for (int h = 0; h < hits; ++h) {
    const double x = x0 + hit[h] * frame_.dx;
    const double removed = take(line0 + hit[h], x, y, low[hit[h]]);
    if (removed == 0) continue;
    if (sum == 0) first_x = x;
    last_x = x, sum += removed, deepest = std::max(deepest, removed);
  }
  if (sum == 0) return;
  note_place(first_x, y);
  removal_.length_mm += sum;
  note_place(last_x, y);
  removal_.deepest_mm = std::max(removal_.deepest_mm, deepest);
  const double* row = &tile_.top[DexelTile::line(0, j)];
  tile_.row_top[j] = *std::max_element(row, row + DexelTile::kEdge);
}

}  // namespace

DexelTile::DexelTile() {
  top.fill(-kInfinity), bottom.fill(-kInfinity), row_top.fill(-kInfinity);
}

std::vector<model::Interval> DexelTile::material(int line) const {
  std::vector<model::Interval> all;
  if (!others.empty()) all = others[line];
  if (!empty(line)) all.push_back({bottom[line], top[line]});
  return all;
}

void DexelTile::set_material(int line, const std::vector<model::Interval>& intervals) {
  const bool none = intervals.empty();
  top[line] = none ? -kInfinity : intervals.back().high;
  bottom[line] = none ? -kInfinity : intervals.back().low;
  if (intervals.size() > 1 && others.empty()) others.resize(kLines);
  if (!others.empty())
    others[line].assign(intervals.begin(), none ? intervals.end() : intervals.end() - 1);
  double& highest = row_top[line / kEdge];
  highest = std::max(highest, top[line]);
}

double DexelTile::length(int line) const {
  double sum = empty(line) ? 0.0 : top[line] - bottom[line];
  if (!others.empty())
    for (const model::Interval& m : others[line]) sum += m.high - m.low;
  return sum;
}

double DexelTile::highest() const {
  return *std::max_element(row_top.begin(), row_top.end());
}

std::size_t DexelTile::memory_bytes() const {
  std::size_t bytes = sizeof *this + others.capacity() * sizeof others[0];
  for (const auto& line : others) bytes += line.capacity() * sizeof line[0];
  return bytes;
}

TileRemoval cut(DexelTile& tile, const DexelFrame& frame, const DexelSweep& sweep) {
  Cutting cutting(tile, frame, sweep);
  const double first = std::ceil((sweep.lowest_y() - frame.y) / frame.dy);
  const double last = std::floor((sweep.highest_y() - frame.y) / frame.dy);
  const int from = static_cast<int>(std::clamp(first, 0.0, DexelTile::kEdge - 1.0));
  const int to = static_cast<int>(std::clamp(last, -1.0, DexelTile::kEdge - 1.0));
  for (int j = from; j <= to; ++j) cutting.row(j);
  return cutting.removal();
}

}  // namespace limitgauge::simulator
