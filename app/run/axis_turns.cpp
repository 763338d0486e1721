#include "app/run/axis_turns.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "app/job/setup_frame.h"
#include "model/text/number_text.h"
#include "simulator/process/turning/turn_check.h"

namespace limitgauge::app {
namespace {

using model::Kinematics;
using model::Pose;
using model::TurningMotion;

/// To the frame of the stage's setup, in which the tool stands upright but for one that turns as it
/// cuts: of that the part lies there as it does with all axes at zero.
Pose workpiece_in_setup(const Job& at_setup, const JobStage& stage) {
  const Pose placed = pose_of(machine_in_setup_frame(at_setup));
  if (stage.piece->turns_while_cutting()) return placed;
  return placed * at_setup.machine.kinematics->upright(stage.piece->range.angles_deg);
}

/// Poses of a tool, in the frame of a stage's setup, during the turns that lead to it.
class TurnPoses {
 public:
  TurnPoses(const Job& at_setup, const JobStage& stage, const TurningMotion& turn)
      : machine_(at_setup.machine.kinematics.value()),
        angles_deg_(stage.piece->range.angles_deg),
        turn_(turn),
        from_workpiece_(workpiece_in_setup(at_setup, stage)) {
    from_machine_ = from_workpiece_ * machine_.table(angles_deg_).inverse();
  }

  simulator::TurningPose in_stock() const { return among({}); }
  /// Among what is mounted so, in the frame that its mesh is in: where it stands after the turns.
  simulator::TurningPose among(const FixtureMount& mount) const {
    if (mount.kind == FixtureMount::Kind::part)
      return simulator::TurningPose::even(
          [*this](double t) { return from_workpiece_ * turn_.tool_at(machine_, t); },
          turn_.tip_speed_mm(machine_), turn_.turn_rad());
    const auto at = [*this, mount](double t) {
      const model::RotaryAngles now = turn_.angles_at(t);
      return from_machine_ * carried(mount, angles_deg_) * carried(mount, now).inverse() *
             machine_.table(now) * turn_.tool_at(machine_, t);
    };
    return simulator::TurningPose::even(at, turn_.machine_tip_speed_mm(machine_), turn_.turn_rad());
  }

  /// Of a body that goes with the tool, which moves as `tool` says, in the other's place.
  simulator::TurningPose with_tool(const simulator::TurningPose& tool, const FixtureMount& mount,
                                   double tool_length_mm) const {
    const auto at = [*this, at = tool.at, mount, tool_length_mm](double t) {
      return at(t) * body_in_tool(machine_, mount, turn_.angles_at(t), tool_length_mm);
    };
    return simulator::TurningPose::even(
        at, tool.tip_speed_mm + turn_.turn_rad() * farthest_gauge_mm(tool_length_mm),
        turn_.turn_rad());
  }

 private:
  /// No less than the way from the tip to where a head that stands at other angles would have the
  /// gauge point, and than the arms of the heads' turns together: each turn about a point takes
  /// the gauge point by twice its distance at most, once for the tool and once for the body.
  double farthest_gauge_mm(double tool_length_mm) const {
    double mm = tool_length_mm;
    for (std::size_t i = 0; i < machine_.axes.size(); ++i)
      if (machine_.is_head(i)) mm += 4 * length(machine_.axes[i].point_mm);
    return mm;
  }
  Pose carried(const FixtureMount& mount, const model::RotaryAngles& angles_deg) const {
    return mount.kind == FixtureMount::Kind::axis ? machine_.carried_by(mount.axis, angles_deg)
                                                  : Pose{};
  }

  Kinematics machine_;
  model::RotaryAngles angles_deg_;
  TurningMotion turn_;
  Pose from_workpiece_, from_machine_;
};

simulator::TurningTool turning_tool(const Job& at_setup, const JobStage& stage,
                                    const model::AxisTurn& turn, const TurnPoses& poses) {
  simulator::TurningTool motion{turn.line, turn.rapid, poses.in_stock(), {}};
  for (const JobFixture& fixture : at_setup.fixtures)
    if (!fixture.mount.with_tool()) motion.in_fixtures.push_back(poses.among(fixture.mount));
  for (const JobFixture& fixture : at_setup.fixtures) {
    if (!fixture.mount.with_tool()) continue;
    const auto with = [&](const simulator::TurningPose& tool) {
      return poses.with_tool(tool, fixture.mount, stage.tool_length_mm.value());
    };
    simulator::TurningTool::Carried& own = motion.carried.emplace_back();
    own.in_stock = with(motion.in_stock);
    for (const simulator::TurningPose& tool : motion.in_fixtures)
      own.in_fixtures.push_back(with(tool));
  }
  return motion;
}

void look_at_limits(const Job& job, const JobStage& stage, const model::AxisTurn& turn,
                    std::vector<simulator::Finding>& findings) {
  constexpr double kRounding_deg = 1e-9;
  for (const model::RotaryAxis& axis : job.machine.kinematics->axes) {
    const double at_deg = turn.turn.to_deg[axis.index()];
    const bool below = at_deg < axis.low_deg - kRounding_deg;
    if (!below && at_deg <= axis.high_deg + kRounding_deg) continue;
    simulator::Finding finding;
    finding.kind = simulator::FindingKind::beyond_travel;
    finding.line = turn.line;
    finding.point = workpiece_in_setup(job, stage)
                        .point(turn.turn.tool_at(*job.machine.kinematics, 1).shift_mm);
    finding.part = name(simulator::ToolPart::cutter);
    finding.against = std::string(1, axis.word) + (below ? "- (" : "+ (") +
                      model::six_digits(at_deg) + " of " +
                      model::six_digits(below ? axis.low_deg : axis.high_deg) + " degrees)";
    findings.push_back(std::move(finding));
  }
}

}  // namespace

std::vector<simulator::Finding> travel_findings(const ForeignPath& program,
                                                const model::Toolpath& path) {
  std::vector<simulator::Finding> findings;
  std::size_t next = 0;
  for (const model::TravelBreach& breach : program.beyond_travel) {
    // Of the motion's moves the first; a turn that leads to the path has none.
    std::size_t move = next;
    while (move < path.moves.size() && path.moves[move].line != breach.line) ++move;
    const bool found = move < path.moves.size();
    if (found) next = move;
    findings.push_back({simulator::FindingKind::beyond_travel, next, breach.line,
                        found ? path.moves[move].to : path.start, breach.depth_mm,
                        name(simulator::ToolPart::cutter),
                        simulator::travel_limit_name(breach.axis, breach.above)});
  }
  return findings;
}

std::vector<simulator::CarriedBody> carried_bodies(const Job& at_setup, const JobStage& stage,
                                                   std::span<const model::Fixture> bodies) {
  const model::RotaryAngles angles_deg =
      stage.piece ? stage.piece->range.angles_deg : model::RotaryAngles{};
  Pose along = pose_of(machine_in_setup_frame(at_setup));
  along.shift_mm = {};
  std::vector<simulator::CarriedBody> carried;
  for (const JobFixture& fixture : at_setup.fixtures) {
    if (!fixture.mount.with_tool()) continue;
    carried.push_back(
        {bodies[carried.size()], along * body_in_tool(at_setup.machine.kinematics, fixture.mount,
                                                      angles_deg, stage.tool_length_mm.value())});
  }
  return carried;
}

std::vector<simulator::Finding> turn_findings(const Job& at_setup, const JobStage& stage,
                                              const simulator::StockModel& stock,
                                              const simulator::ProcessLimits& limits,
                                              const model::RunControl& control) {
  std::vector<simulator::Finding> findings;
  if (!stage.piece) return findings;
  // These are moves of the stage's own path.
  for (const model::AxisTurn& turn : stage.piece->turning)
    look_at_limits(at_setup, stage, turn, findings);
  if (stage.piece->range.turns.empty()) return findings;
  const simulator::TurnCheck check(stock, stage.cutter, limits);
  for (const model::AxisTurn& turn : stage.piece->range.turns) {
    look_at_limits(at_setup, stage, turn, findings);
    if (turn.parked) continue;
    const TurnPoses poses(at_setup, stage, turn.turn);
    std::vector<simulator::Finding> met =
        check.look_at(turning_tool(at_setup, stage, turn, poses), control);
    std::move(met.begin(), met.end(), std::back_inserter(findings));
  }
  return findings;
}

}  // namespace limitgauge::app
