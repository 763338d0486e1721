#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/defects/oracle.h"
#include "tests/defects/planting.h"
#include "tests/support/printed.h"
#include "verifier/gate/verify.h"

namespace limitgauge::tests::defects {

/// Gouge or leftover: what one case says on one side.
struct SideResult {
  double truth_mm = 0;  ///< by the oracle: the longest run along a normal that it is sure of
  double gate_mm = 0;   ///< what the unharmed twin is certified to keep
  verifier::Interval certified;
  bool due = false;       ///< deeper than the gate by more than the width: must be found
  bool failed = false;    ///< the gate of the twin's figure fails
  bool located = false;   ///< a finding stands at a place that the mishap made, beside its moves
  bool named = false;     ///< that finding names a move that cut there and the mishap touched
  bool contained = true;  ///< the interval holds what the oracle found
};

/// A line that says all of a side.
inline std::string told(const char* what, const SideResult& s) {
  return printed(
      "  %s: truth %.6f, certified [%.6f, %.6f], gate %.6f mm; due %d failed %d located %d named "
      "%d "
      "holds %d\n",
      what, s.truth_mm, s.certified.low, s.certified.high, s.gate_mm, s.due, s.failed, s.located,
      s.named, s.contained);
}

struct CaseResult {
  std::string pair;
  double resolution_mm = 0;
  Mishap mishap;
  SideResult gouge, uncut;
  bool voxels = false;  ///< the simulator's readings were compared
  bool gated = false;   ///< measured with the limits, narrowed only as far as the verdict needs
  bool reached_resolution = true;
  std::string broken;  ///< what must never be: an exception, a contradiction
  double seconds = 0;
  std::size_t cells = 0;
};

struct TwinResult {
  std::string pair;
  double allowance_mm = 0;
  SideResult gouge, uncut;
  verifier::Verdict verdict = verifier::Verdict::not_run;
  bool voxels = false, reached_resolution = true;
  std::string broken;
  double seconds = 0;
};

struct PairResult {
  std::vector<TwinResult> twins;
  std::vector<CaseResult> cases;
};

/// One surface and one cutter, and the mishaps to plant there.
struct PairPlan {
  std::string surface_name;
  model::Cage cage;
  model::Cutter cutter;
  double step_mm = 0;
  int across = 0;
  bool modal = false;
  std::vector<Mishap> mishaps;
  double resolution_mm = 0;
  std::size_t voxels_every = 0;  ///< every so many cases the simulator runs too; 0: never
  std::size_t turn = 0;          ///< shifts which cases those are
  /// How the pass lies in the frame that it is measured in, the part with it; nothing: upright.
  std::optional<model::Pose> lying = {};
};

PairResult run_pair(const PairPlan& plan);

}  // namespace limitgauge::tests::defects
