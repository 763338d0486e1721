#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "model/base/run_control.h"
#include "model/part/stock.h"
#include "model/part/tolerances.h"
#include "model/part/toolpath.h"
#include "verifier/gate/deviation.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::verifier {

/// Passes come in the order of the job, and those before the stage under test count too: the
/// removed space is everything cut so far and everything outside the raw stock.
using model::Pass;

/// The simulated stock, as the second instrument asks it: rays from S. Implemented over the
/// simulator, which shares no distance, tree or library with this folder. Const calls from several
/// threads at once.
class StockProbe {
 public:
  virtual ~StockProbe() = default;
  /// What stands at `from`, and how far along a unit vector everything is like that.
  struct Run {
    bool material = false;
    double length_mm = 0;  ///< no more than asked for
    bool ends = false;     ///< material turns into air, or air into material, at its end
    double error_mm = 0;   ///< bound on the distance of that end from the true surface of the stock
  };
  virtual Run run(const model::Vec3& from, const model::Vec3& along, double limit_mm) const = 0;
  /// Spacing of its grid in mm, for the report.
  virtual double spacing_mm() const = 0;
  /// The same raw stock cut by other passes, to be asked few rays; null where that cannot be had.
  virtual std::unique_ptr<StockProbe> cut_by(std::span<const Pass>,
                                             const model::RunControl&) const {
    return nullptr;
  }
};

/// A pass of another setup that had less to leave than the stage that is measured, and was judged
/// by that.
struct FinerPass {
  std::size_t pass = 0;
  double allowance_mm = 0, gouge_limit_mm = 0;
};

/// What a stage is measured for.
struct StageCheck {
  double allowance_mm = 0;
  GateLimits limits;
  double resolution_mm = 0;        ///< widest certified interval asked for; > 0
  double field_spacing_mm = 0.25;  ///< largest distance between samples of the deviation field
  std::size_t largest_cell_count = 5'000'000;  ///< where branch and bound gives up
  /// What is not known of tools and zero; none: they are taken as stated.
  std::optional<model::Tolerances> tolerances;
  bool finds_margin = true;  ///< how far the tolerances could grow, beside what they lead to
  /// What they took is gone, but no gouge of this stage.
  std::vector<FinerPass> finer_passes = {};
};

/// Resolution "auto": a tenth of the tightest gate limit, 1 µm where nothing is limited.
double automatic_resolution_mm(const GateLimits& limits);

class PieceWorkers;  // see stage_pieces.h

/// Measures the stage whose pass is the last of `passes`. `probe` asks the simulated stock, none
/// leaves the second instrument out; the two instruments are compared, and a disagreement beyond
/// their bounds throws InstrumentDisagreement. The result is the same for any number of threads,
/// and with `workers`, who do parts of it elsewhere. Where passes turn their tool as they go
/// (model::Pass::axes), what one of some ways in which it stood can touch is in reach, and nothing
/// is proven out of reach; tolerances throw std::invalid_argument.
StageDeviation measure_stage(const ReferenceSurface& surface, const model::Stock& raw_stock,
                             std::span<const Pass> passes, const StockProbe* probe,
                             const StageCheck& check, const model::RunControl& control,
                             PieceWorkers* workers = nullptr);

/// The two instruments contradict each other: an internal error, exit code 4.
class InstrumentDisagreement : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// How often a kind of fault was found in the process, "rapid through standing material" say: what
/// the surface does not show.
struct ProcessFault {
  std::string what;
  std::size_t count = 0;  ///< of moves
  struct Place {
    model::Vec3 point;
    std::uint32_t line = 0;  ///< of the program; 0: of none
    double depth_mm = 0;     ///< 0 or less: there is none to tell
  };
  std::optional<Place> worst = std::nullopt;  ///< where it is deepest
  /// None was shown, nor could one be excluded: `worst` is where the first such move begins.
  bool is_open = false;
};

/// What the gates of gouge and uncut judge: the figure over tolerances, where any are stated.
const Interval& judged_gouge_mm(const StageDeviation& deviation);
const Interval& judged_uncut_mm(const StageDeviation& deviation);
/// The verdict of both figures over tolerances against the limits that there are.
Verdict judge_robust(const RobustDeviation& robust, const GateLimits& limits);
/// The figure whose tolerances may grow least; null where no margin was found of any.
const RobustFigure* least_margin(const RobustDeviation& robust);
/// Area of S that shares are of.
double whole_area_mm2(const StageDeviation& deviation);
/// Whether there are areas by proof; results without them have the samples' alone.
bool has_proven_areas(const StageDeviation& deviation);
/// Proven out of reach, and with what is undecided: what the gate `unreachable` judges. What is no
/// more than rounding is none.
Interval unreachable_area_mm2(const StageDeviation& deviation);
/// Whether any of S is in reach. It passes where some is proven to be, and where nothing can be
/// proven to be out of it and uncut has a limit, for all of S is judged by it then. Else it fails,
/// or is indeterminate where samples say otherwise (they count what is touched along the end of an
/// open sheet from beside it, which is no area); of drills alone, which have no proofs of reach,
/// samples decide.
Verdict judge_any_reach(const StageDeviation& deviation, const GateLimits& limits);

/// The gate's decision rule: pass when every `high` is within its limit, fail when some `low` is
/// beyond it, indeterminate between; a figure without a limit cannot fail. Missing raw stock is
/// held against the gouge limit under a name of its own. Whatever the limits, a stage fails where
/// no cutter reaches any of the surface, and for each kind of process fault found at least once.
/// Reasons of figures that do not pass name the deepest place, its depth and program line; `stages`
/// are the names of the stages up to this one, for lines of earlier programs.
GateDecision decide(const StageDeviation& deviation, const GateLimits& limits,
                    std::span<const ProcessFault> faults = {},
                    std::span<const std::string> stages = {});
/// Where nothing is measured against a surface: fail for each kind of process fault found at least
/// once, pass where there is none, never indeterminate.
GateDecision decide(std::span<const ProcessFault> faults);

/// Whether one of the reasons of a decision is of a figure that passes.
bool tells_a_pass(const std::string& reason);

}  // namespace limitgauge::verifier
