#include "engine/surface/offset_model.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace limitgauge::engine::surface {
namespace {

Grid sampled_grid(const LimitPatch& limit, int depth, double offset_mm) {
  const int stride = limit.cells() >> depth, cells = 1 << depth;
  Grid grid{cells + 1, cells + 1, {}};
  grid.points.reserve(static_cast<std::size_t>(cells + 1) * static_cast<std::size_t>(cells + 1));
  for (int v = 0; v <= cells; ++v)
    for (int u = 0; u <= cells; ++u) {
      const int i = limit.index(u * stride, v * stride);
      grid.points.push_back(limit.points[i] + limit.normals[i] * offset_mm);
    }
  return grid;
}

/// A value between its ends, so that a straight edge stays monotone under rounding.
double between(double a, double b, double t) {
  return std::clamp(a + (b - a) * t, std::min(a, b), std::max(a, b));
}

/// Lays the finer points of `side` onto the chords of every `ratio`th, each onto the place nearest
/// to it, so that it moves across the chord only.
void straighten(Grid& grid, int side, int ratio) {
  const int cells = grid.columns - 1;
  double share = 0;
  for (int t = 0; t < cells; ++t) {
    const int rest = t % ratio;
    if (rest == 0) {
      share = 0;
      continue;
    }
    const Vec3 a = grid.points[side_index(side, t - rest, cells)];
    const Vec3 b = grid.points[side_index(side, t - rest + ratio, cells)];
    Vec3& point = grid.points[side_index(side, t, cells)];
    const double square = length_squared(b - a);
    if (square > 0) share = std::clamp(dot(point - a, b - a) / square, share, 1.0);
    point = {between(a.x, b.x, share), between(a.y, b.y, share), between(a.z, b.z, share)};
  }
}

/// Chains of all patches and where their ends meet.
class Merger {
 public:
  Merger(const PatchModel& model, const OffsetModel& sampled) : model_(model), sampled_(sampled) {}

  void add(int patch, const std::vector<SectionChain>& chains) {
    for (const SectionChain& chain : chains) {
      const int id = static_cast<int>(pieces_.size());
      pieces_.push_back(&chain);
      used_.push_back(false);
      if (chain.closed) continue;
      meet(patch, chain.first, {id, false});
      meet(patch, chain.last, {id, true});
    }
  }

  std::vector<SectionCurve> curves() {
    std::vector<SectionCurve> merged;
    for (const bool open_only : {true, false})
      for (std::size_t id = 0; id < pieces_.size(); ++id) {
        if (used_[id]) continue;
        if (pieces_[id]->closed) {
          used_[id] = true;
          merged.push_back({pieces_[id]->points, true});
          continue;
        }
        const bool free_start = !partner({static_cast<int>(id), false});
        const bool free_end = !partner({static_cast<int>(id), true});
        if (open_only && !free_start && !free_end) continue;
        merged.push_back(follow(static_cast<int>(id), !free_start && free_end));
      }
    return merged;
  }

 private:
  struct End {
    int piece = 0;
    bool last = false;
    friend auto operator<=>(const End&, const End&) = default;
  };
  using Key = std::pair<Index, int>;

  /// Both sides of an edge see the same coarse segment crossed once.
  void meet(int patch, const SectionEnd& at, End end) {
    const Index h = model_.patches()[patch].first_half_edge + at.side;
    if (model_.ends_at(h)) return;
    const Index twin = model_.outer().twin[h];
    const int own = sampled_.depths[patch], other = sampled_.depths[model_.patch_at(twin)];
    const int cells = 1 << own;
    int along = at.side < 2 ? at.segment : cells - 1 - at.segment;
    if (h > twin) along = cells - 1 - along;
    const Key key{model_.outer().edge[h], along >> std::max(0, own - other)};
    const auto [place, fresh] = waiting_.try_emplace(key, end);
    if (fresh) return;
    joined_[place->second] = end;
    joined_[end] = place->second;
    waiting_.erase(place);
  }

  std::optional<End> partner(End end) const {
    const auto found = joined_.find(end);
    return found == joined_.end() ? std::nullopt : std::optional(found->second);
  }

  static void append(SectionCurve& curve, const SectionChain& chain, bool reversed) {
    const std::size_t skip = curve.points.empty() ? 0 : 1;
    if (reversed)
      curve.points.insert(curve.points.end(), chain.points.rbegin() + skip, chain.points.rend());
    else
      curve.points.insert(curve.points.end(), chain.points.begin() + skip, chain.points.end());
  }

  SectionCurve follow(int id, bool reversed) {
    SectionCurve curve;
    const int start = id;
    for (;;) {
      used_[id] = true;
      append(curve, *pieces_[id], reversed);
      const auto next = partner({id, !reversed});
      if (!next) return curve;
      if (next->piece == start) break;
      id = next->piece;
      reversed = next->last;
    }
    curve.closed = true;
    curve.points.pop_back();
    return curve;
  }

  const PatchModel& model_;
  const OffsetModel& sampled_;
  std::vector<const SectionChain*> pieces_;
  std::vector<bool> used_;
  std::map<Key, End> waiting_;
  std::map<End, End> joined_;
};

}  // namespace

OffsetModel sample_offset(const PatchModel& model, double offset_mm, double error_mm) {
  OffsetModel sampled;
  const int patches = static_cast<int>(model.patches().size());
  const Sampling sampling = model.sampling_for(error_mm, offset_mm > 0);
  sampled.depths = sampling.depths;
  sampled.excess_mm =
      std::max(0.0, (offset_mm > 0 ? sampling.offset_mm : sampling.limit_mm) - error_mm);
  for (int p = 0; p < patches; ++p) {
    const LimitPatch& limit = model.patches()[p].limit;
    sampled.grids.push_back(sampled_grid(limit, sampled.depths[p], offset_mm));
    if (offset_mm > 0)
      for (const LimitPatch& corner : model.patches()[p].corners)
        sampled.corners.push_back(sampled_grid(corner, corner.depth, offset_mm));
    const int interval = 1 << (limit.depth - sampled.depths[p]);
    sampled.intervals.push_back(interval);
    sampled.interval_min = p == 0 ? interval : std::min(sampled.interval_min, interval);
    sampled.interval_max = std::max(sampled.interval_max, interval);
  }
  for (int p = 0; p < patches; ++p)
    for (int side = 0; side < 4; ++side) {
      const Index h = model.patches()[p].first_half_edge + side;
      if (model.ends_at(h)) continue;
      const int other = model.patch_at(model.outer().twin[h]);
      const int finer_by = sampled.depths[p] - sampled.depths[other];
      if (finer_by > 0) straighten(sampled.grids[p], side, 1 << finer_by);
    }
  return sampled;
}

std::vector<SectionCurve> section(const PatchModel& model, const OffsetModel& sampled,
                                  const AxisPlane& plane) {
  SectionScratch scratch;
  std::vector<std::vector<SectionChain>> chains(sampled.grids.size());
  Merger merger(model, sampled);
  for (std::size_t p = 0; p < sampled.grids.size(); ++p) {
    GridSection(sampled.grids[p], plane.axis).cut(plane.value, scratch, chains[p]);
    merger.add(static_cast<int>(p), chains[p]);
  }
  return merger.curves();
}

}  // namespace limitgauge::engine::surface
