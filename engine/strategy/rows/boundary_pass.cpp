#include "engine/strategy/rows/boundary_pass.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "engine/strategy/levels/waterline.h"
#include "engine/strategy/linking/cut_pass.h"
#include "engine/strategy/rows/sampled_rows.h"

namespace limitgauge::engine::strategy {
namespace {

using Line = std::vector<Vec3>;

struct LessPoint {
  bool operator()(const Vec3& a, const Vec3& b) const {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  }
};

/// The sides of patches at which the surface ends; it lies on their left.
std::vector<Line> boundary_sides(const surface::OffsetSampler& sampler) {
  const surface::PatchModel& model = sampler.model();
  std::vector<Line> sides;
  for (surface::Index h = 0; h < model.outer().half_edge_count(); ++h) {
    if (!model.has_patch(h) || !model.ends_at(h)) continue;
    sides.push_back(sampler.side(model.patch_at(h), model.side_at(h), 0));
  }
  return sides;
}

bool is_closed(const Line& line) {
  return line.size() > 2 && line.front() == line.back();
}

std::vector<CutPass> rim_passes(const std::vector<Line>& lines, const LimitLocations& limit,
                                const StageRequest& request) {
  std::vector<CutPass> passes;
  for (Line line : lines) {
    std::reverse(line.begin(), line.end());  // the part on the right
    const bool loop = is_closed(line);
    for (auto& run : track_tips(limit.surface, line, track_rule(limit, request))) {
      const bool closed = loop && is_closed(run);
      if (closed) run.pop_back();
      if (run.size() > 1) passes.push_back(contour_pass(std::move(run), closed, request));
    }
  }
  return passes;
}

std::vector<CutPass> outline_passes(const LimitLocations& limit, const StageRequest& request,
                                    const model::RunControl& control) {
  const TrackRule rule = track_rule(limit, request);
  WaterlineRequest wanted;
  wanted.window = limit.surface.fluted_extent().grown(2 * rule.spacing_mm);
  wanted.spacing_mm = rule.spacing_mm;
  wanted.tolerance_mm = rule.lift_mm + rule.reduction_mm;
  std::vector<CutPass> passes;
  for (auto& level : waterlines(
           limit.surface, {std::max(request.floor_z_mm, limit.lowest_contact_mm)}, wanted, control))
    for (Waterline& line : level)
      passes.push_back(contour_pass(std::move(line.tips), line.closed, request));
  return passes;
}

}  // namespace

std::vector<Line> boundary_lines(const surface::OffsetSampler& sampler) {
  std::vector<Line> sides = boundary_sides(sampler);
  std::multimap<Vec3, std::size_t, LessPoint> starts;
  for (std::size_t i = 0; i < sides.size(); ++i) starts.emplace(sides[i].front(), i);
  std::vector<Line> lines;
  while (!starts.empty()) {
    // Boundaries run round: each side is followed by one that starts where it ends.
    Line line = sides[starts.begin()->second];
    starts.erase(starts.begin());
    for (auto next = starts.find(line.back()); next != starts.end() && !is_closed(line);
         next = starts.find(line.back())) {
      const Line& side = sides[next->second];
      line.insert(line.end(), side.begin() + 1, side.end());
      starts.erase(next);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<CutPass> boundary_passes(const LimitLocations& limit, const StageRequest& request,
                                     const model::RunControl& control) {
  const std::vector<Line> lines = boundary_lines(limit.sampler);
  return lines.empty() ? outline_passes(limit, request, control)
                       : rim_passes(lines, limit, request);
}

}  // namespace limitgauge::engine::strategy
