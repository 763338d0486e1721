#include "engine/strategy/locations/ball_sections.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

#include "engine/surface/offset_model.h"
#include "engine/surface/rim.h"
#include "engine/tolerance.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

constexpr double kMeshShare = 0.25, kRimShare = 0.1;
/// Across the rows, in the drive frame.
constexpr int kAcross = 1;

std::vector<PlanePoint> in_plane(const surface::SectionChain& chain) {
  std::vector<PlanePoint> curve;
  curve.reserve(chain.points.size() + 1);
  for (const Vec3& p : chain.points) curve.push_back({p.x, p.z});
  if (chain.closed) curve.push_back(curve.front());
  return curve;
}

/// What the grids of a stage are made of.
struct GridSource {
  surface::OffsetSampler sampler;
  surface::Rim rim;
  DriveFrame frame;
  double reach_mm = 0, rim_error_mm = 0;

  surface::Grid turned(surface::Grid grid) const {
    for (Vec3& p : grid.points) p = frame.to_drive(p);
    return grid;
  }
  surface::Grid patch(int p) const { return turned(sampler.grid(p, reach_mm)); }
  surface::Grid corner(int p, int c) const { return turned(sampler.corner(p, c, reach_mm)); }
  surface::Grid tube(std::size_t line) const {
    return turned(surface::rolling_tube(rim.lines[line], reach_mm, rim_error_mm));
  }
  surface::Grid ball(std::size_t point) const {
    return turned(surface::rolling_ball(rim.points[point], reach_mm, rim_error_mm));
  }
};

/// Patches, their corners, tubes along the rim and balls at its points.
class PieceList {
 public:
  explicit PieceList(GridSource source)
      : from_(std::make_shared<const GridSource>(std::move(source))) {}

  std::vector<surface::SectionPiece> take() {
    add_patches();
    add_rim();
    return std::move(pieces_);
  }

 private:
  void add(std::size_t points, std::function<surface::Grid()> make) {
    pieces_.push_back({points, std::move(make)});
  }
  void add_patches() {
    const surface::OffsetSampler& sampler = from_->sampler;
    for (int p = 0; p < sampler.patches(); ++p)
      add(sampler.grid_points(p), [from = from_, p] { return from->patch(p); });
    for (int p = 0; p < sampler.patches(); ++p)
      for (int c = 0; c < sampler.corners(p, from_->reach_mm); ++c)
        add(sampler.corner_points(p, c), [from = from_, p, c] { return from->corner(p, c); });
  }
  void add_rim() {
    const double reach = from_->reach_mm, error = from_->rim_error_mm;
    for (std::size_t i = 0; i < from_->rim.lines.size(); ++i)
      add(surface::rolling_tube_points(from_->rim.lines[i].size(), reach, error),
          [from = from_, i] { return from->tube(i); });
    for (std::size_t i = 0; i < from_->rim.points.size(); ++i)
      add(surface::rolling_ball_points(reach, error), [from = from_, i] { return from->ball(i); });
  }

  std::shared_ptr<const GridSource> from_;
  std::vector<surface::SectionPiece> pieces_;
};

}  // namespace

BallSections::BallSections(const surface::PatchModel& model, const StageRequest& request,
                           const DriveFrame& frame, double reduction_mm,
                           const model::RunControl& control, std::size_t most_points)
    : reach_(request.cutter.radius_mm() + request.allowance_mm) {
  measure(model, frame);
  const double mesh_error = kMeshShare * request.cut.tolerance_mm;
  surface::OffsetSampler sampler(model, mesh_error);
  reach_ += mesh_error + reduction_mm;
  reach_ += sampler.excess_mm(reach_);
  intervals_ = sampler.intervals();
  surface::Rim rim = surface::find_rim(sampler);
  std::vector<surface::SectionPiece> pieces =
      PieceList(
          {std::move(sampler), std::move(rim), frame, reach_, kRimShare * request.cut.tolerance_mm})
          .take();
  // Where all are within the bound they stay, and are measured as they are made.
  if (surface::points_of(pieces) > most_points) surface::measure_ranges(pieces, kAcross, control);
  sections_.emplace(std::move(pieces), kAcross, most_points, control);
}

void BallSections::measure(const surface::PatchModel& model, const DriveFrame& frame) {
  low_ = std::numeric_limits<double>::infinity();
  high_ = -low_;
  for (const surface::ModelPatch& patch : model.patches())
    for (const Vec3& p : patch.limit.points) {
      const double across = frame.to_drive(p).y;
      low_ = std::min(low_, across);
      high_ = std::max(high_, across);
    }
}

std::size_t BallSections::each_envelope(std::span<const double> across_mm,
                                        const model::RunControl& control, const Take& take) const {
  return sections_->trace(across_mm, control,
                          [&](std::size_t plane, std::vector<surface::SectionChain>& chains) {
                            std::vector<std::vector<PlanePoint>> curves;
                            curves.reserve(chains.size());
                            for (const surface::SectionChain& chain : chains)
                              curves.push_back(in_plane(chain));
                            chains.clear();
                            take(plane, upper_envelope(curves, kSamePlace_mm));
                          });
}

std::vector<Envelope> BallSections::envelopes(std::span<const double> across_mm,
                                              const model::RunControl& control) const {
  std::vector<Envelope> found(across_mm.size());
  each_envelope(across_mm, control,
                [&](std::size_t plane, Envelope envelope) { found[plane] = std::move(envelope); });
  return found;
}

}  // namespace limitgauge::engine::strategy
