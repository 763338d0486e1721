#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "model/geometry/arc.h"
#include "model/geometry/pose.h"
#include "model/part/cutter.h"

namespace limitgauge::model {

enum class MoveKind : std::uint8_t { rapid, feed };

/// A straight move of the tool tip (CL point) to `to`. A rapid is taken to be straight too; every
/// report says so, since a machine's own rapid need not be. Paths have millions of moves: the kind
/// and the spindle share their word with the line, which keeps a move within half a cache line.
struct Move {
  Vec3 to;                      ///< mm, part frame
  float feed_mm_min = 0;        ///< of a feed move; 0 where the program states none
  std::uint32_t line : 30 = 0;  ///< program line, from 1; 0 where there is no program
  MoveKind kind : 1 = MoveKind::rapid;
  bool spindle_stopped : 1 = false;  ///< the program is known to have the spindle at rest

  Move() = default;
  /// Lines are counted to 2^30 - 1 and then from 0 again.
  Move(const Vec3& target, float feed, std::uint32_t program_line, MoveKind move_kind)
      : to(target), feed_mm_min(feed), line(program_line & kLineMask), kind(move_kind) {}
  void set_line(std::uint32_t program_line) { line = program_line & kLineMask; }

 private:
  static constexpr std::uint32_t kLineMask = (std::uint32_t{1} << 30) - 1;
};
static_assert(sizeof(Move) == 32);

/// A programmed arc and the moves that stand for it: equal chords, [first_move, first_move +
/// chords).
struct ArcMoves {
  Arc arc;
  std::uint32_t first_move = 0, chords = 0;
};

/// What one cutter does in one stage: straight moves from `start`.
struct Toolpath {
  Vec3 start;  ///< where the tip is before the first move
  std::vector<Move> moves;
  double chord_error_mm = 0;  ///< largest distance between a programmed arc and its chords
  /// In the order of their moves: all arcs that chords stand for, or none where they are not known,
  /// as of a path that was read back.
  std::vector<ArcMoves> arcs = {};
};

/// Where move `i` of `path` begins.
inline const Vec3& move_from(const Toolpath& path, std::size_t i) {
  return i == 0 ? path.start : path.moves[i - 1].to;
}

/// How a tool stands along a path that turns it as it goes: unit vectors from its tip to the
/// spindle, in the frame of the path. During a move the tip goes straight, as the path has it, and
/// the axis evenly with it along the shorter great circle between its two ends. A tool is a body of
/// revolution, so that this says all of where it is.
struct ToolAxes {
  Vec3 start{0, 0, 1};   ///< where the path begins
  std::vector<Vec3> to;  ///< where each move ends
};

/// The axis where move `i` begins.
inline const Vec3& axis_from(const ToolAxes& axes, std::size_t i) {
  return i == 0 ? axes.start : axes.to[i - 1];
}

/// Throws std::invalid_argument where there is not one axis for each move, one is not of length 1
/// (within 1e-9), or a move turns by more than 90 degrees, which leaves open which way.
void require_axes(const Toolpath& path, const ToolAxes& axes);

/// Every place moved by `pose`; feeds, lines and kinds stay.
Toolpath turned(const Toolpath& path, const Pose& pose);
Arc turned(const Arc& arc, const Pose& pose);
ToolAxes turned(const ToolAxes& axes, const Pose& pose);

/// One pass of one cutter over the part. The cutter stands along +Z of the frame that its path is
/// in, or as `axes` has it; `pose` is how that frame lies in the one that the pass is asked in,
/// which differ where a part was turned over between the setup of the pass and the one at work.
struct Pass {
  Cutter cutter;
  std::shared_ptr<const Toolpath> path;
  Pose pose = {};
  /// A stretch of a program that only brings its tool to where a later one cuts: how it stands
  /// there is no use of the cutter.
  bool only_positions = false;
  /// Of a path that turns its tool as it goes; null: the tool stands along +Z.
  std::shared_ptr<const ToolAxes> axes = {};
};

struct ToolpathLengths {
  double cut_mm = 0, rapid_mm = 0;
  double time_s = 0;  ///< at the programmed feeds and the given rapid rate, no acceleration
};
ToolpathLengths lengths(const Toolpath& path, double rapid_mm_min);

}  // namespace limitgauge::model
