#include "app/inputs/input_checksums.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "model/gcode/program.h"

namespace limitgauge::app {
namespace {

/// All that the job names, in the order of the report; a program stands once however many stages
/// take a part of it.
std::vector<JobFile> files_of(const Job& job) {
  std::vector<JobFile> files;
  const auto add = [&](const JobFile& file) {
    const auto same = [&](const JobFile& known) {
      return known.role == file.role && known.path == file.path;
    };
    if (std::none_of(files.begin(), files.end(), same)) files.push_back(file);
  };
  const auto add_sources = [&](JobFile::Role role) {
    for (const JobFile& file : job.sources)
      if (file.role == role) add(file);
  };
  add_sources(JobFile::Role::job);
  if (const auto& design = job.design)
    add({design->kind == DesignKind::mesh ? JobFile::Role::mesh : JobFile::Role::cage, design->file,
         design->as_stated});
  add_sources(JobFile::Role::stock);
  for (const JobStage& stage : job.stages)
    if (!stage.plan) add({JobFile::Role::program, stage.program, stage.program_as_stated});
  for (const std::filesystem::path& file : model::subprogram_files(job.machine.subprograms))
    add({JobFile::Role::program, file, file.filename().string()});
  for (const JobFixture& fixture : job.fixtures)
    add({JobFile::Role::fixture, fixture.file, fixture.file_as_stated});
  add_sources(JobFile::Role::tool_table);
  return files;
}

const char* name(JobFile::Role role) {
  switch (role) {
    case JobFile::Role::job:
      return "job";
    case JobFile::Role::cage:
      return "cage";
    case JobFile::Role::mesh:
      return "mesh";
    case JobFile::Role::stock:
      return "stock";
    case JobFile::Role::program:
      return "program";
    case JobFile::Role::fixture:
      return "fixture";
    case JobFile::Role::tool_table:
      break;
  }
  return "tool table";
}

std::string shown_name(const std::string& as_stated) {
  const std::filesystem::path path(as_stated);
  return path.is_absolute() ? path.filename().string() : as_stated;
}

}  // namespace

std::vector<reports::InputFile> input_checksums(const Job& job, const FileChecksum& sum_of) {
  std::vector<reports::InputFile> inputs;
  for (const JobFile& file : files_of(job)) {
    // What came through a pipe is gone: no sum is better than that of nothing.
    std::error_code error;
    if (exists(file.path, error) && !is_regular_file(file.path, error)) continue;
    Checksum sum = sum_of(file.path);
    inputs.push_back(
        {name(file.role), shown_name(file.as_stated), sum.bytes, std::move(sum.sha256)});
  }
  return inputs;
}

}  // namespace limitgauge::app
