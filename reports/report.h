#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "reports/run_result.h"

namespace limitgauge::reports {

/// result.json, schema `limitgauge.result/1`. The same result gives the same bytes.
void write_result_json(const RunResult& result, std::ostream& out);
/// JUnit: one test case a stage and gate figure.
void write_junit(const RunResult& result, std::ostream& out);
/// One self-contained page that works offline.
void write_html(const RunResult& result, std::ostream& out);
/// The JSON Schema of result.json, as shipped.
const std::string& result_schema();

struct StageFileOptions {
  bool pictures = true;
};
/// Writes NAME/toolpath.vtp, stock.vdb, stock.vtp, deviation.vtp and the pictures of a stage that
/// ran into `folder`/NAME. Needs no display. Throws ResourceError when a file cannot be written.
void write_stage_files(const StageResult& stage, const std::filesystem::path& folder,
                       const StageFileOptions& options);
/// toolpath.vtp alone, for `plan`.
void write_toolpath_vtp(const model::Toolpath& path, const std::filesystem::path& file);
/// The verdict table for the terminal; `colour` adds ANSI colours.
std::string verdict_table(const RunResult& result, bool colour);

}  // namespace limitgauge::reports
