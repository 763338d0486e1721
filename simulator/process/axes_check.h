#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "simulator/instrument/stock_check.h"
#include "simulator/process/finding.h"
#include "simulator/process/process_limits.h"
#include "simulator/process/tool_bodies.h"
#include "simulator/process/turning/turn_search.h"
#include "simulator/stock/stock_model.h"
#include "simulator/sweep/move_runs.h"

namespace limitgauge::simulator {

/// Checks the moves of a pass that turns its tool as it goes, by the searches of turns. The rules
/// are those of process_check.h, with what is said there of such passes. May be asked from several
/// threads at once.
class AxesCheck {
 public:
  /// `pass` must have axes. All must outlive it but the fixtures. Throws as check_process.
  AxesCheck(const StockModel& before, const Pass& pass, const ProcessLimits& limits,
            const model::RunControl& control);

  void look_at(std::size_t move, const model::RunControl& control,
               std::vector<Finding>& findings) const;

 private:
  struct Solid {
    std::string name;
    Material solid;
    bool is_stock = false;
  };
  /// One move as the searches have it.
  struct Turning {
    std::size_t move = 0;
    TurningPose pose;
    const model::RunControl& control;
  };

  struct Looked {
    FindingKind kind;
    const Turning& m;
    const ToolBody& body;
    std::size_t solid = 0;
  };

  TurnSearch search(const Turning& m, const ToolBody& body, std::size_t solid,
                    std::size_t end) const;
  bool look_for(FindingKind kind, const Turning& m, const ToolBody& body, std::size_t solid,
                std::size_t end, std::vector<Finding>& findings) const;
  /// Of a part above the flutes, against what stands when it gets there.
  bool look_for_part(FindingKind kind, const Turning& m, const ToolBody& body,
                     std::vector<Finding>& findings) const;
  /// `look(tolerance)` gives the answer of a search.
  template <class Look>
  bool look_by(const Look& look, const Looked& what, std::vector<Finding>& findings) const;
  void look_near(const Turning& m, const ToolBody& body, std::size_t solid, std::size_t end,
                 double from, double to, std::vector<Finding>& findings) const;
  void look_at_cutter(const Turning& m, std::vector<Finding>& findings) const;
  void look_at_rapid(const Turning& m, std::vector<Finding>& findings) const;
  void look_above_flutes(const Turning& m, std::vector<Finding>& findings) const;
  void look_at_fixtures(const Turning& m, std::vector<Finding>& findings) const;
  bool descends_too_steeply(std::size_t i) const;
  bool rises(std::size_t i) const;
  bool backs_out(std::size_t i) const;
  double reach_into_stock(std::size_t i) const;
  double aside_mm(std::size_t i, double reach_mm) const;
  bool follows_flutes(const Turning& m, const ToolBody& body, double within_mm) const;
  Finding finding(FindingKind kind, const Turning& m, const model::Vec3& point, double depth_mm,
                  const ToolBody& body, std::size_t solid) const;

  const Pass& pass_;
  const model::Toolpath& path_;
  StockLimits limits_;
  std::vector<Solid> solids_;  // the stock, then the fixtures
  ToolBodies bodies_;
  SweepIndex sweep_;
  IdleSeries idle_;
};

}  // namespace limitgauge::simulator
