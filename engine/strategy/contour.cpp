#include "engine/strategy/contour.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "engine/strategy/contour_level.h"
#include "engine/strategy/path_builder.h"
#include "engine/surface/offset_model.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

/// Share of the tolerance given to the chord error of the sampled limit mesh, and of a pixel given
/// to leaving out points of loops.
constexpr double kMeshShare = 0.5, kReductionShare = 0.25;
/// Samples of a link lie half a pixel apart, so the field between them is lower by at most a
/// quarter; bilinear interpolation of a distance adds less than a tenth.
constexpr double kLinkSlack = 0.35;
/// Step-over in cutter radii: below one, so that loops leave nothing between them.
constexpr double kStepOver = 0.95;
/// How far outside the stock a cutter may go beyond touching it, mm.
constexpr double kOutside = 0.5;
/// Slope of entries that cannot start outside the stock.
constexpr double kRampSlope = 0.05;

class ContourPlanner {
 public:
  ContourPlanner(const surface::PatchModel& model, const StageRequest& request,
                 const model::RunControl& control)
      : model_(model),
        request_(request),
        control_(control),
        stock_(model::bounding_box(request.stock)),
        radius_(request.cutter.radius_mm()) {}

  StagePath plan() {
    build_map();
    place_levels();
    build_loops();
    StagePath stage;
    stage.path = write_path();
    stage.planes = static_cast<int>(levels_.size());
    stage.sampling_interval_min = interval_min_;
    stage.sampling_interval_max = interval_max_;
    return stage;
  }

 private:
  struct Level {
    double z = 0;
    std::size_t loops = 0;  ///< index into loops_
  };

  double pixel() const {
    constexpr double kFinest = 0.05, kCoarsest = 0.2, kMostPixels = 4e6;
    const Vec3 size = stock_.grown(2 * radius_ + request_.allowance_mm).size();
    return std::max(std::clamp(2 * request_.cut.tolerance_mm, kFinest, kCoarsest),
                    std::sqrt(size.x * size.y / kMostPixels));
  }

  void build_map() {
    const double mesh_error = kMeshShare * request_.cut.tolerance_mm;
    surface::OffsetModel mesh = surface::sample_offset(model_, 0, mesh_error);
    interval_min_ = mesh.interval_min;
    interval_max_ = mesh.interval_max;
    const double p = pixel();
    const double kept = request_.allowance_mm + mesh_error + std::max(0.0, mesh.excess_mm);
    discs_ = disc_stack(request_.cutter, kept, 2 * p);
    const Raster raster = cover(stock_.grown(2 * radius_ + kept + kOutside + 2 * p), p);
    map_ = make_height_map(raster, mesh.grids);
    rule_.step_over_mm = kStepOver * cutting_radius();
    rule_.reduction_mm = kReductionShare * p;
    rule_.slack_mm = kLinkSlack * p;
    const model::Box3 reach = stock_.grown(radius_ + kOutside);
    rule_.window = {static_cast<int>(std::floor((reach.low.x - raster.x0) / p)),
                    static_cast<int>(std::floor((reach.low.y - raster.y0) / p)),
                    static_cast<int>(std::ceil((reach.high.x - raster.x0) / p)),
                    static_cast<int>(std::ceil((reach.high.y - raster.y0) / p))};
  }

  /// The radius with which a cutter clears a layer one level thick: a rounded one leaves cusps
  /// below the height of a level.
  double cutting_radius() const {
    const bool ball = request_.cutter.type == model::CutterType::ball;
    const bool flat = request_.cutter.type == model::CutterType::flat;
    const double corner = ball ? radius_ : flat ? 0.0 : request_.cutter.corner_radius_mm;
    const double rise = std::min(request_.cut.step_mm, corner);
    return radius_ - corner + std::sqrt(corner * corner - (corner - rise) * (corner - rise));
  }

  void place_levels() {
    const double top = stock_.high.z, floor = request_.floor_z_mm;
    constexpr double kWholeStep = 1e-6;
    const auto count =
        static_cast<int>(std::ceil((top - floor) / request_.cut.step_mm - kWholeStep));
    for (int k = 1; k <= count; ++k)
      levels_.push_back({std::max(floor, top - k * request_.cut.step_mm), 0});
  }

  /// Levels whose forbidden regions are equal share their loops.
  void build_loops() {
    std::vector<float> sorted = map_.z;
    std::sort(sorted.begin(), sorted.end());
    std::map<std::vector<std::size_t>, std::size_t> known;
    std::vector<double> heights;
    for (Level& level : levels_) {
      const auto signature = level_signature(sorted, discs_, level.z);
      const auto [at, fresh] = known.try_emplace(signature, heights.size());
      if (fresh) heights.push_back(level.z);
      level.loops = at->second;
    }
    loops_.resize(heights.size());
    model::parallel_for(heights.size(), control_.threads, [&](std::size_t i) {
      control_.check();
      loops_[i].emplace(map_.raster, level_field(map_, discs_, heights[i]), rule_);
      control_.report(static_cast<double>(i + 1) / static_cast<double>(heights.size()));
    });
  }

  double clear_height() const {
    return std::max(stock_.high.z, model_.bounding_box().high.z + request_.allowance_mm) +
           request_.clearance_mm;
  }

  model::Toolpath write_path() const {
    PathBuilder path(request_, clear_height());
    double above = stock_.high.z;
    for (const Level& level : levels_) {
      for (const auto& group : loops_[level.loops]->groups())
        write_group(group, level, above, path);
      path.retract();
      above = level.z;
    }
    return path.take();
  }

  /// The nearest loop next; an open one from its nearer end, a closed one from its nearest point.
  void write_group(const std::vector<Isoline>& group, const Level& level, double above,
                   PathBuilder& path) const {
    std::vector<char> done(group.size(), 0);
    for (std::size_t n = 0; n < group.size(); ++n) {
      const FlatPoint from{path.position().x, path.position().y};
      std::size_t best = 0, start = 0;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < group.size(); ++k) {
        if (done[k]) continue;
        const auto& points = group[k].points;
        const std::size_t stride = group[k].closed ? 1 : points.size() - 1;
        for (std::size_t i = 0; i < points.size(); i += stride)
          if (const double d = distance(points[i], from); d < nearest) {
            nearest = d;
            best = k;
            start = i;
          }
      }
      done[best] = 1;
      write_loop(turned(group[best], start), group[best].closed, level, above, path);
    }
  }

  static std::vector<FlatPoint> turned(const Isoline& line, std::size_t start) {
    std::vector<FlatPoint> points = line.points;
    if (!line.closed) {
      if (start != 0) std::reverse(points.begin(), points.end());
      return points;
    }
    points.pop_back();
    std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(start % points.size()),
                points.end());
    points.push_back(points.front());
    return points;
  }

  void write_loop(const std::vector<FlatPoint>& loop, bool closed, const Level& level, double above,
                  PathBuilder& path) const {
    const FlatPoint at{path.position().x, path.position().y};
    const auto point = [&](const FlatPoint& p) { return Vec3{p.x, p.y, level.z}; };
    // A longer way at the feed takes more time than a retract.
    const double longest_link = 2 * (path.clear_z() - level.z) + 4 * radius_;
    const bool link = path.down() && distance(at, loop.front()) <= longest_link &&
                      loops_[level.loops]->clear_between(at, loop.front());
    if (link) {
      path.cut_to(point(loop.front()));
    } else if (!closed) {
      path.enter_at(point(loop.front()));
    } else {
      ramp_in(loop, level.z, above, path);
    }
    for (std::size_t i = 1; i < loop.size(); ++i) path.cut_to(point(loop[i]));
  }

  /// Down to what the level above has cleared, then round the loop on a slope until the level is
  /// reached, and on to the loop's start.
  void ramp_in(const std::vector<FlatPoint>& loop, double z, double above,
               PathBuilder& path) const {
    path.enter_at({loop.front().x, loop.front().y, above});
    double round = 0;
    for (std::size_t k = 1; k < loop.size(); ++k) round += distance(loop[k - 1], loop[k]);
    // A loop that reduction drew together to a point has no way to ramp along.
    if (round <= rule_.reduction_mm) {
      path.cut_to({loop.front().x, loop.front().y, z});
      return;
    }
    double height = above;
    for (std::size_t i = 1; height > z; i = i % (loop.size() - 1) + 1) {
      const FlatPoint a = loop[i - 1], b = loop[i];
      const double length = distance(a, b), fall = length * kRampSlope;
      if (fall >= height - z) {
        const double t = (height - z) / fall;
        path.cut_to({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t, z});
        for (std::size_t k = i; k < loop.size(); ++k) path.cut_to({loop[k].x, loop[k].y, z});
        return;
      }
      height -= fall;
      path.cut_to({b.x, b.y, height});
    }
  }

  const surface::PatchModel& model_;
  const StageRequest& request_;
  const model::RunControl& control_;
  model::Box3 stock_;
  double radius_;
  int interval_min_ = 1, interval_max_ = 1;
  HeightMap map_;
  std::vector<Disc> discs_;
  LoopRule rule_;
  std::vector<Level> levels_;
  std::vector<std::optional<ContourLevel>> loops_;
};

}  // namespace

StagePath plan_contour(const surface::FinishModel& model, const StageRequest& request,
                       const model::RunControl& control) {
  return ContourPlanner(model.patches(), request, control).plan();
}

}  // namespace limitgauge::engine::strategy
