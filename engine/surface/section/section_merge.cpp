#include "engine/surface/section/section_merge.h"

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

std::vector<int> SectionMerge::chain_from(int piece, bool& closed) {
  std::vector<int> order;
  std::optional<int> at = piece;
  for (; at && !pieces_[*at].used; at = after(*at)) {
    pieces_[*at].used = true;
    order.push_back(*at);
  }
  closed = at.has_value() || pieces_[piece].chain.closed;
  return order;
}

SectionCurve SectionMerge::follow(int piece) {
  SectionCurve curve;
  const std::vector<int> order = chain_from(piece, curve.closed);
  curve.points = std::move(pieces_[piece].chain.points);
  if (pieces_[piece].chain.closed) return curve;
  std::size_t total = curve.points.size();
  for (std::size_t i = 1; i < order.size(); ++i) total += pieces_[order[i]].chain.points.size() - 1;
  curve.points.reserve(total);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const std::vector<Vec3>& next = pieces_[order[i]].chain.points;
    curve.points.insert(curve.points.end(), next.begin() + 1, next.end());
  }
  if (curve.closed) curve.points.pop_back();
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
