#include "app/run/pipeline.h"
#include "app/run/stage_planner.h"
#include "app/run/stage_program.h"
#include "model/base/output_file.h"
#include "reports/run/report.h"

namespace limitgauge::app {

void plan_job(const Job& job, const RunInputs& inputs, const std::filesystem::path& folder,
              const RunOptions& options) {
  StagePlanner planner(job, inputs);
  std::vector<verifier::Pass> passes;
  for (std::size_t i = 0; i < job.stages.size(); ++i) {
    const std::string& name = job.stages[i].name;
    options.watch.phase({name + ": planning", i + 1, job.stages.size()});
    PlannedStage planned =
        planner.plan(i, passes, {options.threads, options.stop, options.watch.progress});
    model::make_folder(folder / name);
    write_program_files(planned, folder / name);
    reports::write_toolpath_vtp(planned.path.path, folder / name / "toolpath.vtp");
    options.watch.note(name + ": " + std::to_string(planned.path.path.moves.size()) + " moves");
    passes.push_back({job.stages[i].cutter,
                      std::make_shared<const model::Toolpath>(std::move(planned.path.path))});
  }
}

}  // namespace limitgauge::app
