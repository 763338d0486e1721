#pragma once

#include <optional>
#include <vector>

#include "model/gcode/cycles/canned_cycle_parameters.h"
#include "model/gcode/cycles/canned_cycle_path.h"
#include "model/gcode/program.h"
#include "model/gcode/text/statement.h"

namespace limitgauge::model::gcode {

enum class SpindleState { unknown, stopped, clockwise, counter_clockwise };

/// What a canned cycle takes from the machine's state.
struct CycleContext {
  int code = 0;  ///< in tenths: 730, 740, 810 to 890
  ArcPlane plane = ArcPlane::xy;
  double unit_mm = 1;
  bool incremental = false;  ///< G91
  bool return_to_r = true;   ///< G99, as LinuxCNC powers up; else G98
  Vec3 position_mm;          ///< in the active work frame
  /// Unknown where no word of it has been seen: taken to turn as the cycle wants it.
  SpindleState spindle = SpindleState::unknown;
  bool inverse_time = false;  ///< G93
  bool compensated = false;   ///< G41 or G42
};

/// What a block of a canned cycle stands for.
struct CycleMotions {
  std::vector<CycleMove> moves;
  /// Where the program goes on from: the end of the last move, but for G88, which leaves the way
  /// out to the operator and goes on from the return level above the hole, as LinuxCNC does.
  Vec3 end_mm;
};

/// The words of a run of cycles that stay from block to block (R, Q, P, I, J, K and the axis along
/// the tool), the level that the run began at, and the motions they stand for: G73, G74, G81 to G89
/// as LinuxCNC carries them out, in all three planes, absolute and incremental, repeated by L; of
/// Fanuc and Haas Z, R and the way to them are theirs (ControlRules::fanuc_cycles).
/// See linuxcnc.org/docs/2.9/html/gcode/g-code.html, "Canned Cycles". The order and number of
/// motions, those without length included, is LinuxCNC's. G74 and G84 feed both ways (a floating
/// chuck) and are refused outside G17, where LinuxCNC moves other axes than it documents; so is a
/// change of units within a run, where it reads old levels as numbers of the new unit.
class CannedCycles {
 public:
  static constexpr std::size_t kMostMoves = 100'000;  ///< of one block

  /// The motions of `statement`, a block of cycle `context.code` that has an axis word or the
  /// cycle's own G word. Throws InputError at the word that is missing or wrong.
  CycleMotions moves(const Statement& statement, const CycleContext& context);
  /// Another motion code (G80 too) came between: sticky words and initial level are gone.
  void forget();

 private:
  void check_state(const Statement& statement, const CycleContext& context) const;
  CycleGeometry geometry(const Statement& statement, const CycleContext& context) const;
  void add_places(const Statement& statement, const CycleContext& context,
                  CycleGeometry& cycle) const;
  void add_levels(const Statement& statement, const CycleContext& context,
                  CycleGeometry& cycle) const;
  void add_back_bore(const CycleContext& context, CycleGeometry& cycle) const;
  void add_pecks(const Statement& statement, const CycleContext& context,
                 CycleGeometry& cycle) const;

  int code_ = 0;  ///< of the block before; 0: none
  double unit_mm_ = 1;
  std::optional<double> initial_level_mm_;
  CycleParameters words_;
};

}  // namespace limitgauge::model::gcode
