// write_studies FOLDER: what sample studies write, each in its folder: sixty, hostile, failed,
// single and large (10,008 cases), and the schema of study.json.
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "tests/reports/sample_study.h"

using namespace limitgauge::reports;

namespace {

void write_all(const SampleStudy& s, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream csv(folder / "study.csv", std::ios::binary), json(folder / "study.json"),
      page(folder / "study.html");
  study_report::write_study_csv(s.plan, s.table, s.analysis, csv);
  study_report::write_study_json(s.plan, s.table, s.analysis, json, s.about);
  study_report::write_study_html(s.plan, s.table, s.analysis, page, s.about);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::filesystem::path folder(argv[1]);
  write_all(sample_study(), folder / "sixty");
  write_all(hostile_study(), folder / "hostile");
  write_all(failed_study(), folder / "failed");
  write_all(single_study(), folder / "single");
  write_all(sample_study_of(834), folder / "large");
  std::ofstream(folder / "schema.json") << study_report::study_schema();
}
