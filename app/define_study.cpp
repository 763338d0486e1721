#include "app/command_definition.h"

namespace limitgauge::app {

void CommandDefinition::add_study() {
  StudyCommand& study = parsed_.study;
  CLI::App& sub = *app_.add_subcommand("study", "Tune settings: run a job over a range of keys");
  file(sub.add_option("STUDY", study.study, "Study file (TOML)"), "toml")->required();
  folder(
      sub.add_option("-o,--output", study.output, "Output folder (default: limitgauge-out/NAME)"));
  hint(sub.add_option("--engine", study.engine, "Where the cases run (default: local)"),
       "local|slurm", {ValueHint::Kind::text, {}, {"local", "slurm"}})
      ->check(CLI::IsMember({"local", "slurm"}).description(""));
  add_common(sub);
}

}  // namespace limitgauge::app
