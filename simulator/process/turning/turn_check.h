#pragma once

#include <string>
#include <vector>

#include "model/part/cutter.h"
#include "simulator/process/process_check.h"
#include "simulator/process/turning/turn_meeting.h"

namespace limitgauge::simulator {

/// A motion during which rotary axes turn, and with them the tool among the stock, or the stock and
/// what is mounted with it.
struct TurningTool {
  std::uint32_t line = 0;
  bool rapid = true;
  TurningPose in_stock;                  ///< in the stock's frame
  std::vector<TurningPose> in_fixtures;  ///< one a fixture, in the frame that its mesh is in
  /// Of a body that the spindle or a head carries: its mesh's frame takes the tool's place.
  struct Carried {
    TurningPose in_stock;
    std::vector<TurningPose> in_fixtures;
  };
  std::vector<Carried> carried = {};  ///< one a carried body
};

/// Checks what a tool touches during turns while one stock stands. Stock and fixtures are prepared
/// once. May be asked from several threads at once.
///
/// No part of the tool is to touch anything, the flutes included: what they would cut is not
/// simulated. Of one turn there is one finding a part and thing, the worst:
///
/// - rapid_through_stock, at a feed rate cut_while_turning: the flutes in the stock.
/// - shank_in_stock, holder_in_stock, and fixture_touched for any part. A carried body in the stock
///   is a holder_in_stock, under its own name. The depth, of all of these,
///   is how deep the body's place lies in the stock or the fixture.
/// - slight_contact: a contact shallower than the tolerance but not than a tenth of it, where no
///   part touches that thing more deeply. So a tool that stands where it has just cut, and leaves
///   from there, is no contact.
/// - near_miss: a distance below `near_miss_mm` to a thing that no part touches. A part that is so
///   near to the stock where the turn begins leaves from there: until it is farther away, only what
///   is nearer than there by more than a tolerance counts. So where it arrives at the turn's end.
///   The moves before and after tell of these. Material too thin for a ball of half a tolerance's
///   radius does not count.
///
/// A contact deeper than one and a half tolerances is never missed: where the search is given up
/// (kMostTurnLooks) it is a finding of the failing kind, with depth 0 and placed at the tip. What
/// does not fail may be missed where that takes a tenth of the looks.
class TurnCheck {
 public:
  /// Travel limits are not looked at. Throws std::invalid_argument for limits or a cutter that
  /// cannot be and for a fixture that is no closed solid.
  TurnCheck(const StockModel& stock, const model::Cutter& cutter, const ProcessLimits& limits);

  /// In the order of stock and fixtures, then of parts from the tip up; `move` is 0, points are in
  /// the stock's frame. The same for any number of threads. Throws std::invalid_argument where a
  /// fixture has no pose or a pose breaks its bounds, Interrupted.
  std::vector<Finding> look_at(const TurningTool& motion, const model::RunControl& control) const;

 private:
  struct Obstacle {
    std::string name;
    Material solid;
    bool is_stock = false;
  };
  struct Stretch;

  void require_poses(const TurningTool& motion) const;
  // What moves, by number: the parts of the tool, then what is carried.
  std::size_t movers() const { return parts_.size() + carried_.size(); }
  MovingShape shape(std::size_t mover) const;
  std::size_t part_of(std::size_t mover) const;  // of part_names_
  const TurningPose& pose_in(const TurningTool& motion, std::size_t obstacle,
                             std::size_t mover) const;
  std::vector<Stretch> stretches(const TurningTool& motion) const;
  std::vector<Stretch> near_stretches(const TurningTool& motion, const std::vector<Touch>& touched,
                                      const model::RunControl& control) const;
  void leave_and_arrive(std::vector<Stretch>& all, const Stretch& whole,
                        const model::RunControl& control) const;
  double gap_at(const Stretch& stretch, double t, const model::RunControl& control) const;
  template <class Look>
  std::vector<TurnMeeting> worst_of(const std::vector<Stretch>& stretches, const Look& look,
                                    const model::RunControl& control) const;
  Finding finding(FindingKind kind, const TurningTool& motion, const TurnMeeting& meeting,
                  std::size_t pair) const;
  model::Vec3 place_in_stock(const TurningTool& motion, const TurnPlace& place,
                             std::size_t obstacle) const;
  FindingKind contact_kind(std::size_t pair, bool rapid) const;

  double tolerance_mm_, near_miss_mm_;
  std::vector<ToolBody> parts_;
  std::vector<MeshSolid> carried_;
  std::vector<std::string> part_names_;  // cutter, shank, holder, then what is carried
  std::vector<Obstacle> obstacles_;      // the stock, then the fixtures
};

/// The same for a single turn.
std::vector<Finding> check_turn(const StockModel& stock, const model::Cutter& cutter,
                                const TurningTool& motion, const ProcessLimits& limits,
                                const model::RunControl& control);

}  // namespace limitgauge::simulator
