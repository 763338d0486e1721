#include "engine/strategy/zigzag.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "engine/strategy/envelope.h"
#include "engine/strategy/path_builder.h"
#include "engine/strategy/reduce.h"
#include "engine/surface/offset_model.h"
#include "engine/surface/rim.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;
using surface::GridSection;

constexpr double kMeshShare = 0.5, kRimShare = 0.1, kReductionShare = 0.25;
/// Curves that meet are taken to meet when rounding keeps them this far apart, mm.
constexpr double kSlit = 1e-9;
constexpr int kDriveAxis = 0;
/// Rows planned by one thread at a time, sharing scratch memory.
constexpr std::size_t kRowsABlock = 8;

/// One drive plane and the path of the ball's centre in it.
struct Row {
  double x = 0;
  Envelope centre;
};

class ZigzagPlanner {
 public:
  ZigzagPlanner(const surface::PatchModel& model, const StageRequest& request,
                const model::RunControl& control)
      : model_(model),
        request_(request),
        control_(control),
        reach_(request.cutter.radius_mm() + request.allowance_mm) {}

  StagePath plan() {
    build_sections();
    build_rows();
    StagePath stage;
    stage.path = link_rows();
    stage.planes = static_cast<int>(rows_.size());
    stage.sampling_interval_min = interval_min_;
    stage.sampling_interval_max = interval_max_;
    return stage;
  }

 private:
  void build_sections() {
    const double mesh_error = kMeshShare * request_.cut.tolerance_mm;
    surface::OffsetModel offset = surface::sample_offset(model_, reach_, mesh_error);
    if (offset.excess_mm > 0) {
      reach_ += offset.excess_mm;
      offset = surface::sample_offset(model_, reach_, mesh_error);
    }
    interval_min_ = offset.interval_min;
    interval_max_ = offset.interval_max;
    std::vector<surface::Grid> grids = std::move(offset.grids);
    grids.insert(grids.end(), std::make_move_iterator(offset.corners.begin()),
                 std::make_move_iterator(offset.corners.end()));
    const surface::Rim rim =
        surface::find_rim(model_, surface::sample_offset(model_, 0, mesh_error));
    const double rim_error = kRimShare * request_.cut.tolerance_mm;
    for (const auto& line : rim.lines)
      grids.push_back(surface::rolling_tube(line, reach_, rim_error));
    for (const Vec3& point : rim.points)
      grids.push_back(surface::rolling_ball(point, reach_, rim_error));
    sections_.resize(grids.size());
    model::parallel_for(grids.size(), control_.threads, [&](std::size_t g) {
      sections_[g].emplace(std::move(grids[g]), kDriveAxis);
    });
  }

  /// The paper counts planes over the part's length grown by the cutter's radius at both ends.
  void place_rows() {
    const model::Box3 box = model_.bounding_box();
    const double low = box.low.x - reach_, width = box.size().x + 2 * reach_;
    constexpr double kWholeStep = 0.1;  // of a step: the mesh is a little smaller than the surface
    const int count =
        std::max(1, static_cast<int>(std::floor(width / request_.cut.step_mm + kWholeStep)));
    const double first = low + (width - (count - 1) * request_.cut.step_mm) / 2;
    rows_.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) rows_[i].x = first + i * request_.cut.step_mm;
  }

  void build_rows() {
    place_rows();
    const std::size_t blocks = (rows_.size() + kRowsABlock - 1) / kRowsABlock;
    model::parallel_for(blocks, control_.threads, [&](std::size_t b) {
      control_.check();
      surface::SectionScratch scratch;
      const std::size_t end = std::min(rows_.size(), (b + 1) * kRowsABlock);
      for (std::size_t i = b * kRowsABlock; i < end; ++i) build_row(rows_[i], scratch);
      control_.report(static_cast<double>(b + 1) / static_cast<double>(blocks));
    });
  }

  void build_row(Row& row, surface::SectionScratch& scratch) const {
    std::vector<surface::SectionChain> chains;
    for (const auto& section : sections_)
      if (section->low() < row.x && row.x <= section->high()) section->cut(row.x, scratch, chains);
    std::vector<PlaneSegment> segments;
    for (const surface::SectionChain& chain : chains) {
      const std::size_t n = chain.points.size();
      for (std::size_t i = 1; i < n + (chain.closed ? 1 : 0); ++i) {
        const Vec3 &a = chain.points[i - 1], &b = chain.points[i % n];
        segments.push_back({{a.y, a.z}, {b.y, b.z}});
      }
    }
    row.centre = upper_envelope(std::move(segments), kSlit);
    for (auto& run : row.centre.runs)
      run = reduced(run, kReductionShare * request_.cut.tolerance_mm,
                    [](const PlanePoint& p) { return std::pair(p.s, p.z); });
  }

  Vec3 tip(const Row& row, const PlanePoint& centre) const {
    return {row.x, centre.s, tip_z(centre.z)};
  }
  double tip_z(double centre_z) const {
    return std::max(centre_z - request_.cutter.radius_mm(), request_.floor_z_mm);
  }

  /// Tip heights along a row; where there is nothing under the cutter the ends are bridged.
  std::vector<Vec3> tips(const Row& row, bool backwards) const {
    std::vector<Vec3> line;
    for (const auto& run : row.centre.runs)
      for (const PlanePoint& p : run) line.push_back(tip(row, p));
    if (backwards) std::reverse(line.begin(), line.end());
    return line;
  }

  /// Tip height at which the tool may go straight from a place `y` of one row to one of the next.
  /// A point between the rows that touches some s has a point of a row, no farther along than one
  /// step, whose distance to s is smaller, or at most one step: so its height is at most the
  /// rows' highest within one step plus the sagitta of a step.
  std::optional<double> link_height(const Row& a, const Row& b, double y0, double y1) const {
    const double step = std::abs(b.x - a.x);
    constexpr double kNeighbours = 1.5;
    if (step > kNeighbours * request_.cut.step_mm || step >= reach_) return std::nullopt;
    const double low = std::min(y0, y1) - step, high = std::max(y0, y1) + step;
    const double z = std::max(a.centre.highest(low, high), b.centre.highest(low, high));
    const double sagitta = reach_ - std::sqrt(reach_ * reach_ - step * step);
    return tip_z(z + sagitta + request_.cut.tolerance_mm);
  }

  double clear_height() const {
    double top = model::bounding_box(request_.stock).high.z;
    for (const Row& row : rows_)
      for (const auto& run : row.centre.runs)
        for (const PlanePoint& p : run) top = std::max(top, tip_z(p.z));
    return top + request_.clearance_mm;
  }

  model::Toolpath link_rows() const {
    PathBuilder path(request_, clear_height());
    const Row* before = nullptr;
    bool backwards = false;
    for (const Row& row : rows_) {
      const std::vector<Vec3> line = tips(row, backwards);
      if (line.empty()) continue;
      std::optional<double> z;
      if (before) z = link_height(*before, row, path.position().y, line.front().y);
      if (z && *z < path.clear_z()) {
        const Vec3 from = path.position();
        const double over = std::max({*z, from.z, line.front().z});
        path.cut_to({from.x, from.y, over});
        path.cut_to({row.x, line.front().y, over});
        path.cut_to(line.front());
      } else {
        path.enter_at(line.front());
      }
      for (std::size_t i = 1; i < line.size(); ++i) path.cut_to(line[i]);
      before = &row;
      backwards = !backwards;
    }
    return path.take();
  }

  const surface::PatchModel& model_;
  const StageRequest& request_;
  const model::RunControl& control_;
  double reach_;
  int interval_min_ = 1, interval_max_ = 1;
  std::vector<std::optional<GridSection>> sections_;
  std::vector<Row> rows_;
};

}  // namespace

StagePath plan_zigzag(const surface::FinishModel& model, const StageRequest& request,
                      const model::RunControl& control) {
  return ZigzagPlanner(model.patches(), request, control).plan();
}

}  // namespace limitgauge::engine::strategy
