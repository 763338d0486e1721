#pragma once

#include <optional>
#include <vector>

#include "engine/model/gcode/statement.h"
#include "engine/model/program.h"

namespace limitgauge::model::gcode {

/// What a canned cycle takes from the machine's state.
struct CycleContext {
  int code = 0;  ///< in tenths: 730, 740, 810 to 890
  ArcPlane plane = ArcPlane::xy;
  double unit_mm = 1;
  bool incremental = false;     ///< G91
  bool return_to_r = false;     ///< G99; else G98
  Vec3 position_mm;             ///< in the active work frame
  double initial_level_mm = 0;  ///< where the first of a run of cycles found the normal axis
  double feed_mm_min = 0;
};

/// One motion of a cycle, in the active work frame.
struct CycleMove {
  MotionKind kind = MotionKind::rapid;  ///< never an arc
  Vec3 to_mm;
  bool spindle_stopped = false;  ///< as by G86 and G87 while they withdraw
};

/// The words of a run of cycles that stay from block to block (R, Z, Q, P, I, J, K), and the
/// motions they stand for: G73, G74, G81 to G89 as LinuxCNC documents and carries them out, in all
/// three planes, absolute and incremental, repeated by L.
class CannedCycles {
 public:
  /// The motions of `statement`. Throws InputError at the word that is missing or wrong.
  std::vector<CycleMove> moves(const Statement& statement, const CycleContext& context);
  /// Another motion mode came between: the sticky words are gone.
  void forget();

 private:
  struct Sticky {
    std::optional<double> r, z, q, p, i, j, k;
  };
  Sticky sticky_;
};

}  // namespace limitgauge::model::gcode
