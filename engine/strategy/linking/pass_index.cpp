#include "engine/strategy/linking/pass_index.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

bool before(const PassIndex::Near& a, const PassIndex::Near& b) {
  return std::tie(a.squared_mm2, a.start.pass, a.start.point) <
         std::tie(b.squared_mm2, b.start.pass, b.start.point);
}

/// Keeps the best start of each pass.
void keep(std::vector<PassIndex::Near>& found, const PassIndex::Near& near) {
  for (PassIndex::Near& other : found)
    if (other.start.pass == near.start.pass) {
      if (before(near, other)) other = near;
      return;
    }
  found.push_back(near);
}

}  // namespace

PassIndex::PassIndex(const std::vector<CutPass>& passes) : alive_(passes.size(), 1) {
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < passes.size(); ++i) {
    if (passes[i].tips.empty()) {
      alive_[i] = 0;
      continue;
    }
    ++left_;
    add_starts(passes[i], static_cast<int>(i), entries);
  }
  for (const Entry& e : entries) box_.add(e.at);
  if (entries.empty()) return;
  constexpr double kSmallest_mm = 1e-3;
  const Vec3 size = box_.size();
  const double count = static_cast<double>(entries.size());
  // About one start a bin, however long and narrow the box.
  bin_mm_ =
      std::max({kSmallest_mm, std::sqrt(size.x * size.y / count), size.x / count, size.y / count});
  columns_ = 1 + static_cast<int>(size.x / bin_mm_);
  rows_ = 1 + static_cast<int>(size.y / bin_mm_);
  bins_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (const Entry& e : entries)
    bins_[static_cast<std::size_t>(row(e.at.y)) * columns_ + column(e.at.x)].push_back(e);
}

void PassIndex::add_starts(const CutPass& pass, int index, std::vector<Entry>& entries) const {
  const int last = static_cast<int>(pass.tips.size()) - 1;
  if (pass.closed) {
    for (int i = 0; i <= last; ++i) entries.push_back({pass.tips[i], {index, i, false}});
    return;
  }
  entries.push_back({pass.tips.front(), {index, 0, false}});
  if (pass.reversible && last > 0) entries.push_back({pass.tips.back(), {index, last, true}});
}

void PassIndex::remove(int pass) {
  left_ -= alive_[pass];
  alive_[pass] = 0;
}

int PassIndex::column(double x) const {
  return std::clamp(static_cast<int>(std::floor((x - box_.low.x) / bin_mm_)), 0, columns_ - 1);
}
int PassIndex::row(double y) const {
  return std::clamp(static_cast<int>(std::floor((y - box_.low.y) / bin_mm_)), 0, rows_ - 1);
}

void PassIndex::look_in(int at_column, int at_row, const Vec3& from, std::vector<Near>& found) {
  if (at_column < 0 || at_column >= columns_ || at_row < 0 || at_row >= rows_) return;
  auto& bin = bins_[static_cast<std::size_t>(at_row) * columns_ + at_column];
  std::erase_if(bin, [&](const Entry& e) { return !alive_[e.start.pass]; });
  for (const Entry& e : bin) keep(found, {model::length_squared(e.at - from), e.start});
}

void PassIndex::look_around(int ring, const Vec3& from, std::vector<Near>& found) {
  const int c = column(from.x), r = row(from.y);
  for (int j = -ring; j <= ring; ++j) {
    const int step = std::abs(j) == ring || ring == 0 ? 1 : 2 * ring;
    for (int i = -ring; i <= ring; i += step) look_in(c + i, r + j, from, found);
  }
}

std::vector<PassIndex::Near> PassIndex::nearest(const Vec3& from, std::size_t count) {
  std::vector<Near> found;
  if (bins_.empty()) return found;
  for (int ring = 0; ring <= std::max(columns_, rows_); ++ring) {
    // What lies beyond the rings looked at is at least that far; `from` may lie outside the bins,
    // from where all of them are still farther.
    const double beyond = (ring - 1) * bin_mm_;
    std::sort(found.begin(), found.end(), before);
    if (found.size() >= count && ring > 0 && found[count - 1].squared_mm2 < beyond * beyond) break;
    look_around(ring, from, found);
  }
  std::sort(found.begin(), found.end(), before);
  if (found.size() > count) found.resize(count);
  return found;
}

}  // namespace limitgauge::engine::strategy
