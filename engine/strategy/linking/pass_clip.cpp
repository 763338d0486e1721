#include "engine/strategy/linking/pass_clip.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::engine::strategy {
namespace {

/// A polyline in short pieces: piece k runs from points[k] to points[k + 1].
struct Pieces {
  std::vector<Vec3> points;
  std::vector<char> corner;  ///< one a point: a vertex of the polyline itself
  std::vector<char> wanted;  ///< one a piece
  std::size_t count() const { return wanted.size(); }
};

Pieces cut_up(const std::vector<Vec3>& tips, bool closed, const CellMask& wanted) {
  Pieces cut;
  cut.points = {tips.front()};
  cut.corner = {1};
  const std::size_t n = tips.size(), chords = n - (closed ? 0 : 1);
  for (std::size_t i = 0; i < chords; ++i) {
    const Vec3 &a = tips[i], &b = tips[(i + 1) % n];
    const int parts = 1 + static_cast<int>(2 * distance(a, b) / wanted.nodes.pixel_mm);
    for (int k = 1; k <= parts; ++k) {
      const Vec3 p = k == parts ? b : lerp(a, b, static_cast<double>(k) / parts);
      const Vec3 middle = (cut.points.back() + p) * 0.5;
      cut.wanted.push_back(wanted.at(middle.x, middle.y));
      cut.points.push_back(p);
      cut.corner.push_back(k == parts);
    }
  }
  return cut;
}

/// Calls `visit(begin, end)` for every stretch of pieces for which `is(k)` holds.
template <class Is, class Visit>
void for_stretches(std::size_t count, const Is& is, const Visit& visit) {
  for (std::size_t k = 0; k < count;) {
    if (!is(k)) {
      ++k;
      continue;
    }
    const std::size_t begin = k;
    while (k < count && is(k)) ++k;
    visit(begin, k);
  }
}

double length_of(const Pieces& cut, std::size_t begin, std::size_t end) {
  double sum = 0;
  for (std::size_t k = begin; k < end; ++k) sum += distance(cut.points[k], cut.points[k + 1]);
  return sum;
}

double touched_length(const Pieces& cut, std::size_t begin, std::size_t end,
                      const CellMask& touched) {
  double sum = 0;
  for (std::size_t k = begin; k < end; ++k) {
    const Vec3 &a = cut.points[k], &b = cut.points[k + 1];
    if (touched.at((a.x + b.x) / 2, (a.y + b.y) / 2)) sum += distance(a, b);
  }
  return sum;
}

void bridge(Pieces& cut, const BridgeRule& rule) {
  std::vector<char> filled = cut.wanted;
  for_stretches(
      cut.count(), [&](std::size_t k) { return !cut.wanted[k]; },
      [&](std::size_t begin, std::size_t end) {
        const bool inner = begin > 0 && end < cut.count();
        if (inner && length_of(cut, begin, end) <= rule.longest_mm &&
            touched_length(cut, begin, end, rule.touched) <= rule.repeated_mm)
          std::fill(filled.begin() + static_cast<std::ptrdiff_t>(begin),
                    filled.begin() + static_cast<std::ptrdiff_t>(end), 1);
      });
  cut.wanted = std::move(filled);
}

/// Turns a closed polyline so that it starts at piece `k`.
void turn(Pieces& cut, std::size_t k) {
  const auto by = static_cast<std::ptrdiff_t>(k);
  cut.points.pop_back();
  cut.corner.pop_back();
  std::rotate(cut.points.begin(), cut.points.begin() + by, cut.points.end());
  std::rotate(cut.corner.begin(), cut.corner.begin() + by, cut.corner.end());
  std::rotate(cut.wanted.begin(), cut.wanted.begin() + by, cut.wanted.end());
  cut.points.push_back(cut.points.front());
  cut.corner.push_back(cut.corner.front());
}
/// At the first piece that is `wanted` as asked, after one that is `before`.
void start_at(Pieces& cut, bool wanted, bool before) {
  for (std::size_t k = 0, n = cut.count(); k < n; ++k)
    if (cut.wanted[k] == wanted && cut.wanted[(k + n - 1) % n] == before) return turn(cut, k);
}

std::vector<ClippedPass> collect(const Pieces& cut) {
  std::vector<ClippedPass> passes;
  for_stretches(
      cut.count(), [&](std::size_t k) { return cut.wanted[k]; },
      [&](std::size_t begin, std::size_t end) {
        ClippedPass pass;
        for (std::size_t i = begin; i <= end; ++i)
          if (cut.corner[i] || i == begin || i == end) pass.tips.push_back(cut.points[i]);
        passes.push_back(std::move(pass));
      });
  return passes;
}

void drop_steep_middles(Pieces& cut, const SteepClip& steep) {
  const double sine = std::sin(steep.angle_rad);
  const auto is_steep = [&](std::size_t k) {
    const Vec3 way = cut.points[k + 1] - cut.points[k];
    return std::abs(way.z) >= sine * length(way);
  };
  for_stretches(cut.count(), is_steep, [&](std::size_t begin, std::size_t end) {
    const double whole = length_of(cut, begin, end);
    double done = 0;
    for (std::size_t k = begin; k < end; ++k) {
      const double next = done + distance(cut.points[k], cut.points[k + 1]);
      if (done >= steep.overlap_mm && next <= whole - steep.overlap_mm) cut.wanted[k] = 0;
      done = next;
    }
  });
}

}  // namespace

std::vector<ClippedPass> clip_to(const std::vector<Vec3>& tips, bool closed, const CellMask& wanted,
                                 const BridgeRule& rule) {
  if (tips.size() < 2) return {};
  Pieces cut = cut_up(tips, closed, wanted);
  // No gap may touch the seam while gaps are looked at, no stretch when they are collected.
  if (closed) start_at(cut, true, true);
  bridge(cut, rule);
  if (closed) start_at(cut, false, true);
  const bool whole = std::find(cut.wanted.begin(), cut.wanted.end(), 0) == cut.wanted.end();
  if (closed && whole) return {{tips, true}};
  return collect(cut);
}

std::vector<ClippedPass> clip_row(const std::vector<Vec3>& tips, const CellMask& wanted,
                                  const BridgeRule& rule, const SteepClip& steep) {
  if (tips.size() < 2) return {};
  Pieces cut = cut_up(tips, false, wanted);
  bridge(cut, rule);
  drop_steep_middles(cut, steep);
  return collect(cut);
}

}  // namespace limitgauge::engine::strategy
