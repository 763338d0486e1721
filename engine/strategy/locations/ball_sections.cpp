#include "engine/strategy/locations/ball_sections.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "engine/surface/offset_model.h"
#include "engine/surface/rim.h"
#include "engine/tolerance.h"
#include "model/base/chunks.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;
using Curves = std::vector<std::vector<PlanePoint>>;

constexpr double kMeshShare = 0.25, kRimShare = 0.1;
/// Across the rows, in the drive frame.
constexpr int kAcross = 1;
/// Drive planes cut by one thread at a time: neighbours go through the same memory.
constexpr std::size_t kPlanesAChunk = 16;

std::vector<PlanePoint> in_plane(const surface::SectionChain& chain) {
  std::vector<PlanePoint> curve;
  curve.reserve(chain.points.size() + 1);
  for (const Vec3& p : chain.points) curve.push_back({p.x, p.z});
  if (chain.closed) curve.push_back(curve.front());
  return curve;
}

}  // namespace

BallSections::BallSections(const surface::PatchModel& model, const StageRequest& request,
                           const DriveFrame& frame, double reduction_mm,
                           const model::RunControl& control)
    : reach_(request.cutter.radius_mm() + request.allowance_mm) {
  measure(model, frame);
  std::vector<surface::Grid> grids = all_grids(model, request, reduction_mm);
  std::vector<std::optional<surface::GridSection>> built(grids.size());
  model::parallel_chunks(grids.size(), 1, control, [&](std::size_t g, std::size_t) {
    for (Vec3& p : grids[g].points) p = frame.to_drive(p);
    built[g].emplace(std::move(grids[g]), kAcross);
  });
  sections_.reserve(built.size());
  for (auto& section : built) sections_.push_back(std::move(*section));
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

std::vector<surface::Grid> BallSections::all_grids(const surface::PatchModel& model,
                                                   const StageRequest& request,
                                                   double reduction_mm) {
  const double mesh_error = kMeshShare * request.cut.tolerance_mm;
  reach_ += mesh_error + reduction_mm;
  surface::OffsetModel offset = surface::sample_offset(model, reach_, mesh_error);
  if (offset.excess_mm > 0) {
    reach_ += offset.excess_mm;
    offset = surface::sample_offset(model, reach_, mesh_error);
  }
  intervals_ = std::move(offset.intervals);
  std::vector<surface::Grid> grids = std::move(offset.grids);
  grids.insert(grids.end(), std::make_move_iterator(offset.corners.begin()),
               std::make_move_iterator(offset.corners.end()));
  const surface::Rim rim = surface::find_rim(surface::OffsetSampler(model, mesh_error));
  const double rim_error = kRimShare * request.cut.tolerance_mm;
  for (const auto& line : rim.lines)
    grids.push_back(surface::rolling_tube(line, reach_, rim_error));
  for (const Vec3& point : rim.points)
    grids.push_back(surface::rolling_ball(point, reach_, rim_error));
  return grids;
}

std::vector<Envelope> BallSections::envelopes(std::span<const double> across_mm,
                                              const model::RunControl& control) const {
  std::vector<surface::SectionStarts> starts(sections_.size());
  model::parallel_chunks(sections_.size(), 1, control, [&](std::size_t g, std::size_t) {
    starts[g] = sections_[g].starts(across_mm);
  });
  std::vector<Envelope> found(across_mm.size());
  model::parallel_chunks(
      across_mm.size(), kPlanesAChunk, control, [&](std::size_t begin, std::size_t end) {
        surface::SectionScratch scratch;
        std::vector<Curves> rows(end - begin);
        std::vector<surface::SectionChain> chains;
        for (std::size_t g = 0; g < sections_.size(); ++g) {
          if (starts[g].empty()) continue;
          for (std::size_t k = begin; k < end; ++k) {
            chains.clear();
            sections_[g].trace(starts[g], k, across_mm[k], scratch, chains);
            for (const auto& chain : chains) rows[k - begin].push_back(in_plane(chain));
          }
        }
        for (std::size_t k = begin; k < end; ++k)
          found[k] = upper_envelope(rows[k - begin], kSamePlace_mm);
        control.report(static_cast<double>(end) / static_cast<double>(across_mm.size()));
      });
  return found;
}

}  // namespace limitgauge::engine::strategy
