#include "simulator/instrument/dexel_tile.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "simulator/sweep/vector_loops.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t patch_of(int line) {
  const int i = line % DexelTile::kEdge, j = line / DexelTile::kEdge;
  return static_cast<std::size_t>(j / DexelPatches::kEdge * DexelPatches::kASide +
                                  i / DexelPatches::kEdge);
}

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

constexpr int kLanes = DexelPatches::kEdge;
using PatchEnds = std::array<double, std::size_t{kLanes} * kLanes>;

/// What was taken from every eighth line, so that a register takes several lines at once.
struct LaneRemoval {
  std::array<double, kLanes> length{}, deepest{}, across_low, across_high, along_low, along_high;
  std::array<double, kLanes> unclear{};  ///< not zero: lines are left to be looked at

  LaneRemoval() {
    across_low.fill(kInfinity), along_low.fill(kInfinity);
    across_high.fill(-kInfinity), along_high.fill(-kInfinity);
  }
};

/// Lines of a patch: of the first, places across and along the move, and by how much these grow.
struct PatchPlaces {
  double across, across_x, across_y, along, along_x, along_y;
};

// Down from the top and not through the interval: what nearly all moves do. Where that is not so,
// the line is left as it is, and `unclear` is raised.
LIMITGAUGE_WIDE
void lower_tops(const double* __restrict low, double least_upper, const PatchPlaces& at,
                const double* __restrict bottom, double* __restrict top, LaneRemoval& all) {
  const double across_x = at.across_x;
  LaneRemoval sum = all;
  for (int j = 0; j < kLanes; ++j) {
    const double across = at.across + j * at.across_y;
    const int line = j * DexelTile::kEdge;
    for (int k = 0; k < kLanes; ++k) {
      const double before = top[line + k], to = low[j * kLanes + k];
      const double v = across + k * across_x;
      const bool hit = to < before - kDexelRounding_mm;
      const bool plain = (least_upper >= before) & (to > bottom[line + k] + kDexelRounding_mm);
      const double after = (hit & plain) ? to : kInfinity,
                   taken = (hit & plain) ? before - to : 0.0;
      const double v_low = (hit & plain) ? v : kInfinity, v_high = (hit & plain) ? v : -kInfinity;
      const double left = (hit & !plain) ? 1.0 : 0.0;
      top[line + k] = std::min(before, after);
      sum.unclear[k] += left;
      sum.length[k] += taken;
      sum.deepest[k] = std::max(sum.deepest[k], taken);
      sum.across_low[k] = std::min(sum.across_low[k], v_low);
      sum.across_high[k] = std::max(sum.across_high[k], v_high);
    }
  }
  all = sum;
}

// Places along the move of the lines that lose something: wanted of vertical moves alone.
void note_along(const double* low, const PatchPlaces& at, const double* top, LaneRemoval& sum) {
  for (int j = 0; j < kLanes; ++j)
    for (int k = 0; k < kLanes; ++k) {
      if (!(low[j * kLanes + k] < top[j * DexelTile::kEdge + k] - kDexelRounding_mm)) continue;
      const double u = at.along + k * at.along_x + j * at.along_y;
      sum.along_low[k] = std::min(sum.along_low[k], u);
      sum.along_high[k] = std::max(sum.along_high[k], u);
    }
}

// Adds up what a sweep takes from patch after patch.
class Cutting {
 public:
  Cutting(DexelTile& tile, const DexelFrame& frame, const DexelSweep& sweep)
      : tile_(tile), frame_(frame), sweep_(sweep) {}

  void patch(std::size_t k);
  TileRemoval removal() const;

 private:
  PatchPlaces places(double x, double y) const;
  void lower_ends(double x, double y, int line, PatchEnds& low) const;
  void take(int line, double x, double y, double low);

  DexelTile& tile_;
  const DexelFrame& frame_;
  const DexelSweep& sweep_;
  LaneRemoval sum_;
};

// The line, by all its intervals.
void Cutting::take(int line, double x, double y, double low) {
  if (!(low < tile_.top[line] - kDexelRounding_mm)) return;
  const auto taken = sweep_.interval(x, y);
  if (!taken) return;
  std::vector<model::Interval> material = tile_.material(line);
  const double removed = subtract(material, *taken);
  if (removed == 0) return;
  tile_.set_material(line, material);
  const double across = sweep_.across(x, y), along = sweep_.along(x, y);
  sum_.length[0] += removed, sum_.deepest[0] = std::max(sum_.deepest[0], removed);
  sum_.across_low[0] = std::min(sum_.across_low[0], across);
  sum_.across_high[0] = std::max(sum_.across_high[0], across);
  sum_.along_low[0] = std::min(sum_.along_low[0], along);
  sum_.along_high[0] = std::max(sum_.along_high[0], along);
}

PatchPlaces Cutting::places(double x, double y) const {
  const double across = sweep_.across(x, y), along = sweep_.along(x, y);
  return {
      across, sweep_.across(x + frame_.dx, y) - across, sweep_.across(x, y + frame_.dy) - across,
      along,  sweep_.along(x + frame_.dx, y) - along,   sweep_.along(x, y + frame_.dy) - along};
}

void Cutting::lower_ends(double x, double y, int line, PatchEnds& low) const {
  static_assert(DexelSweep::kSquare == kLanes);
  if (sweep_.of_ball()) return sweep_.ball_ends(x, y, frame_.dx, frame_.dy, low.data());
  for (int j = 0; j < kLanes; ++j)
    sweep_.lower_ends(x, y + j * frame_.dy, frame_.dx, kLanes,
                      &tile_.top[line + j * DexelTile::kEdge], &low[j * kLanes]);
}

// Planes that lie over the tops do so when these are lower: a patch is looked at anew only where
// its plane let pass a move that took nothing.
void Cutting::patch(std::size_t k) {
  const auto i = static_cast<int>(k) % DexelPatches::kASide * kLanes;
  const auto j = static_cast<int>(k) / DexelPatches::kASide * kLanes;
  const int line = DexelTile::line(i, j);
  const double x = frame_.x + i * frame_.dx, y = frame_.y + j * frame_.dy;
  PatchEnds low;
  lower_ends(x, y, line, low);
  const PatchPlaces at = places(x, y);
  const auto before = sum_.length;
  if (sweep_.vertical()) note_along(low.data(), at, &tile_.top[line], sum_);
  lower_tops(low.data(), sweep_.least_upper(), at, &tile_.bottom[line], &tile_.top[line], sum_);
  if (std::any_of(sum_.unclear.begin(), sum_.unclear.end(), [](double u) { return u > 0; })) {
    for (int n = 0; n < kLanes * kLanes; ++n)
      take(line + n / kLanes * DexelTile::kEdge + n % kLanes, x + n % kLanes * frame_.dx,
           y + n / kLanes * frame_.dy, low[n]);
    sum_.unclear.fill(0);
  }
  if (sum_.length != before)
    tile_.patches.changed(k);
  else
    tile_.patches.lay(k, tile_.top.data(), frame_);
}

TileRemoval Cutting::removal() const {
  TileRemoval r;
  for (const double length : sum_.length) r.length_mm += length;
  if (r.length_mm == 0) return r;
  const auto least = [](const auto& lanes) {
    return *std::min_element(lanes.begin(), lanes.end());
  };
  const auto most = [](const auto& lanes) { return *std::max_element(lanes.begin(), lanes.end()); };
  r.deepest_mm = most(sum_.deepest);
  r.across_low = static_cast<float>(least(sum_.across_low));
  r.across_high = static_cast<float>(most(sum_.across_high));
  r.along_low = static_cast<float>(least(sum_.along_low));
  r.along_high = static_cast<float>(most(sum_.along_high));
  return r;
}

}  // namespace

DexelTile::DexelTile() {
  top.fill(-kInfinity), bottom.fill(-kInfinity);
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
  patches.forget(patch_of(line));
}

double DexelTile::length(int line) const {
  double sum = empty(line) ? 0.0 : top[line] - bottom[line];
  if (!others.empty())
    for (const model::Interval& m : others[line]) sum += m.high - m.low;
  return sum;
}

double DexelTile::highest() const {
  return *std::max_element(top.begin(), top.end());
}

std::size_t DexelTile::memory_bytes() const {
  std::size_t bytes = sizeof *this + others.capacity() * sizeof others[0];
  for (const auto& line : others) bytes += line.capacity() * sizeof line[0];
  return bytes;
}

TileRemoval cut(DexelTile& tile, const DexelFrame& frame, const DexelSweep& sweep) {
  std::uint32_t touched = tile.patches.touched(sweep, frame);
  if (touched == 0) return {};
  Cutting cutting(tile, frame, sweep);
  for (; touched != 0; touched &= touched - 1)
    cutting.patch(static_cast<std::size_t>(std::countr_zero(touched)));
  return cutting.removal();
}

}  // namespace limitgauge::simulator
