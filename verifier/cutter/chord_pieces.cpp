#include "verifier/cutter/chord_pieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "verifier/tolerance.h"

namespace limitgauge::verifier {
namespace {

/// Pieces of each of an arc's chords, so that all keep within the limit: at least one.
double pieces_within(const model::ArcMoves& arc, double limit_mm) {
  return std::max(1.0, std::ceil(arc.arc.chords_within(limit_mm) / arc.chords));
}

double pieces_within(const std::vector<model::ArcMoves>& arcs, double limit_mm) {
  double sum = 0;
  for (const model::ArcMoves& arc : arcs) sum += arc.chords * pieces_within(arc, limit_mm);
  return sum;
}

/// What pieces keep to. An error four times as wide needs half as many.
double limit_mm_of(const model::Toolpath& path) {
  double limit_mm = kArcPiece_mm;
  while (limit_mm < path.chord_error_mm && pieces_within(path.arcs, limit_mm) > kMostArcPieces)
    limit_mm *= 4;
  return limit_mm;
}

}  // namespace

ChordPieces::ChordPieces(const model::Toolpath& path) : stretches_(1), count_(path.moves.size()) {
  if (path.arcs.empty()) {
    error_mm_ = path.chord_error_mm;
    return;
  }
  const double limit_mm = limit_mm_of(path);
  for (const model::ArcMoves& arc : path.arcs) add_arc(arc, limit_mm);
  if (stretches_.size() > 1) from_moves_mm_ = path.chord_error_mm + error_mm_;
}

void ChordPieces::add_arc(const model::ArcMoves& arc, double limit_mm) {
  const double pieces = pieces_within(arc, limit_mm);
  error_mm_ = std::max(error_mm_, arc.arc.error_mm(arc.chords * pieces));
  if (pieces == 1) return;
  const Stretch before = stretches_.back();
  const auto each = static_cast<std::uint32_t>(pieces);
  const std::uint32_t first =
      before.first_piece + before.pieces * (arc.first_move - before.first_move);
  stretches_.push_back({first, arc.first_move, each});
  stretches_.push_back({first + each * arc.chords, arc.first_move + arc.chords, 1});
  count_ += std::size_t{arc.chords} * (each - 1);
}

std::uint32_t ChordPieces::move_of(std::uint32_t piece) const {
  const auto after = std::upper_bound(
      stretches_.begin(), stretches_.end(), piece,
      [](std::uint32_t asked, const Stretch& stretch) { return asked < stretch.first_piece; });
  const Stretch& in = *std::prev(after);
  return in.first_move + (piece - in.first_piece) / in.pieces;
}

namespace {

/// Lays bodies end to end.
class BodyChain {
 public:
  BodyChain(const model::Vec3& start, double lift_mm, std::size_t count)
      : lift_(0, 0, lift_mm), from_(start + lift_) {
    bodies_.reserve(count);
  }
  void go_to(const model::Vec3& tip) {
    const model::Vec3 to = tip + lift_;
    bodies_.emplace_back(from_, to);
    from_ = to;
  }
  /// The ends of pieces within one of an arc's chords.
  void go_along(const model::ArcMoves& arc, std::size_t chord, std::uint32_t pieces) {
    const double all = static_cast<double>(arc.chords) * pieces;
    for (std::uint32_t k = 1; k < pieces; ++k)
      go_to(arc.arc.point_at(static_cast<double>(chord * pieces + k) / all));
  }
  std::vector<SweptBody> take() { return std::move(bodies_); }

 private:
  model::Vec3 lift_, from_;
  std::vector<SweptBody> bodies_;
};

}  // namespace

std::vector<SweptBody> ChordPieces::bodies(const model::Toolpath& path, double lift_mm) const {
  BodyChain chain(path.start, lift_mm, count_);
  auto arc = path.arcs.begin();
  for (std::size_t s = 0; s < stretches_.size(); ++s) {
    const Stretch& here = stretches_[s];
    const bool is_last = s + 1 == stretches_.size();
    const std::size_t end = is_last ? path.moves.size() : stretches_[s + 1].first_move;
    while (here.pieces > 1 && arc->first_move != here.first_move) ++arc;
    for (std::size_t move = here.first_move; move < end; ++move) {
      if (here.pieces > 1) chain.go_along(*arc, move - here.first_move, here.pieces);
      chain.go_to(path.moves[move].to);
    }
  }
  return chain.take();
}

}  // namespace limitgauge::verifier
