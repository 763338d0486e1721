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
  add_study_engine(sub);
  folder(sub.add_option("--cache", study.cache,
                        "Where results are kept for other studies (default: the user's cache; "
                        "slurm: a shared folder)"));
  hint(sub.add_option_function<std::string>(
              "--cache-limit",
              [&study](const std::string& text) {
                study.cache_limit_bytes = bytes_of_text(text).value();
              },
              "Most that is kept there, as 500M (default: 4G)")
           ->check(CLI::Validator(
               [](const std::string& text) {
                 return bytes_of_text(text) ? std::string() : "is no size, as 500M or 4G are";
               },
               "")),
       "SIZE");
  add_common(sub);
}

void CommandDefinition::add_study_engine(CLI::App& sub) {
  StudyCommand& study = parsed_.study;
  hint(sub.add_option("--engine", study.engine, "Where the cases run (default: local)"),
       "local|slurm", {ValueHint::Kind::text, {}, {"local", "slurm"}})
      ->check(CLI::IsMember({"local", "slurm"}).description(""));
  hint(sub.add_option("--jobs", study.jobs,
                      "Cases at a time (default: local: one a thread, as far as the memory goes; "
                      "slurm: 100)"),
       "N")
      ->check(whole_number(1, 100000));
  hint(sub.add_option("--retries", study.retries,
                      "How often a case is tried again that was lost (default: 2)"),
       "N")
      ->check(whole_number(0, 100));
  hint(sub.add_option("--slurm-option", study.slurm_options,
                      "Option for sbatch, as --slurm-option=--partition=long"),
       "OPTION")
      ->allow_extra_args(false);
  hint(sub.add_option("--slurm-patience", study.slurm_patience_min,
                      "How long a task of Slurm may not come back from its node (default: 8)"),
       "MINUTES")
      ->check(number_above_zero(false));
  // Of the processes that this command starts, not for users: stated nowhere.
  sub.add_option("--worker", study.worker)->group("");
  sub.add_option("--worker-keeps", study.worker_keeps_bytes)->group("");
  sub.add_option("--worker-memory", study.worker_memory_bytes)->group("");
}

}  // namespace limitgauge::app
