#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry/interval.h"
#include "model/geometry/pose.h"
#include "model/geometry/vec3.h"

namespace limitgauge::verifier {

/// A certified interval in mm: some point reaches `low`, no point exceeds `high`.
using Interval = model::Interval;

enum class Verdict { pass, fail, indeterminate, not_run };
const char* name(Verdict verdict);

/// A place on the limit surface: `patch` counts quads of the cage (an n-gon's corner quads in
/// order), u and v run from 0 to 1.
struct SurfacePlace {
  int patch = 0;
  double u = 0, v = 0;
  model::Vec3 point;
};

/// A pass near a finding: a move that it is bounded by.
struct NearPass {
  std::size_t stage = 0, move = 0;
  std::uint32_t line = 0;
  double distance_mm = 0;  ///< from the finding's deepest place to the space swept by the move
};

/// A clustered gouge or leftover; its deepest place, and the move responsible (for a leftover: the
/// nearest pass that left it). Ordered by depth, deepest first.
struct Finding {
  SurfacePlace place;
  double depth_mm = 0;
  double area_mm2 = 0;     ///< of the surface deeper than the threshold that belongs to the cluster
  model::Box3 extent_mm;   ///< box of the cluster
  std::size_t stage = 0;   ///< stage whose move is named (an earlier one may have gouged)
  std::size_t move = 0;    ///< index in that stage's path
  std::uint32_t line = 0;  ///< its program line
  bool raw_stock = false;  ///< a face of the raw stock is nearest, no move: the names above are 0
  std::string body = "cutter";  ///< of a gouge: "cutter", "shank" or "holder", numbered if several
  std::vector<NearPass>
      passes;  ///< around a leftover: the last stage's first, nearest first, at most 3
};

/// Gouge by one body of the assembly of one stage's cutter: "cutter" is its fluted part.
struct BodyFigure {
  std::size_t stage = 0;
  std::string body;
  Interval gouge_mm;
};

/// Area-weighted distribution of deviation minus allowance over the reachable surface.
struct Histogram {
  std::vector<double> edges_mm;  ///< ascending, one more than there are bins
  std::vector<double> area_mm2;
};

/// One line of the uncertainty budget: a worst-case bound, never a standard deviation.
struct UncertaintyTerm {
  std::string source;
  double bound_mm = 0;
  bool in_certificate = true;   ///< false: concerns the voxel figures only, or is a check's
  bool found_by_check = false;  ///< a difference found between two evaluators, in no figure
};

/// The sampled deviation field for maps: a grid mesh over the limit surface. A sample's deviation
/// is a run along its normal n (definition 2): from s + a·n outwards through material, positive, or
/// from there inwards through what is no longer material, negative.
struct DeviationField {
  struct Sample {
    SurfacePlace place;
    model::Vec3 normal;
    float deviation_mm = 0;  ///< uncut, or gouge with its sign changed
    bool reachable = true;
    bool raw_stock = false;  ///< a face of the raw stock is nearest, not a move
    std::uint32_t stage = 0, move = 0, line = 0;  ///< nearest pass; all 0 where the raw stock ends
    float area_mm2 = 0;                           ///< share of the surface this sample stands for
  };
  /// The samples of one patch: a grid of parameters from 0 to 1, u along the columns (which run
  /// fastest), v along the rows; at least two of each. Of a mesh those of a facet, which is three
  /// patches: columns square to its longest side.
  struct Grid {
    int patch = 0;  ///< the first one
    std::uint32_t columns = 0, rows = 0;
    std::uint32_t first = 0;  ///< index of its first sample
    int patches = 1;
    friend bool operator==(const Grid&, const Grid&) = default;
  };
  std::vector<Sample> samples;
  std::vector<std::array<std::uint32_t, 4>> quads;  ///< counter-clockwise, indices of samples
  std::vector<Grid> grids;                          ///< in the order of the samples
};

struct NamedLength {
  std::string name;  ///< of a tolerance: "zero.x", "tool.ball3.radius"
  double mm = 0;
};

/// By what factor the box of tolerances may grow until a gate's limit no longer holds.
struct ToleranceMargin {
  /// Largest that is proven to pass; none where not even the stated values alone are.
  std::optional<double> proven;
  /// Smallest that is proven to fail; none where that is not known of any that was tried.
  std::optional<double> refuted;
};

/// One figure over every value of the tolerances.
struct RobustFigure {
  Interval figure_mm;  ///< some values reach `low` at some point of S, none exceed `high` at any
  /// Where `low` is reached, and the values that reach it: measured with them alone, the run there
  /// is as long. None of a figure of zero.
  std::optional<SurfacePlace> place;
  model::Vec3 normal;
  std::vector<NamedLength> at;
  /// What the second instrument reads there, with these values; none where it was not asked.
  std::optional<double> voxel_mm;
  /// Who made it there, as of a Finding.
  std::size_t stage = 0, move = 0;
  std::uint32_t line = 0;
  bool raw_stock = false;
  std::string body = "cutter";
  /// How the run there grows with each value, mm per mm.
  std::vector<NamedLength> sensitivity;
  bool reached_resolution = true;
  std::size_t cells = 0;                  ///< that were looked at, without those of the margin
  std::optional<ToleranceMargin> margin;  ///< only of a figure with a limit
};

/// Both figures over the box of tolerances. Reach is that of the stated cutters.
struct RobustDeviation {
  RobustFigure gouge, uncut;
  double seconds = 0;
};

/// What one stage's verification found; all deviations are runs along the limit surface's normals,
/// measured from the allowance surface (definition 2).
struct StageDeviation {
  Interval gouge_mm, uncut_mm;  ///< certified; gouge by everything that swept the space
  /// RemovedSpace::stock_blunt_mm(): as much wider uncut may be where the raw stock is left.
  double stock_blunt_mm = 0;
  /// By body: the fluted parts of all stages together first; then, of each stage where they come
  /// that low, shank and holder as one body.
  std::vector<BodyFigure> bodies;
  /// How deep S lies outside the raw stock, which no program line is to blame for.
  Interval missing_stock_mm;
  /// Where the raw stock ends below the allowance surface, so that nothing can be left there: the
  /// longest run from s + a·n inwards, no further than S, outside the raw stock. By the field's
  /// samples: it may be deeper between them. None where they are all covered.
  struct MissingAllowance {
    double depth_mm = 0;
    SurfacePlace place;
  };
  std::optional<MissingAllowance> missing_allowance;
  double coverage = 0;  ///< share of the reachable area within both gate limits
  double mean_mm = 0, rms_mm = 0, p01_mm = 0, p50_mm = 0, p99_mm = 0;
  double voxel_gouge_mm = 0, voxel_uncut_mm = 0;  ///< the voxel instrument's readings
  double surface_area_mm2 = 0;
  double reachable_area_mm2 = 0, unreachable_area_mm2 = 0;  ///< by samples, which leave no rim
  /// Parts of the surface of which all points were proven to be in reach, none was, or neither.
  struct ProvenReach {
    double reachable_mm2 = 0, unreachable_mm2 = 0, undecided_mm2 = 0;
    /// Whether some cutter used so far has proofs of what it reaches: drills have none, and their
    /// samples are places that were found to be touched.
    bool is_mapped = true;
    /// Whether some cutter used so far has no proof of what it does not reach, so that all of the
    /// surface is judged: one that widens upwards.
    bool all_is_judged = false;
  } proven_reach;
  /// What no toolpath with the cutters used so far can remove, certified: `low` for a point of the
  /// surface. Distances to the nearest place that a cutter can take away, not runs.
  Interval unavoidable_uncut_mm;
  Histogram histogram;
  std::vector<Finding> gouges, uncuts;
  std::vector<Finding> missing_stock;  ///< places where the raw stock does not cover S
  /// Depth from which places are findings: the gate limit, or half of `low` where nothing limits.
  double gouge_threshold_mm = 0, uncut_threshold_mm = 0;
  /// The findings hold every place deeper than the threshold and a resolution.
  bool findings_complete = true;
  DeviationField field;
  std::vector<UncertaintyTerm> budget;
  std::size_t cells = 0;                  ///< cells examined by the branch and bound
  bool reached_resolution = true;         ///< both widths are within what was asked for
  double resolution_mm = 0;               ///< the width asked for
  std::optional<RobustDeviation> robust;  ///< where tolerances are stated
  double seconds = 0;
  /// What it is made of, but for what is built once: cells of S and the space removed.
  struct Phases {
    double reach_s = 0;        ///< what the cutters can touch, cell by cell
    double certificate_s = 0;  ///< extremes of gouge, uncut and missing stock
    double field_s = 0;        ///< samples
    double unavoidable_s = 0;
    double rays_s = 0;      ///< the second instrument
    double findings_s = 0;  ///< places beyond the limits
  } phases;
};

/// Gate limits; a figure that is not limited is measured but cannot fail.
struct GateLimits {
  bool has_gouge = false, has_uncut = false, has_coverage = false;
  double gouge_mm = 0, uncut_mm = 0, coverage = 0;
  /// The part of S that no cutter used so far can reach, in mm² or as a share of its area.
  bool has_unreachable = false, unreachable_is_share = true;
  double unreachable = 0;
  bool has_unavoidable = false;
  double unavoidable_mm = 0;  ///< largest uncut where nothing can reach
};

/// The three-valued decision, with the reason for each figure in words.
struct GateDecision {
  Verdict verdict = Verdict::not_run;
  std::vector<std::string> reasons;
};

/// The same findings and samples where another frame has them; figures stay. Those over tolerances
/// have places only in jobs that are not turned.
void turn(StageDeviation& deviation, const model::Pose& pose);

}  // namespace limitgauge::verifier
