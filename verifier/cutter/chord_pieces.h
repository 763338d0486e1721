#pragma once

#include <cstdint>
#include <vector>

#include "model/part/toolpath.h"
#include "verifier/cutter/swept_body.h"

namespace limitgauge::verifier {

/// The straight pieces that stand for what a path's tip goes along: its moves, and of an arc's
/// chords several each, whose ends lie on the arc too, so that they keep to kArcPiece_mm of it
/// where kMostArcPieces are enough for that. An error of the path would be added to every bound of
/// gouge and uncut, and beside a wall that it runs along a run has no bound at all. Numbered in the
/// order of the path.
class ChordPieces {
 public:
  explicit ChordPieces(const model::Toolpath& path);

  /// Largest distance between an arc and the pieces that stand for it; that to the path's own
  /// chords where its arcs are not known.
  double error_mm() const { return error_mm_; }
  /// Largest distance between a place of the path's own moves and that of the pieces at the same
  /// share of the way; 0 where they are the same.
  double from_moves_mm() const { return from_moves_mm_; }
  std::size_t count() const { return count_; }
  /// The move of the path that a piece is of.
  std::uint32_t move_of(std::uint32_t piece) const;
  /// What the pieces sweep, `lift_mm` above the tip.
  std::vector<SweptBody> bodies(const model::Toolpath& path, double lift_mm) const;

 private:
  /// Moves from `first_move` on, each of so many pieces, the first of which is `first_piece`.
  struct Stretch {
    std::uint32_t first_piece = 0, first_move = 0, pieces = 1;
  };
  void add_arc(const model::ArcMoves& arc, double limit_mm);

  std::vector<Stretch> stretches_;
  std::size_t count_ = 0;
  double error_mm_ = 0, from_moves_mm_ = 0;
};

}  // namespace limitgauge::verifier
