#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "simulator/process/clearance_map.h"
#include "simulator/process/contact_search.h"
#include "simulator/process/finding.h"
#include "simulator/process/gap_search.h"
#include "simulator/process/tool_bodies.h"
#include "simulator/stock/stock_model.h"
#include "simulator/sweep/move_runs.h"

namespace limitgauge::simulator {

/// How fine a check against the stock is.
struct StockLimits {
  double tolerance_mm = 0;
  double near_miss_mm = 0;  ///< 0: not looked for

  /// Shallower contacts are sliding, or rounding.
  double slightest_mm() const { return tolerance_mm / 10; }
};

/// Checks the moves of one pass against the stock as it stands at each of them. The rules are those
/// of process_check.h. May be asked from several threads at once.
class StockCheck {
 public:
  StockCheck(const StockModel& before, const Pass& pass, const ToolBodies& bodies,
             const StockLimits& limits);

  /// Appends what is wrong with a move, in no order.
  void look_at(std::size_t move, std::vector<Finding>& findings) const;

 private:
  void look_at_cutter(std::size_t i, const SweptMove& tip, std::vector<Finding>& findings) const;
  void look_at_rapid(std::size_t i, const SweptMove& tip, std::vector<Finding>& findings) const;
  bool goes_deeper(std::size_t i, double depth_mm) const;
  void look_at_descent(std::size_t i, const SweptMove& tip, std::vector<Finding>& findings) const;
  double slight_depth_mm(std::size_t i) const;
  void look_above_flutes(std::size_t i, const SweptMove& tip, std::vector<Finding>& findings) const;
  void look_over_flutes(std::size_t i, const SweptMove& tip, std::vector<Finding>& findings) const;
  void look_at_wide_part(const ToolBody& body, std::size_t i, const SweptMove& tip,
                         std::vector<Finding>& findings) const;
  void look_at_rapids_gap(std::size_t i, const SweptMove& tip,
                          std::vector<Finding>& findings) const;

  std::optional<Contact> contact(const ToolBody& body, const SweptMove& tip, std::size_t end) const;
  std::optional<Contact> contact_of_flutes(const SweptMove& tip, std::size_t end) const;
  /// Appends a contact as `kind`, or one within the tolerance as what it is; true for the former.
  bool look_for(FindingKind kind, const ToolBody& body, std::size_t i, const SweptMove& tip,
                std::size_t end, std::vector<Finding>& findings) const;
  bool follows_flutes(const ToolBody& body, std::size_t i, const SweptMove& tip) const;
  bool descends_too_steeply(std::size_t i) const;
  MoveRuns stairs() const;
  bool backs_out(std::size_t i) const;
  std::optional<SweptMove> beyond_way_back(std::size_t i) const;
  bool keeps_to_its_hole(std::size_t i) const;
  std::vector<SweptMove> feeds_beside(std::size_t i) const;
  SweptMove tip(std::size_t i) const;
  SweptMove run_of(std::size_t i) const;
  MaterialAtMove material_at(std::size_t end) const;
  Finding finding(FindingKind kind, std::size_t i, const model::Vec3& point, double depth,
                  ToolPart part) const;

  const Material& before_;
  const Pass& pass_;
  const model::Toolpath& path_;
  const ToolBodies& bodies_;
  StockLimits limits_;
  ClearanceMap map_;
  MoveRuns lines_;
  IdleSeries idle_;
  MoveRuns descents_, stairs_;
  // Most paths are cleared without it, and it is the largest thing here.
  mutable std::once_flag indexed_;
  mutable std::unique_ptr<const SweepIndex> sweep_;
};

}  // namespace limitgauge::simulator
