#include "app/cli/command_definition.h"
#include "app/cli/option_checks.h"
#include "app/output/byte_size.h"

namespace limitgauge::app {

void CommandDefinition::add_study() {
  StudyCommand& study = parsed_.study;
  CLI::App& sub = *app_.add_subcommand("study", "Tune settings: run a job over a range of keys");
  file(sub.add_option("STUDY", study.study, "Study file (TOML)"), "toml")->required();
  folder(
      sub.add_option("-o,--output", study.output, "Output folder (default: limitgauge-out/NAME)"));
  add_engine(sub, study, "the cases run",
             "local: one a thread, as far as the memory goes; slurm: 100");
  add_cache(sub, study, "results are kept for other studies");
  // Of the processes that this command starts, not for users: stated nowhere.
  sub.add_option("--worker-keeps", study.worker_keeps_bytes)->group("");
  sub.add_option("--worker-memory", study.worker_memory_bytes)->group("");
  add_common(sub);
}

}  // namespace limitgauge::app
