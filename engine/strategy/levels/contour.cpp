#include "engine/strategy/strategies.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "engine/strategy/levels/contour_writer.h"
#include "engine/surface/offset_model.h"
#include "engine/tolerance.h"

namespace limitgauge::engine::strategy {
namespace {

/// Share of the tolerance given to the chord error of the sampled limit mesh, and of a pixel given
/// to leaving out points of the loops along the border.
constexpr double kMeshShare = 0.5, kReductionShare = 0.25;
/// The border lies this share of a pixel inside what the field allows: between samples half a pixel
/// apart the field is lower by at most a quarter; interpolation adds less than a tenth.
constexpr double kBorderSlack = 0.35;
/// Chords of the other loops, in cutting radii.
constexpr double kLoopError = 1.0 / 40;
/// Of a helix, in cutting radii: no core is left standing, and what the last turn leaves of its
/// slope is under the cutter where it ends.
constexpr double kHelix = 0.5;

class ContourPlanner {
 public:
  ContourPlanner(const surface::PatchModel& model, const StageRequest& request,
                 const model::RunControl& control)
      : model_(model),
        request_(request),
        control_(control),
        stock_(model::bounding_box(request.stock)),
        outline_(request.stock),
        widest_(model::largest_radius_mm(request.cutter)) {
    loops_.stock = stock_;
    loops_.cut_radius_mm = profile_radius_mm(request.cutter, request.cut.step_mm);
  }

  StagePath plan() {
    StagePath stage;
    build_maps(stage);
    place_levels();
    set_rules();
    plan_levels();
    stage.path = write_path();
    stage.planes = static_cast<int>(levels_.size());
    return stage;
  }

 private:
  struct Level {
    double z = 0;
    std::size_t plan = 0;  ///< index into plans_
  };

  double pixel() const {
    constexpr double kFinest = 0.05, kCoarsest = 0.2, kMostPixels = 4e6, kAcross = 3;
    const model::Vec3 size = stock_.grown(2 * widest_ + request_.allowance_mm).size();
    const double wanted = std::max(std::clamp(2 * request_.cut.tolerance_mm, kFinest, kCoarsest),
                                   std::sqrt(size.x * size.y / kMostPixels));
    return std::min(wanted, loops_.cut_radius_mm / kAcross);
  }

  void build_maps(StagePath& stage) {
    const double mesh_error = kMeshShare * request_.cut.tolerance_mm;
    const surface::OffsetSampler sampler(model_, mesh_error);
    set_intervals(stage, sampler.intervals());
    constexpr double kOutside = 1, kCoarseAcross = 12;
    const double p = pixel();
    const double kept = request_.allowance_mm + mesh_error + sampler.excess_mm(0);
    const int factor = std::max(1, static_cast<int>(loops_.cut_radius_mm / kCoarseAcross / p));
    discs_ = disc_stack(request_.cutter, kept, 2 * p);
    coarse_discs_ = disc_stack(request_.cutter, kept, 2 * p * factor);
    map_ = make_height_map(cover(stock_.grown(2 * widest_ + kept + kOutside + 2 * p), p), sampler);
    coarse_ = coarsened(map_, factor);
  }

  void set_rules() {
    const double p = map_.raster.pixel_mm, coarse = coarse_.raster.pixel_mm;
    const double half_diagonal = coarse / std::numbers::sqrt2;
    loops_.border_error_mm = kReductionShare * p;
    loops_.border_mm = (kReductionShare + kBorderSlack) * p;
    loops_.error_mm = kLoopError * loops_.cut_radius_mm;
    // Two loops meet half way in pixels that either sweeps whole.
    loops_.spacing_mm = 2 * (loops_.cut_radius_mm - half_diagonal - loops_.error_mm - 0.1 * coarse);
    loops_.stock_pixels = pixels_of_stock(half_diagonal);
    passes_.direction = request_.cut.direction;
    passes_.cut_radius_mm = loops_.cut_radius_mm;
    passes_.widest_mm = widest_;
    passes_.helix_radius_mm = kHelix * loops_.cut_radius_mm;
  }

  std::vector<std::uint8_t> pixels_of_stock(double within_mm) const {
    const Raster& r = coarse_.raster;
    std::vector<std::uint8_t> stock(r.size());
    for (int j = 0; j < r.rows; ++j)
      for (int i = 0; i < r.columns; ++i)
        stock[static_cast<std::size_t>(j) * r.columns + i] =
            outline_.distance_mm({r.x(i), r.y(j)}) <= within_mm;
    return stock;
  }

  void place_levels() {
    const double top = stock_.high.z, floor = request_.floor_z_mm;
    const auto count =
        static_cast<int>(std::ceil((top - floor) / request_.cut.step_mm - kWholeStep));
    for (int k = 1; k <= count; ++k)
      levels_.push_back({std::max(floor, top - k * request_.cut.step_mm), 0});
  }

  /// Levels whose forbidden regions are equal share their passes.
  void plan_levels() {
    std::vector<double> all, heights;
    for (const Level& level : levels_) all.push_back(level.z);
    const auto fine = level_signatures(map_, discs_, all);
    const auto coarse = level_signatures(coarse_, coarse_discs_, all);
    std::map<std::pair<std::vector<std::size_t>, std::vector<std::size_t>>, std::size_t> known;
    for (std::size_t i = 0; i < levels_.size(); ++i) {
      const auto [at, fresh] = known.try_emplace({fine[i], coarse[i]}, heights.size());
      if (fresh) heights.push_back(levels_[i].z);
      levels_[i].plan = at->second;
    }
    plans_.resize(heights.size());
    model::parallel_for(heights.size(), control_.threads, [&](std::size_t i) {
      control_.check();
      plans_[i] = plan_level(heights[i]);
      control_.report(static_cast<double>(i + 1) / static_cast<double>(heights.size()));
    });
  }

  std::vector<LevelPass> plan_level(double z) const {
    constexpr double kNearPixels = 4;
    const double p = map_.raster.pixel_mm;
    const Window near = covering(map_.raster, stock_.grown(loops_.cut_radius_mm + 2 * p));
    const LevelSpace space(coarse_.raster, level_field(coarse_, coarse_discs_, z),
                           near_field(map_, discs_, z, near, loops_.border_mm + kNearPixels * p));
    PassRule rule = passes_;
    rule.longest_link_mm = longest_link_mm(z);
    return order_loops(level_loops(space, outline_, loops_), space, outline_, loops_, rule);
  }

  /// A link of length d takes d / feed, a retract (d + 2 h) / rapid and the plunge.
  double longest_link_mm(double z) const {
    const CutOptions& cut = request_.cut;
    const double slow = 1 / cut.link_feed_mm_min - 1 / request_.rapid_mm_min;
    const double retract = 2 * (clear_height() - z) / request_.rapid_mm_min +
                           (request_.clearance_mm + cut.step_mm) / cut.plunge_feed_mm_min;
    return slow > 0 ? retract / slow : stock_.size().x + stock_.size().y;
  }

  double clear_height() const {
    return clear_height_mm(request_, model_.bounding_box().high.z + request_.allowance_mm);
  }

  model::Toolpath write_path() const {
    ContourWriter writer(request_, clear_height());
    // Rounded cutters leave cusps between their passes, lower than a level is thick.
    const bool cusps = loops_.cut_radius_mm > profile_radius_mm(request_.cutter, 0);
    double above = stock_.high.z;
    for (const Level& level : levels_) {
      writer.begin_level(level.z, above + (cusps ? request_.cut.step_mm : 0));
      for (const LevelPass& pass : plans_[level.plan]) writer.write(pass);
      writer.end_level();
      above = level.z;
    }
    return writer.take();
  }

  const surface::PatchModel& model_;
  const StageRequest& request_;
  const model::RunControl& control_;
  model::Box3 stock_;
  StockOutline outline_;
  double widest_;  ///< radius of the cutter
  HeightMap map_, coarse_;
  std::vector<Disc> discs_, coarse_discs_;
  LoopRule loops_;
  PassRule passes_;
  std::vector<Level> levels_;
  std::vector<std::vector<LevelPass>> plans_;
};

void require_valid(const CutOptions& cut) {
  if (!(cut.link_feed_mm_min > 0))
    throw std::invalid_argument("link_feed must be a positive number");
  constexpr double kUpright_deg = 90;
  if (cut.entry != Entry::plunge && !(cut.ramp_angle_deg > 0 && cut.ramp_angle_deg < kUpright_deg))
    throw std::invalid_argument("ramp_angle must lie between 0 and 90 degrees");
}

}  // namespace

StagePath plan_contour(const surface::FinishModel& model, const StageRequest& request,
                       const model::RunControl& control) {
  require_valid(request.cut);
  return ContourPlanner(model.patches(), request, control).plan();
}

}  // namespace limitgauge::engine::strategy
