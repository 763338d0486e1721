// write_probes FOLDER: pages of measured points for browsers and readers, each in a folder of its
// name as report.html with its CSV and JSON: two-hundred, many (900), one, floor, slanted, failed
// and hostile (markup in every text); schema.json beside them.
#include <filesystem>
#include <fstream>

#include "reports/probe/probe_report.h"
#include "tests/reports/sample_probe.h"

using namespace limitgauge::reports;

namespace {

void write(const std::filesystem::path& folder, const probe::ProbeResult& result) {
  std::filesystem::create_directories(folder);
  std::ofstream page(folder / "report.html"), json(folder / "result.json"),
      csv(folder / "probe.csv");
  write_probe_html(result, page);
  write_probe_json(result, json);
  write_probe_csv(result, {1}, csv);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder(argv[1]);
  write(folder / "two-hundred", sample_probe(200));
  write(folder / "many", sample_probe(900));
  write(folder / "one", sample_probe(1));
  write(folder / "floor", floor_probe(20));
  write(folder / "slanted", slanted_probe(20));
  write(folder / "hostile", hostile_probe());
  probe::ProbeResult failed = sample_probe(60);
  failed.gate = probe::judged(failed.points, 0.003);
  write(folder / "failed", failed);
  std::ofstream(folder / "schema.json") << probe::probe_schema();
}
