#pragma once

#include <span>
#include <vector>

#include "app/job/foreign_programs.h"
#include "app/job/job.h"
#include "model/base/run_control.h"
#include "simulator/process/process_check.h"

namespace limitgauge::app {

/// What the turns of rotary axes that lead to a stage run into, on the stock as it stands before
/// it: collisions of the tool (simulator::check_turn), and axes beyond their limits
/// (beyond_travel). `at_setup` is the view of the job in the stage's setup, `limits` are those of
/// the stage's process there. Of a stage that cuts while its axes turn, the turns are moves of its
/// path, and are held against the axes' limits alone here. A turn while Z stands above everything
/// touches nothing, which its program's assumptions say.
std::vector<simulator::Finding> turn_findings(const Job& at_setup, const JobStage& stage,
                                              const simulator::StockModel& stock,
                                              const simulator::ProcessLimits& limits,
                                              const model::RunControl& control);

/// Of a stage that is a stretch of its program, whose path is `path`: the motions that take the
/// machine's X, Y or Z beyond the job's travel (beyond_travel), in the order of its moves.
std::vector<simulator::Finding> travel_findings(const ForeignPath& program,
                                                const model::Toolpath& path);

/// The job's bodies that go with the tool (`bodies`, in the job's order) as they stand in the
/// view's setup during the moves of a stage.
std::vector<simulator::CarriedBody> carried_bodies(const Job& at_setup, const JobStage& stage,
                                                   std::span<const model::Fixture> bodies);

}  // namespace limitgauge::app
