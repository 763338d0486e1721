#include "engine/strategy/row_links.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/strategy/drive_frame.h"
#include "engine/strategy/path_builder.h"

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

class RowLinks {
 public:
  RowLinks(const DriveRows& rows, const StageRequest& request)
      : rows_(rows), request_(request), frame_(request.cut.angle_deg) {}

  model::Toolpath path() {
    PathBuilder path(request_, clear_height());
    const bool one_way = request_.cut.pattern == RowPattern::one_way;
    const bool leftwards = one_way && request_.cut.direction == CutDirection::conventional;
    const DriveRow* before = nullptr;
    bool backwards = false;
    for (std::size_t i = 0; i < rows_.rows.size(); ++i) {
      const DriveRow& row = rows_.rows[leftwards ? i : rows_.rows.size() - 1 - i];
      const std::vector<Vec3> line = tips(row, backwards);
      if (line.empty()) continue;
      enter(path, before, row, line.front());
      for (std::size_t k = 1; k < line.size(); ++k) path.cut_to(line[k]);
      before = &row;
      backwards = !one_way && !backwards;
    }
    return path.take();
  }

 private:
  double along(const Vec3& p) const { return frame_.to_drive(p).x; }

  static std::vector<Vec3> tips(const DriveRow& row, bool backwards) {
    std::vector<Vec3> line;
    for (const auto& run : row.runs) line.insert(line.end(), run.begin(), run.end());
    if (backwards) std::reverse(line.begin(), line.end());
    return line;
  }

  void enter(PathBuilder& path, const DriveRow* before, const DriveRow& row, const Vec3& start) {
    std::optional<double> z;
    if (before) z = stay_down_height(*before, row, path.position(), start);
    if (!z || *z >= path.clear_z()) {
      path.enter_at(start);
      return;
    }
    const Vec3 from = path.position();
    const double over = std::max({*z, from.z, start.z});
    path.cut_to({from.x, from.y, over});
    path.cut_to({start.x, start.y, over});
    path.cut_to(start);
  }

  /// Tip height at which the tool may go straight from a place of one row to one of the next.
  ///
  /// Let c be a place between the rows and s what the ball touches there, on the side of row b; dx
  /// and dy are its distances from c across and along the rows. If s lies beyond b, the point of b
  /// beside c is nearer to s in plan, and b is no lower there than the ball at c. Otherwise s is
  /// within one step of b across, and the point of b moved along by up to one step towards s is at
  /// most hypot(step, dy - step) <= dy <= |c s| away, or at most one step: then the ball at c is
  /// higher by at most the sagitta of a step. So the highest of both rows within one step along,
  /// the sagitta and the rows' own tolerance will do.
  std::optional<double> stay_down_height(const DriveRow& a, const DriveRow& b, const Vec3& from,
                                         const Vec3& to) const {
    const double reach = request_.cutter.radius_mm() + request_.allowance_mm;
    const double step = std::abs(b.across_mm - a.across_mm);
    constexpr double kNeighbours = 1.5;  // no row between them was empty
    if (step > kNeighbours * request_.cut.step_mm || step >= reach) return std::nullopt;
    const double low = std::min(along(from), along(to)) - step;
    const double high = std::max(along(from), along(to)) + step;
    const double sagitta = reach - std::sqrt(reach * reach - step * step);
    const double z = std::max(highest(a, low, high), highest(b, low, high));
    return std::max(z + sagitta + request_.cut.tolerance_mm, request_.floor_z_mm);
  }

  /// Highest tip of a row between two places along it; minus infinity where it has none.
  double highest(const DriveRow& row, double low, double high) const {
    double z = -std::numeric_limits<double>::infinity();
    for (const auto& run : row.runs)
      for (std::size_t i = 1; i < run.size(); ++i) {
        const double a = along(run[i - 1]), b = along(run[i]);
        if (std::max(a, b) < low || std::min(a, b) > high) continue;
        for (const double s : {std::clamp(a, low, high), std::clamp(b, low, high)})
          z = std::max(z, a == b ? std::max(run[i - 1].z, run[i].z)
                                 : std::lerp(run[i - 1].z, run[i].z, (s - a) / (b - a)));
      }
    return z;
  }

  double clear_height() const {
    double top = -std::numeric_limits<double>::infinity();
    for (const DriveRow& row : rows_.rows)
      for (const auto& run : row.runs)
        for (const Vec3& p : run) top = std::max(top, p.z);
    return clear_height_mm(request_, top);
  }

  const DriveRows& rows_;
  const StageRequest& request_;
  DriveFrame frame_;
};

}  // namespace

model::Toolpath link_rows(const DriveRows& rows, const StageRequest& request) {
  return RowLinks(rows, request).path();
}

}  // namespace limitgauge::engine::strategy
