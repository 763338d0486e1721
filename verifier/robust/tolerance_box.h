#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/part/tolerances.h"
#include "verifier/certificate/run_bounds.h"
#include "verifier/cutter/assembly.h"
#include "verifier/cutter/removed_space.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::verifier {

/// A figure of the tools or the zero that is not known: what it may be off by, mm.
struct Tolerance {
  enum class Of { zero, radius, length, corner_radius, flat, runout, positioning, path };
  Of of = Of::zero;
  int axis = 0;      ///< of zero, positioning and path
  std::string tool;  ///< of the figures of a tool
  model::Interval range_mm;

  std::string name() const;  ///< "zero.x", "tool.ball3.radius", "runout", "path.z"
};

/// What one of them is off by, in the order of the box.
using ToleranceValues = std::vector<double>;

/// All values that the figures of some passes' tools and their zero may have together
/// (CERTIFICATE.md, section 10). What only makes a cutter reach further, or less far, is at one end
/// for the deepest gouge and at the other for the longest leftover; shifts in plan are not.
class ToleranceBox {
 public:
  /// Throws std::invalid_argument as require_certifiable does.
  ToleranceBox(const model::Tolerances& tolerances, std::span<const Pass> passes);

  const std::vector<Tolerance>& tolerances() const { return tolerances_; }
  /// The values at which the passes gouge deepest, or leave most, all shifts in plan at their
  /// middle and none off the path.
  ToleranceValues extreme(Side side) const;
  /// The passes as they are at these values.
  std::vector<Pass> passes_at(const ToleranceValues& values) const;
  /// The same with the stated paths: of such passes only cutters and how they stand are asked.
  std::vector<Pass> cutters_at(const ToleranceValues& values) const;
  /// Whether some figure of a cutter but its length is uncertain.
  bool changes_reach() const;
  /// Cutters that can touch whatever any of the box's can (CERTIFICATE.md, section 10). None where
  /// a cutter would have nothing left of its core or of its neck.
  std::optional<std::vector<Pass>> smallest_cutters() const;
  /// What they sweep, lengths of tools included and shifts that all share not; of gouge with the
  /// parts of shanks and holders that come lower than `highest_mm` for any values. `grown_mm` is
  /// added to the length of flutes and parts.
  std::vector<Sweep> sweeps_at(const ToleranceValues& values, Side side, double highest_mm) const;
  /// The same, of a body that every set of values sweeps (uncut), or that holds what any does.
  std::vector<Sweep> hull_sweeps(Side side, double highest_mm) const;
  /// The parts of shanks and holders that the sweeps of gouge hold after those of the passes.
  std::vector<AssemblySweep> parts(double highest_mm) const;
  /// The shift that all passes share.
  model::Vec3 shift_at(const ToleranceValues& values) const;
  /// From the lowest to the highest place of a tool's tip, per pass.
  double height_range_mm(const Pass& pass) const;

  /// For spaces that sway: rectangle of the shifts that all moves share (of gouge those that each
  /// has for itself too), and by how much moves may lie off it each for itself.
  model::Vec3 sway(Side side) const;
  double error_mm(Side side) const;
  /// What errors that each move has for itself add to a leftover beyond one shift of all moves:
  /// those across, and where passes part from each other at a cusp.
  double gap_mm(Side side) const;
  /// Half widths in plan of the rectangle that shifts of all moves together may lie in.
  model::Vec3 shift_half() const { return sway(Side::gouge); }
  double path_mm() const { return path_mm_; }
  /// The values of `extreme` with that share of the shifts in plan, −1 to 1 along each axis.
  ToleranceValues shifted(Side side, double x, double y) const;
  /// With the tips off their path that way.
  ToleranceValues off_path(ToleranceValues values, const model::Vec3& by) const;

 private:
  double sum_of(const ToleranceValues& values, Tolerance::Of of, int axis) const;
  model::CutterOffset offset_of(const ToleranceValues& values, const std::string& tool) const;
  std::optional<model::Cutter> smallest(const model::Cutter& cutter) const;
  model::Interval range_of(Tolerance::Of of, int axis, const std::string& tool = {}) const;
  std::vector<Sweep> sweeps(const ToleranceValues& values, Side side, double highest_mm,
                            double grown) const;
  void add_tool(const model::Tolerances& tolerances, const Pass& pass);

  std::span<const Pass> passes_;
  std::vector<Tolerance> tolerances_;
  double path_mm_ = 0;
};

/// The spaces that one figure over a box is certified in.
struct ToleratedSpaces {
  RemovedSpace whole;  ///< proofs in it hold for every set of values
  RemovedSpace drawn;  ///< at the extreme values, but for their shifts
  Draws draws;

  ToleratedSpaces(const ToleranceBox& box, const RemovedSpace& raw, Side side, double highest_mm);
  ToleratedSpaces(const ToleratedSpaces&) = delete;
  ToleratedSpaces& operator=(const ToleratedSpaces&) = delete;
};

}  // namespace limitgauge::verifier
