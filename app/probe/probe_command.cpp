#include <ostream>

#include "app/cli/commands.h"
#include "app/output/checksum.h"
#include "app/output/output_folder.h"
#include "app/output/progress.h"
#include "app/probe/probe_points.h"
#include "app/probe/result_stock.h"
#include "model/base/output_file.h"
#include "model/base/text_file.h"
#include "model/text/clean_text.h"
#include "reports/probe/probe_report.h"

namespace limitgauge::app {
namespace fs = std::filesystem;
namespace probe = reports::probe;
namespace {

fs::path output_of(const ProbeCommand& command) {
  if (!command.output.empty()) return command.output;
  return fs::path("limitgauge-out") / (command.points.stem().string() + "-probe");
}

/// Points of which one text is read and summed: a pipe is read once only.
struct PointsRead {
  model::MeasuredPoints points;
  std::string sha256;
};

PointsRead read_points(const fs::path& file) {
  const std::string text = model::read_text_file(file);
  return {model::parse_measured_points(text, file.string()), sha256_of(text)};
}

probe::ProbeResult measured(const ProbeCommand& command, const CommonOptions& common,
                            const Console& console) {
  ProgressSurroundings around;
  around.columns = console.errors_columns;
  ProgressLine progress(console.errors, console.progress && !common.quiet, std::move(around));
  const ProgressTicker ticker(progress);
  const ProbeWatch watch = {
      {common.threads, console.stop, [&](double fraction) { progress.update(fraction); }},
      [&](const std::string& what) { progress.phase({what}); }};
  watch.phase("reading the result");
  const PointsRead read = read_points(command.points);
  const ResultStock stock = read_result_stock(command, watch.control);
  probe::ProbeResult result = probe_points(stock, read.points, watch);
  result.version = LIMITGAUGE_VERSION;
  result.result = {command.result.string(), stock.sha256};
  result.points_file = {command.points.string(), read.sha256};
  if (command.residual_mm) result.gate = probe::judged(result.points, *command.residual_mm);
  return result;
}

void write_files(const probe::ProbeResult& result, OutputFolder& folder,
                 const model::RunControl& control) {
  const auto put = [&](const char* name, const auto& write) {
    control.check();
    model::write_file(folder.working() / name, [&](std::ostream& out) { write(out); });
  };
  folder.fill([&] {
    put("probe.html", [&](std::ostream& out) { write_probe_html(result, out); });
    put("probe.csv", [&](std::ostream& out) { write_probe_csv(result, control, out); });
    put("probe.json", [&](std::ostream& out) { write_probe_json(result, out); });
  });
}

ExitCode exit_of(const probe::ProbeResult& result) {
  if (!result.gate || result.gate->verdict == verifier::Verdict::pass) return ExitCode::pass;
  return result.gate->verdict == verifier::Verdict::fail ? ExitCode::fail : ExitCode::indeterminate;
}

void print(const probe::ProbeResult& result, const OutputFolder& folder,
           const CommonOptions& common, const Console& console) {
  if (common.json) {
    write_probe_json(result, console.out);
  } else if (!common.quiet) {
    console.out << probe::probe_table(result, console.colour, console.out_columns)
                << "page: " << model::one_line((folder.target() / "probe.html").string()) << '\n';
  }
  console.out << std::flush;
}

}  // namespace

ExitCode execute(const ProbeCommand& command, const CommonOptions& common, const Console& console) {
  const fs::path output = output_of(command);
  require_no_result(output);
  OutputFolder folder(output, common.force);
  const probe::ProbeResult result = measured(command, common, console);
  write_files(result, folder, {common.threads, console.stop});
  print(result, folder, common, console);
  return exit_of(result);
}

}  // namespace limitgauge::app
