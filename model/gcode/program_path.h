#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include "model/gcode/program.h"
#include "model/geometry/arc.h"
#include "model/part/toolpath.h"

namespace limitgauge::model {

/// A turn about Z, counter-clockwise seen from above, and then a shift. Quarter turns are exact.
struct RigidPlacement {
  double rotate_z_deg = 0;
  Vec3 translate_mm;

  Vec3 operator()(const Vec3& p) const;
  friend bool operator==(const RigidPlacement&, const RigidPlacement&) = default;
};

/// The machine's frame in the part's, where the work frame `g54` of a machine lies in the part's
/// frame as `program_frame` says.
RigidPlacement machine_in_part(const RigidPlacement& program_frame, const WorkOffset& g54);

struct PathOptions {
  double chord_error_mm = 0.01;  ///< largest distance between an arc and its chords
  RigidPlacement machine_in_part = {};
  /// Height in the part's frame at which a parked tool is taken to stand; above everything.
  double park_z_mm = 0;
  /// Where the tip stands before the first motion of the program, machine frame. Empty for programs
  /// that this project wrote itself, whose first two rapids lead to where their path begins: the
  /// path then starts where every axis is known, or with the first motion that is no rapid.
  std::optional<Vec3> start_mm = std::nullopt;
  /// A path of more is refused: chords may be many where an arc is wide and the error small.
  double most_moves = 4e8;
  /// The motions that are taken: [first, last).
  std::size_t first = 0, last = std::numeric_limits<std::size_t>::max();
  /// Of a program with rotary axes: the machine. The path is in the part's frame as it is turned
  /// while they stand as they do at `first`, so that the tool is along +Z; the motions taken must
  /// not turn them.
  std::optional<Kinematics> kinematics = std::nullopt;
  /// Of paths that turn their tool (to_turning_path): how far the tool reaches from its tip, which
  /// what an axis is off is multiplied by.
  double reach_mm = 0;
  /// Of those: what a parked tool is above, however the tables stand; in the part's frame.
  Box3 around_mm = {};
};

/// `placement` as a pose.
Pose pose_of(const RigidPlacement& placement);
/// How the part's frame lies while rotary axes stand at `angles_deg`, turned so that the tool is
/// along +Z: as Kinematics::upright has it, about the machine's zero.
Pose turned_part(const Kinematics& machine, const RigidPlacement& machine_in_part,
                 const RotaryAngles& angles_deg);

/// Motions [first, last) of a program, while which its rotary axes stand still.
struct SteadyRange {
  std::size_t first = 0, last = 0;
  RotaryAngles angles_deg{};
  /// That lead to it, one after the other, from the range before or the start.
  std::vector<AxisTurn> turns;
};
/// The ranges that [first, last) of `program` falls into, in order. The last one may hold no motion
/// where the program ends with turns.
std::vector<SteadyRange> steady_ranges(const Program& program, std::size_t first, std::size_t last);

/// The rapid that stands in a path for a change of tools, within which nothing turns.
Motion at_change(const TipPlace& tip);

/// What the arc `motion` goes along from `start`, in the frame of the program. One that ends within
/// 1e-6 radians beyond its start is a full turn.
Arc arc_of(const Motion& motion, const Vec3& start);

/// Straight moves in the part's frame for motions of `program`, arcs as chords of at most a quarter
/// turn whose ends lie on the arc and which stay within `chord_error_mm` of it; the largest error
/// made is recorded in the result. An arc that ends within 1e-6 radians beyond its start is a full
/// turn. Every motion gives its moves, from `start_mm` on. A tool that parks goes straight up to
/// the park height, crosses there, and comes down by the straight move that the program states: the
/// real one starts higher and stays above it. Throws std::invalid_argument unless 0 <
/// chord_error_mm < infinity and for a program that states its tool's axis (Program::axes),
/// ResourceError for more than `most_moves` moves.
Toolpath to_toolpath(const Program& program, const PathOptions& options);
/// Where the tip goes, of a program that states its tool's axis too.
Toolpath tip_path(const Program& program, const PathOptions& options);
/// The whole program on a machine whose frame is the part's, where nothing parks and no start is
/// stated.
Toolpath to_toolpath(const Program& program, double chord_error_mm);

/// Highest Z in the part's frame that any motion of known height ends at; -infinity where there
/// is none.
double highest_z_mm(const Program& program, const RigidPlacement& machine_in_part);

}  // namespace limitgauge::model
