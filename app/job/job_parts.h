#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/job/job.h"
#include "app/run/stock_file.h"
#include "app/toml/toml_table.h"

namespace limitgauge::app {

/// What the readers of a job's parts share.
struct JobContext {
  std::filesystem::path folder;  ///< of the job file
  std::vector<std::string> defaulted;
  std::vector<JobFile> sources;
  StockReaders stock_readers;
};

/// The table that a job file's text and the overrides make together.
toml::table merged_job(const std::string& text, const std::string& name_in_errors,
                       std::span<const std::string> overrides);
/// The job that such a table states.
Job read_merged_job(const toml::table& table, JobContext context);

/// The tables and keys that a job may have.
inline constexpr const char* kJobKeys[] = {
    "name",       "surface",      "stock",  "machine", "fixture",   "tool",         "stage",
    "simulation", "verification", "report", "post",    "published", "program_frame"};
/// The name, which must do as a folder's.
std::string read_job_name(const TomlTable& root);
/// `transform` of [surface], where it is stated.
void read_placement(const TomlTable& surface, Job& job);
/// [simulation], [verification] and [report], as far as they are stated.
void read_settings(const TomlTable& root, Job& job);
/// The limits of a stage; none where it has no gate.
verifier::GateLimits read_gate(const TomlTable& stage);

/// A stock from a file is read, too; what is to be said of it goes among the defaults.
model::Stock read_stock(const toml::table& stock, JobContext& context);
/// The tools; two of one id or number are an error.
std::vector<JobTool> read_tools(const std::vector<const toml::table*>& tools, JobContext& context);
/// Figures of a publication to stand beside the run's own.
reports::PublishedFigures read_published(const TomlTable& root);
/// The stages in order; two of one name, or a tool that is not among `tools`, are an error.
std::vector<JobStage> read_stages(const std::vector<const toml::table*>& stages,
                                  const std::vector<JobTool>& tools, JobContext& context);

}  // namespace limitgauge::app
