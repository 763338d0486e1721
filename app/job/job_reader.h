#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/job/job.h"

namespace limitgauge::app {

/// Reads a job file (TOML, see the README) after replacing single keys by `overrides`, each
/// `dotted.key=value`; a stage or tool is named in the path by its name or id, as in
/// `stage.finish.step=0.2`. What is stated there counts as if it stood in the file. Everything is
/// checked before it returns: InputError names file, line and column, or the override.
Job read_job(const std::filesystem::path& file, std::span<const std::string> overrides = {});

/// The same for a text; relative paths in it are taken against `folder`.
Job read_job_text(const std::string& text, const std::string& name_in_errors,
                  const std::filesystem::path& folder, std::span<const std::string> overrides = {});

/// True where `name` can be a file name everywhere: letters, digits, '.', '_' and '-', starting
/// with none of '.' and '-', at most 100 characters.
bool is_plain_name(std::string_view name);

}  // namespace limitgauge::app
