#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <span>
#include <string>

#include "model/base/run_control.h"
#include "reports/run/run_result.h"
#include "reports/vtk/stage_facts.h"

namespace limitgauge::reports {

/// Draws the pictures of a stage that ran, in software: needs no display.
StagePictures draw_pictures(const StageResult& stage, const model::RunControl& control = {});

/// result.json, schema `limitgauge.result/2`. The same result gives the same bytes. Throws
/// std::domain_error that names the key of a figure that is not a finite number.
void write_result_json(const RunResult& result, std::ostream& out);
/// JUnit: one test case a stage and gate figure.
void write_junit(const RunResult& result, std::ostream& out);
/// findings.sarif, SARIF 2.1.0: a result a finding that is not proven inside its limit, and for a
/// verdict that no finding explains. Holds no time and no number of threads.
void write_sarif(const RunResult& result, std::ostream& out);
/// findings.csv, RFC 4180: a row a finding, all of them. Text that a spreadsheet would take for a
/// formula has an apostrophe before it.
void write_findings_csv(const RunResult& result, std::ostream& out);
/// One self-contained page that works offline, with the pictures that the stages hold.
/// The same bytes for any number of threads.
void write_html(const RunResult& result, std::ostream& out, unsigned threads = 1);
/// The JSON Schema of result.json, as shipped.
const std::string& result_schema();

/// What stock.vtp holds: what cutters made of the stock's surface, all of it, or no such file.
enum class StockSurfaceFile { cut, whole, none };

struct StageFileOptions {
  bool pictures = true;
  model::RunControl control = {};
  double rapid_mm_min = 0;  ///< of the machine, for times along the path
  StockSurfaceFile stock = StockSurfaceFile::cut;
  std::span<const model::Pass> passes = {};  ///< all that cut the stock, this stage's last
  bool design = false;  ///< the page shows a design, and no stock of stages that are not measured
};
/// What writing a stage's files gives to its result.
struct StageFiles {
  StagePictures pictures;                      ///< for StageResult::pictures
  std::optional<StockSurfaceFigures> surface;  ///< for StageRun::surface
  std::optional<page::PathView> path_view;     ///< for StageRun::path_view
  std::optional<page::StockView> stock_view;   ///< for StageRun::stock_view
};
/// Writes NAME/toolpath.vtp, stock.vdb, stock.vtp, deviation.vtp and the pictures deviation.png,
/// perspective.png and stock.png of a stage that ran into `folder`/NAME. Needs no display. Throws
/// ResourceError when a file cannot be written, Interrupted, std::invalid_argument for a name that
/// is no plain folder name.
StageFiles write_stage_files(const StageResult& stage, const std::filesystem::path& folder,
                             const StageFileOptions& options);
/// toolpath.vtp alone: a line a move with its program line, feed, kind and index, and what it
/// removed where `removal` has an entry for every move: the active scalars, or else the feed.
/// `facts` become field data, and `axes`, of a path that turns its tool, data of its places: unit
/// vectors from the tip to the spindle.
void write_toolpath_vtp(const model::Toolpath& path, const std::filesystem::path& file,
                        std::span<const simulator::MoveRemoval> removal = {},
                        std::span<const Fact> facts = {}, const model::ToolAxes* axes = nullptr);
/// stages.vtm in `folder`: a block a stage, by its name, that names those of deviation.vtp,
/// stock.vtp and toolpath.vtp that are there. Writes nothing where no stage has any. Throws
/// ResourceError when the file cannot be written.
void write_stages_vtm(const RunResult& result, const std::filesystem::path& folder);
/// The verdict table for a terminal of `width` columns, 80 or more; `colour` adds ANSI colours.
std::string verdict_table(const RunResult& result, bool colour, std::size_t width = 100);

/// A stage that ran as result.json has it, for StageResult::recorded of another run that begins
/// with the same stages.
std::string recorded_stage(const RunResult& result, std::size_t index);
/// Whether `text` can be one.
bool is_recorded_stage(const std::string& text);

}  // namespace limitgauge::reports
