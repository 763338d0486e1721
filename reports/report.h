#pragma once

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>

#include "reports/run_result.h"

namespace limitgauge::reports {

/// The pictures of one stage as PNG bytes; empty where there is nothing to show.
struct StagePictures {
  std::string deviation_png;  ///< error map from +Z with colour bar and worst places, on white
  std::string stock_png;      ///< the cut stock in parallel projection, transparent ground
};
/// Draws the pictures of a stage that ran, in software: needs no display.
StagePictures draw_pictures(const StageResult& stage);

/// result.json, schema `limitgauge.result/1`. The same result gives the same bytes. Throws
/// std::domain_error that names the key of a figure that is not a finite number.
void write_result_json(const RunResult& result, std::ostream& out);
/// JUnit: one test case a stage and gate figure.
void write_junit(const RunResult& result, std::ostream& out);
/// One self-contained page that works offline. Draws the pictures of every stage.
void write_html(const RunResult& result, std::ostream& out);
/// The same with pictures drawn before, one entry a stage; none at all for a page without pictures.
void write_html(const RunResult& result, std::span<const StagePictures> pictures,
                std::ostream& out);
/// The JSON Schema of result.json, as shipped.
const std::string& result_schema();

struct StageFileOptions {
  bool pictures = true;
};
/// Writes NAME/toolpath.vtp, stock.vdb, stock.vtp, deviation.vtp and the pictures deviation.png and
/// stock.png of a stage that ran into `folder`/NAME. Needs no display. Gives the pictures, for
/// write_html. Throws ResourceError when a file cannot be written, std::invalid_argument for a name
/// that is no plain folder name.
StagePictures write_stage_files(const StageResult& stage, const std::filesystem::path& folder,
                                const StageFileOptions& options);
/// toolpath.vtp alone, for `plan`.
void write_toolpath_vtp(const model::Toolpath& path, const std::filesystem::path& file);
/// The verdict table for the terminal, at most 100 columns; `colour` adds ANSI colours.
std::string verdict_table(const RunResult& result, bool colour);

}  // namespace limitgauge::reports
