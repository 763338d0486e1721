#include "engine/surface/section_merge.h"

#include <algorithm>
#include <utility>

namespace limitgauge::engine::surface {

std::optional<SectionMerge::Crossing> SectionMerge::crossing(int patch,
                                                             const SectionEnd& end) const {
  const Index h = model_.patches()[patch].first_half_edge + end.side;
  if (model_.ends_at(h)) return std::nullopt;
  if (sampled_.offset_mm != 0 && model_.creased_at(h)) return std::nullopt;
  const Index twin = model_.outer().twin[h];
  const int own = sampled_.depths[patch], other = sampled_.depths[model_.patch_at(twin)];
  const int cells = 1 << own;
  int along = end.side < 2 ? end.segment : cells - 1 - end.segment;
  if (h > twin) along = cells - 1 - along;
  return Crossing{model_.outer().edge[h], along >> std::max(0, own - other)};
}

void SectionMerge::add(int patch, std::vector<SectionChain>& chains) {
  for (SectionChain& chain : chains) {
    Piece piece{std::move(chain), {}, {}, false, false};
    if (!piece.chain.closed) {
      piece.first = crossing(patch, piece.chain.first);
      piece.last = crossing(patch, piece.chain.last);
    }
    if (piece.first) entries_.push_back({*piece.first, static_cast<int>(pieces_.size())});
    pieces_.push_back(std::move(piece));
  }
}

std::optional<int> SectionMerge::after(int piece) const {
  if (!pieces_[piece].last) return std::nullopt;
  const auto found =
      std::lower_bound(entries_.begin(), entries_.end(), *pieces_[piece].last,
                       [](const Entry& entry, const Crossing& at) { return entry.at < at; });
  if (found == entries_.end() || found->at != *pieces_[piece].last) return std::nullopt;
  return found->chain;
}

SectionCurve SectionMerge::follow(int piece) {
  SectionCurve curve;
  std::optional<int> at = piece;
  while (at && !pieces_[*at].used) {
    Piece& next = pieces_[*at];
    next.used = true;
    if (curve.points.empty())
      curve.points = std::move(next.chain.points);
    else
      curve.points.insert(curve.points.end(), next.chain.points.begin() + 1,
                          next.chain.points.end());
    curve.closed = next.chain.closed;
    at = after(*at);
  }
  if (at) {
    curve.closed = true;
    curve.points.pop_back();
  }
  return curve;
}

std::vector<SectionCurve> SectionMerge::curves() {
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.at < b.at; });
  for (std::size_t i = 0; i < pieces_.size(); ++i)
    if (const auto next = after(static_cast<int>(i))) pieces_[*next].joined = true;
  std::vector<SectionCurve> merged;
  for (const bool open : {true, false})
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Piece& piece = pieces_[i];
      if (piece.used || (open && (piece.joined || piece.chain.closed))) continue;
      merged.push_back(follow(static_cast<int>(i)));
    }
  pieces_.clear();
  entries_.clear();
  return merged;
}

}  // namespace limitgauge::engine::surface
