#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "app/job/job.h"
#include "app/output/checksum.h"
#include "reports/run/run_result.h"

namespace limitgauge::app {

using FileChecksum = std::function<Checksum(const std::filesystem::path& file)>;

/// Every file that the job names and that makes its result: the job file, the cage, the stock,
/// programs, fixtures, the tool table; each once, named as stated. Of a path from the root only the
/// file's name is told: the folders of one machine mean nothing elsewhere. Pipes are left out.
/// Throws InputError for a file that cannot be read.
std::vector<reports::InputFile> input_checksums(const Job& job,
                                                const FileChecksum& sum_of = file_checksum);

}  // namespace limitgauge::app
