#include <cmath>
#include <fstream>
#include <set>
#include <string>

#include "tests/e2e/memory/forecast.h"
#include "tests/e2e/program.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"

namespace limitgauge::e2e {
namespace {

void run_as_forecast(const std::vector<std::string>& command) {
  const Scratch scratch;
  std::vector<std::string> words = command;
  words.insert(words.end(), {"-o", "out", "--verbose"});
  const Outcome outcome = limitgauge(scratch, words);
  INFO(outcome.out << outcome.errors);
  REQUIRE(outcome.exit_code >= 0);
  REQUIRE(outcome.exit_code <= 2);
  check_forecast(outcome);
}

/// Rows of a ball over the dome, a million moves when there is time.
void write_rows(const std::filesystem::path& file) {
  const int kRows = tests::by_effort(200, 1000), kMovesOfRow = 1000;
  std::ofstream out(file);
  out << "G21 G90 G17 G40 G49\nM3 S8000\nG0 Z15\nG0 X-12 Y-12\nG1 Z5 F1500\n";
  const auto place = [](int i, int of) { return -12 + 24.0 * i / (of - 1); };
  char line[64];
  for (int row = 0; row < kRows; ++row)
    for (int k = 0; k < kMovesOfRow; ++k) {
      const double x = place(row, kRows), y = (row % 2 == 0 ? 1 : -1) * place(k, kMovesOfRow);
      const double z = 4.2 - 3 * std::min(1.0, (x * x + y * y) / 144);
      std::snprintf(line, sizeof line, "G1X%.4fY%.4fZ%.4f\n", x, y, z);
      out << line;
    }
  out << "G0 Z15\nM5\nM30\n";
}

std::vector<std::string> verify_rows(const std::filesystem::path& program,
                                     const std::string& tool) {
  return {"verify",
          "--cage",
          fixture("cages/quick-dome.obj"),
          "--stock",
          "box:26,26,9@-13,-13,-4",
          "--tool",
          tool,
          "--program",
          program,
          "--uncut",
          "5",
          "--set",
          "simulation.voxel=0.25"};
}

TEST_CASE("a run takes what it was forecast to take", "[e2e][memory]") {
  for (const char* job : {"jobs/quick-dome", "jobs/rest", "findings/shank-in-stock",
                          "foreign/plate", "torture/crease-ridge"}) {
    INFO(job);
    run_as_forecast({"run", fixture(std::string(job) + ".toml")});
  }
  run_as_forecast({"run", fixture("jobs/quick-dome.toml"), "--no-pictures"});
}

/// Jobs of a folder of fixtures, every `nth` of them in the order of their names, with their
/// pictures.
void run_folder_as_forecast(const char* folder, std::size_t nth) {
  std::set<std::filesystem::path> jobs;
  for (const auto& entry : std::filesystem::directory_iterator(fixture(folder)))
    if (entry.path().extension() == ".toml") jobs.insert(entry.path());
  REQUIRE(!jobs.empty());
  std::size_t k = 0;
  for (const std::filesystem::path& job : jobs)
    if (k++ % nth == nth / 2) {
      INFO(job);
      run_as_forecast({"run", job.string()});
    }
}

// A folder each: all in one would take longer than a test may on a busy machine. The tests of whole
// jobs (aircraft, strategies, torture) look at the forecast as well, so a share will do here.
TEST_CASE("the usual jobs take what they were forecast to take", "[slow][memory]") {
  run_folder_as_forecast("jobs", tests::by_effort(8, 1));
}

TEST_CASE("the jobs of planted findings take what they were forecast to take", "[slow][memory]") {
  run_folder_as_forecast("findings", tests::by_effort(18, 1));
}

TEST_CASE("the jobs of hard shapes take what they were forecast to take", "[slow][memory]") {
  run_folder_as_forecast("torture", tests::by_effort(13, 1));
}

TEST_CASE("long programs take what they were forecast to take", "[slow][memory]") {
  const Scratch programs;
  write_rows(programs / "rows.ngc");
  run_as_forecast(verify_rows(programs / "rows.ngc", "ball:D=6,L=20,shank=6:30"));
  if (!tests::thorough()) return;
  // Shank and holder come near the surface: the verifier follows them as well.
  run_as_forecast(verify_rows(programs / "rows.ngc", "ball:D=6,L=4,shank=6:30,holder=20:30"));
}

TEST_CASE("a run that the process's limit leaves no room for is refused", "[e2e][memory]") {
  const Scratch scratch;
  Conditions conditions;
  conditions.most_memory_bytes = std::size_t{390} << 20;
  const Outcome outcome = limitgauge(
      scratch,
      {"run", fixture("jobs/quick-dome.toml"), "--set", "simulation.voxel=0.01", "-o", "out"},
      conditions);
  INFO(outcome.out << outcome.errors);
  CHECK(outcome.exit_code == 4);
  CHECK_THAT(outcome.errors, ContainsSubstring(" MiB"));
  CHECK_THAT(outcome.errors, ContainsSubstring("would do"));
}

TEST_CASE("whatever address space a run has, it ends with a reason", "[slow][memory]") {
  // With less, libraries end the program before it begins (log4cplus starts a thread).
  for (std::size_t mib = 180; mib <= 600; mib += tests::by_effort(60, 30)) {
    const Scratch scratch;
    Conditions conditions;
    conditions.most_memory_bytes = mib << 20;
    const Outcome outcome = limitgauge(scratch,
                                       coarsely({"run", fixture("jobs/quick-dome.toml"), "--quiet",
                                                 "-o", "out", "--threads", "8"}),
                                       conditions);
    INFO(mib << " MiB: " << outcome.exit_code << " " << outcome.out << outcome.errors);
    CHECK((outcome.exit_code == 0 || outcome.exit_code == 4));
    CHECK((outcome.exit_code == 0 || !outcome.errors.empty()));
  }
}

}  // namespace
}  // namespace limitgauge::e2e
