#include "app/cli/command_definition.h"
#include "app/cli/option_checks.h"
#include "app/output/byte_size.h"

namespace limitgauge::app {

void CommandDefinition::add_engine(CLI::App& sub, EngineOptions& engine, const std::string& what,
                                   const std::string& alone) {
  hint(sub.add_option("--engine", engine.engine, "Where " + what + " (default: local)"),
       "local|slurm", {ValueHint::Kind::text, {}, {"local", "slurm"}})
      ->check(CLI::IsMember({"local", "slurm"}).description(""));
  hint(sub.add_option("--jobs", engine.jobs, "So many at a time (default: " + alone + ")"), "N")
      ->check(whole_number(1, 100000));
  hint(sub.add_option("--retries", engine.retries,
                      "How often what was lost is tried again (default: 2)"),
       "N")
      ->check(whole_number(0, 100));
  hint(sub.add_option("--slurm-option", engine.slurm_options,
                      "Option for sbatch, as --slurm-option=--partition=long"),
       "OPTION")
      ->allow_extra_args(false);
  hint(sub.add_option("--slurm-patience", engine.slurm_patience_min,
                      "How long a task of Slurm may not come back from its node (default: 8)"),
       "MINUTES")
      ->check(number_above_zero(false));
  // Of the processes that this command starts, not for users: stated nowhere.
  sub.add_option("--worker", engine.worker)->group("");
}

void CommandDefinition::add_cache(CLI::App& sub, EngineOptions& engine, const std::string& what) {
  folder(sub.add_option("--cache", engine.cache,
                        "Where " + what + " (default: the user's cache; slurm: a shared folder)"));
  hint(sub.add_option_function<std::string>(
              "--cache-limit",
              [&engine](const std::string& text) {
                engine.cache_limit_bytes = bytes_of_text(text).value();
              },
              "Most that is kept there, as 500M (default: 4G)")
           ->check(CLI::Validator(
               [](const std::string& text) {
                 return bytes_of_text(text) ? std::string() : "is no size, as 500M or 4G are";
               },
               "")),
       "SIZE");
}

}  // namespace limitgauge::app
