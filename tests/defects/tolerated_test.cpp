// Figures over tolerances on the surfaces and cutters of the suite: nothing that is drawn from a
// box goes beyond what is certified of it, and what only some values bring about is found. The
// oracle looks everywhere, with cutters and paths as those values make them.
#include <algorithm>
#include <random>

#include "tests/defects/oracle.h"
#include "tests/defects/surfaces/raster.h"
#include "tests/defects/surfaces/surfaces.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/folders.h"
#include "tests/support/rasters.h"
#include "verifier/gate/stage_scene.h"
#include "verifier/reach/reach_entries.h"
#include "verifier/reach/reach_query.h"
#include "verifier/robust/robust_figures.h"
#include "verifier/robust/tolerated_reach.h"

namespace limitgauge::tests::defects {
namespace {

using model::Interval;
using model::Vec3;
using verifier::Side;

constexpr double kOracleSpacing_mm = 0.2;
constexpr double kResolution_mm = 0.001;
constexpr double kNanometre_mm = 1e-6;
/// Marches of the oracle end within it.
constexpr double kMarch_mm = 1e-5;
/// Where a search for a contradiction gives up: an interval is as wide as it may be there.
constexpr std::size_t kCellsOfADraw = 20'000;
constexpr verifier::GateLimits kFarLimits = {true, true, false, 1000, 1000, 0};
const model::RunControl kControl{2, nullptr, {}};

double between(double low, double high, std::mt19937& random) {
  return std::uniform_real_distribution(low, high)(random);
}

Interval some_range(double most, std::mt19937& random) {
  return {-between(0, most, random), between(0, most, random)};
}

model::Tolerances some_tolerances(const model::Cutter& cutter, std::mt19937& random) {
  model::Tolerances out;
  for (Interval& axis : out.zero_mm) axis = some_range(0.008, random);
  model::ToolTolerance& tool = out.tools[cutter.id];
  tool.radius_mm = some_range(0.02, random);
  tool.length_mm = some_range(0.01, random);
  if (cutter.type == model::CutterType::bull) tool.corner_radius_mm = some_range(0.01, random);
  if (cutter.type == model::CutterType::flat) tool.corner_radius_mm = {0, 0.03};
  return out;
}

/// Rows all over a surface by one cutter, which touch it and gouge nowhere.
struct SoundJob {
  const NamedCage& part;
  const model::Cutter& cutter;
  Target target;
  model::BoxStock stock;
  Rows rows;

  SoundJob(const NamedCage& surface, const model::Cutter& with, double step_mm, int across)
      : part(surface), cutter(with), target(surface.cage, kOracleSpacing_mm) {
    const model::Box3 box = target.surface.bounding_box();
    const Vec3 aside{8, 8, 6};
    stock = {box.low - aside, box.high + Vec3{8, 8, 1} - (box.low - aside)};
    rows = gouge_free_rows(target.samples, {cutter, 0, step_mm, across});
  }

  model::Toolpath path() const {
    const double safe = stock.corner_mm.z + stock.size_mm.z + 2;
    model::Toolpath out;
    for (const std::vector<Vec3>& row : rows.tips) {
      const Vec3 above{row.front().x, row.front().y, safe};
      if (out.moves.empty()) out.start = above;
      feed_to(out, above);
      for (const Vec3& tip : row) feed_to(out, tip);
      feed_to(out, {row.back().x, row.back().y, safe});
    }
    return out;
  }
};

/// Pairs of the suite, each by its number; other steps and directions from one to the next.
std::unique_ptr<SoundJob> job_of(const std::vector<NamedCage>& surfaces,
                                 const std::vector<model::Cutter>& cutters, std::size_t number) {
  constexpr double kSteps_mm[] = {0.5, 0.7, 0.6};
  // Every surface before any comes again, with another cutter then.
  const std::size_t s = number % surfaces.size(),
                    c = (number + number / surfaces.size()) % cutters.size();
  return std::make_unique<SoundJob>(surfaces[s], cutters[c], kSteps_mm[number % 3],
                                    static_cast<int>(number % 2));
}

/// One path over a part with its tolerances, measured, and ready to be asked at any values.
class ToleratedJob {
 public:
  ToleratedJob(const SoundJob& job, model::Toolpath path, const model::Tolerances& tolerances)
      : job_(job),
        passes_{{job.cutter, shared(std::move(path))}},
        check_(check_of(tolerances)),
        scene_(job.target.surface, job.stock, passes_, check_),
        proven_(classify_reach(scene_.cells, scene_.by.searches, scene_.by.efforts, kControl)),
        reach_(scene_.by.searches, proven_),
        tolerated_(scene_, tolerances, passes_, check_, job.target.surface.area_mm2(), reach_,
                   kControl),
        box(tolerances, passes_) {
    for (const Side side : {Side::gouge, Side::uncut}) {
      stated_[side == Side::uncut] = stated_figure(side);
      found_[side == Side::uncut] =
          verifier::robust_figure({scene_.cells, scene_.raw, passes_, check_, scene_.request,
                                   scene_.highest_mm, tolerated_.of_any(), tolerated_.of_extreme()},
                                  side, tolerances, kControl);
    }
  }
  ToleratedJob(const ToleratedJob&) = delete;

  const Interval& stated(Side side) const { return stated_[side == Side::uncut]; }
  const verifier::RobustFigure& found(Side side) const { return found_[side == Side::uncut]; }

  verifier::ToleranceValues named(Side side) const {
    verifier::ToleranceValues out;
    for (const verifier::NamedLength& value : found(side).at) out.push_back(value.mm);
    return out;
  }

  /// The ordinary certificate at some values: what it proves to be longer than `limit_mm`, if any.
  double proven_beyond(Side side, const verifier::ToleranceValues& values, double limit_mm) const {
    verifier::CertificateRequest request = scene_.request;
    request.decides_only = true;
    request.gouge_limit_mm = request.uncut_limit_mm = limit_mm;
    request.largest_cell_count = kCellsOfADraw;
    return certified(side, values, request).figure_mm.low;
  }

  /// Run at the figure's place, its values put in for the stated ones.
  double run_at_named(Side side) const {
    const verifier::RemovedSpace space = space_at(side, named(side));
    verifier::RunBounds bounds(scene_.cells, space, side, 0);
    return bounds.run(found(side).place->point, found(side).normal).length_mm;
  }

  /// The oracle for the paths and cutters that these values make, of which reach is, too.
  RunOracle oracle_at(const verifier::ToleranceValues& values) const {
    std::vector<simulator::Pass> passes;
    for (const verifier::Pass& pass : box.passes_at(values))
      passes.push_back({pass.cutter, pass.path});
    return {job_.target, job_.stock, passes, 0};
  }

  verifier::Verdict verdict(Side side, double limit_mm) const {
    verifier::RobustDeviation robust;
    robust.gouge = found(Side::gouge), robust.uncut = found(Side::uncut);
    verifier::GateLimits limits;
    (side == Side::uncut ? limits.has_uncut : limits.has_gouge) = true;
    (side == Side::uncut ? limits.uncut_mm : limits.gouge_mm) = limit_mm;
    return judge_robust(robust, limits);
  }

 private:
  static verifier::StageCheck check_of(const model::Tolerances& tolerances) {
    verifier::StageCheck check;
    check.limits = kFarLimits;
    check.resolution_mm = kResolution_mm;
    check.tolerances = tolerances;
    return check;
  }
  verifier::RemovedSpace space_at(Side side, const verifier::ToleranceValues& values) const {
    return scene_.raw.with(box.sweeps_at(values, side, scene_.highest_mm))
        .shifted(box.shift_at(values));
  }
  verifier::Certificate certified(Side side, const verifier::ToleranceValues& values,
                                  const verifier::CertificateRequest& request) const {
    return certify(scene_.cells, space_at(side, values), side,
                   side == Side::uncut ? &reach_ : nullptr, request, kControl);
  }
  Interval stated_figure(Side side) const {
    return certified(side, verifier::ToleranceValues(box.tolerances().size(), 0), scene_.request)
        .figure_mm;
  }

  const SoundJob& job_;
  std::vector<verifier::Pass> passes_;
  verifier::StageCheck check_;
  verifier::StageScene scene_;
  verifier::ReachMap proven_;
  verifier::ReachQuery reach_;
  verifier::ToleratedReach tolerated_;
  Interval stated_[2];
  verifier::RobustFigure found_[2];

 public:
  const verifier::ToleranceBox box;
};

/// Anywhere in the box, in one of its corners, or near the values that a figure names.
verifier::ToleranceValues drawn(const ToleratedJob& job, int number, std::mt19937& random) {
  const Side side = number % 2 == 0 ? Side::gouge : Side::uncut;
  verifier::ToleranceValues values = job.named(side);
  const std::vector<verifier::Tolerance>& box = job.box.tolerances();
  values.resize(box.size(), 0.0);
  for (std::size_t k = 0; k < box.size(); ++k) {
    const Interval& r = box[k].range_mm;
    if (number % 3 == 0) values[k] = between(r.low, r.high, random);
    if (number % 3 == 1) values[k] = random() % 2 == 0 ? r.low : r.high;
    if (number % 3 == 2)
      values[k] = std::clamp(values[k] + 0.1 * r.width() * between(-1, 1, random), r.low, r.high);
  }
  return values;
}

double depth(const Bracket& bracket, bool sure) {
  return sure ? bracket.sure_mm : bracket.possible_mm;
}

/// What the oracle finds at these values, looking everywhere and first where a figure has its
/// place.
double surely(const ToleratedJob& job, Side side, const verifier::ToleranceValues& values) {
  const RunOracle oracle = job.oracle_at(values);
  std::vector<Place> hints;
  if (const auto& place = job.found(side).place) hints = {{place->patch, place->u, place->v}};
  return (side == Side::uncut ? oracle.surely_uncut(hints) : oracle.surely_gouged(hints)).depth_mm;
}

/// What the oracle reads at the place of a figure, at its values.
double read_at_named(const ToleratedJob& job, Side side, bool sure) {
  const RunOracle oracle = job.oracle_at(job.named(side));
  const verifier::RobustFigure& figure = job.found(side);
  return depth(side == Side::uncut ? oracle.uncut(figure.place->point, figure.normal)
                                   : oracle.gouge(figure.place->point, figure.normal),
               sure);
}

}  // namespace

TEST_CASE("tolerances: what is drawn stays within what is certified of the box, on every surface",
          "[property]") {
  const std::vector<NamedCage> surfaces = suite_surfaces(tests::fixtures().string());
  const std::vector<model::Cutter> cutters = suite_cutters();
  std::mt19937 random(2210);
  const int jobs = by_effort(3, 20), draws = by_effort(6, 500), seen_by_oracle = by_effort(2, 25);
  for (int number = 0; number < jobs; ++number) {
    const auto sound = job_of(surfaces, cutters, static_cast<std::size_t>(number));
    const ToleratedJob job(*sound, sound->path(), some_tolerances(sound->cutter, random));
    CAPTURE(sound->part.name, sound->cutter.id);
    for (const Side side : {Side::gouge, Side::uncut}) {
      const verifier::RobustFigure& figure = job.found(side);
      CAPTURE(side, figure.figure_mm.low, figure.figure_mm.high, job.stated(side).high);
      CHECK(figure.figure_mm.high >= job.stated(side).low);
      REQUIRE(figure.place);
      CHECK(job.run_at_named(side) >= figure.figure_mm.low - kNanometre_mm);
      CHECK(read_at_named(job, side, false) >= figure.figure_mm.low - kMarch_mm);
      for (int k = 0; k < draws; ++k) {
        const verifier::ToleranceValues values = drawn(job, k, random);
        CHECK(job.proven_beyond(side, values, figure.figure_mm.high) == 0);
        if (k < seen_by_oracle)
          CHECK(surely(job, side, values) <= figure.figure_mm.high + kNanometre_mm);
      }
    }
  }
}

namespace {

/// A mishap that a row has: deeper (gouge) or higher (uncut) than the rest.
model::Toolpath with_mishap(SoundJob& job, Side side, std::mt19937& random) {
  const Rows sound = job.rows;
  std::vector<Vec3>& row = job.rows.tips[random() % job.rows.tips.size()];
  const double off = between(0.001, 0.03, random);
  for (Vec3& tip : row) tip.z += side == Side::uncut ? off : -off;
  model::Toolpath out = job.path();
  job.rows = sound;
  return out;
}

/// The most that the oracle finds in some corners of the box and at the values that are named.
double truth(const ToleratedJob& job, Side side, std::mt19937& random) {
  double most = surely(job, side, job.named(side));
  for (int k = 0; k < 4; ++k) most = std::max(most, surely(job, side, drawn(job, 1, random)));
  return most;
}

}  // namespace

TEST_CASE("tolerances: a mishap that only some values show is found, and none where none is",
          "[property]") {
  const std::vector<NamedCage> surfaces = suite_surfaces(tests::fixtures().string());
  const std::vector<model::Cutter> cutters = suite_cutters();
  std::mt19937 random(2211);
  const int wanted = by_effort(4, 200);
  int planted = 0;
  for (int number = 0; planted < wanted && number < 2 * wanted; ++number) {
    const auto sound = job_of(surfaces, cutters, static_cast<std::size_t>(number));
    const Side side = number % 2 == 0 ? Side::gouge : Side::uncut;
    const ToleratedJob job(*sound, with_mishap(*sound, side, random),
                           some_tolerances(sound->cutter, random));
    const Interval figure = job.found(side).figure_mm;
    const double most = truth(job, side, random), stated = job.stated(side).high;
    CAPTURE(number, sound->part.name, sound->cutter.id, side, stated, most, figure.low,
            figure.high);
    CHECK(most <= figure.high + kNanometre_mm);
    // The twin: the same, with a limit that no value exceeds, as far as the oracle can tell.
    const double possible = std::max(most, read_at_named(job, side, false));
    const verifier::Verdict twin = job.verdict(side, possible + kResolution_mm + kMarch_mm);
    CHECK(twin != verifier::Verdict::fail);
    // Where the rim of what can be reached stays open, figures are wide.
    const bool narrow = job.found(side).reached_resolution;
    if (narrow) CHECK(twin == verifier::Verdict::pass);
    const double shown = most - kResolution_mm;
    if (shown <= stated) continue;
    const double limit = stated + between(0, 1, random) * (shown - stated);
    const verifier::Verdict verdict = job.verdict(side, limit);
    CHECK(verdict != verifier::Verdict::pass);
    if (!narrow) continue;
    ++planted;
    CHECK(verdict == verifier::Verdict::fail);
    CHECK(read_at_named(job, side, false) > limit);
  }
  CHECK(planted == wanted);
}

}  // namespace limitgauge::tests::defects
