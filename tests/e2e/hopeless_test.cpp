// What no part was ever made by, and files that are none: said at once, and nothing is written.
#include <sys/stat.h>

#include <chrono>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

const std::string kPlate = "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 9 0\n";

struct Refused {
  std::vector<std::string> arguments;
  std::string error;  ///< part of what is said
};

std::vector<std::string> verify(const std::string& cage, const std::string& stock,
                                std::vector<std::string> more = {}) {
  std::vector<std::string> all = {"verify", "--cage",   cage,        "--stock", stock,
                                  "--tool", "ball:D=6", "--program", "good.ngc"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::vector<std::string> run_with(const std::string& override) {
  return {"run", fixture("jobs/quick-dome.toml"), "--set", override};
}

/// A second on an idle machine; the work that is refused would take minutes or have no end.
constexpr std::chrono::seconds kAtOnce{10};

void check_refused(const Scratch& scratch, const std::vector<Refused>& table) {
  const std::vector<std::string> before = scratch.entries();
  for (const Refused& bad : table) {
    CAPTURE(bad.arguments);
    const auto begin = std::chrono::steady_clock::now();
    const Outcome outcome = limitgauge(scratch, bad.arguments);
    CHECK(std::chrono::steady_clock::now() - begin < kAtOnce);
    CHECK(outcome.exit_code == 3);
    CHECK_THAT(outcome.errors, ContainsSubstring(bad.error) && ContainsSubstring("error: "));
    CHECK(outcome.errors.find("internal error") == std::string::npos);
    CHECK(scratch.entries() == before);
  }
}

void write_inputs(const Scratch& scratch) {
  write_text(scratch / "plate.obj", kPlate + "f 1 2 3 4\n");
  write_text(scratch / "far.obj", "v 1e17 0 0\n" + kPlate + "f 2 3 4 5\n");
  write_text(scratch / "folded.obj", kPlate + "f 1 2 3 4\nf 4 3 2 1\n");
  write_text(scratch / "line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4\n");
  write_text(scratch / "good.ngc", "G21 G90\nG0 X0 Y0 Z10\nG1 X1 F100\nM30\n");
}

TEST_CASE("hopeless jobs are refused at once with key, value and what would do",
          "[e2e][bad_input]") {
  const Scratch scratch;
  write_inputs(scratch);
  const std::string box = "box:12,12,4@-1,-1,-3";
  check_refused(
      scratch,
      {{verify("far.obj", box), "the cage has a vertex at x = 1e+17 mm; expected at most 10000 mm"},
       {{"inspect", "far.obj"}, "the cage has a vertex at x = 1e+17 mm"},
       {verify("line.obj", box), "the limit surface has no area"},
       {{"inspect", "line.obj"}, "the limit surface has no area"},
       {verify("folded.obj", box), "folded.obj:6:1: error: face 2 of the cage lies back on face 1"},
       {{"inspect", "folded.obj"}, "folded.obj:6:1: error: face 2 of the cage lies back on face 1"},
       {verify("plate.obj", "box:1e30,1,1@0,0,0"), "1e+30 mm"},
       {verify("plate.obj", "box:1,1e-9,1@0,0,0"), "stock size is 1e-09 mm"},
       {verify("plate.obj", box, {"--gouge", "1e-9"}), "--gouge: '1e-9' is no length"},
       {verify("plate.obj", box, {"--uncut", "50"}), "--uncut is 50 mm; expected at most 12 mm"},
       {verify("plate.obj", box, {"--set", "simulation.voxel=7"}),
        "\"voxel\" in [simulation] is 7 mm; expected at most 6 mm"},
       {run_with("stage.finish.step=1e-9"), "\"step\" in [[stage]] is 1e-09 mm; expected a length"},
       {run_with("stage.finish.step=500"), "\"step\" in [[stage]] is 500 mm; expected at most"},
       {run_with("verification.resolution=500"), "\"resolution\" in [verification] is 500 mm"},
       {run_with("simulation.voxel=6.5"), "the diameter of the largest cutter"},
       {run_with("stage.finish.step=0x10"), "the value is no decimal number"},
       {run_with("stock.size=[1e9, 26, 9]"), "the stock reaches to x = "}});
}

TEST_CASE("a pipe without a writer, a device and a name without end are no files",
          "[e2e][bad_input]") {
  const Scratch scratch;
  write_inputs(scratch);
  REQUIRE(mkfifo((scratch / "pipe").c_str(), 0600) == 0);
  const std::string box = "box:12,12,4@-1,-1,-3", endless(300, 'a');
  std::vector<Refused> table;
  for (const auto& [file, wrong] :
       {std::pair<std::string, std::string>{"pipe", "pipe: error: nobody writes into this pipe"},
        {"/dev/zero", "/dev/zero: error: this is a device"},
        {endless, "error: the file cannot be reached: File name too long"}}) {
    table.push_back({{"run", file}, wrong});
    table.push_back({{"inspect", file}, wrong});
    table.push_back({{"study", file}, wrong});
    table.push_back({{"compare", file, file}, wrong});
    table.push_back({{"probe", "out", file}, wrong});
    table.push_back({verify(file, box), wrong});
    table.push_back({verify("plate.obj", "mesh:" + file), wrong});
    table.push_back({verify("plate.obj", box, {"--tool-table", file}), wrong});
  }
  table.push_back({verify("plate.obj", "vdb:pipe"), "pipe: error: this is a pipe"});
  table.push_back({{"history", "/dev/zero"}, "/dev/zero: error: this is no plain file"});
  table.push_back({{"inspect", "plate.obj", "--samples", "2", "--csv", "/dev"},
                   "/dev: error: this is a folder"});
  check_refused(scratch, table);
}

TEST_CASE("no control character of a stranger's file reaches the terminal", "[e2e][bad_input]") {
  const Scratch scratch;
  write_inputs(scratch);
  const std::string escape = "\x1b]0;owned\x07\u009b31m\u202e";
  write_text(scratch / "key.toml", "\"" + std::string("a\\u001b[2J\\u202e") + "\" = 1\n");
  write_text(scratch / "word.ngc", "G21 G90\nG0 X1" + escape + "\n");
  write_text(scratch / "comment.ngc", "G21 G90 G54\n(MSG, " + escape + ")\nG0 X0 Y0 Z1\nM30\n");
  write_text(scratch / ("a" + escape + ".obj"), kPlate + "f 1 2 3 9\n");
  const std::vector<std::vector<std::string>> commands = {{"run", "key.toml"},
                                                          {"inspect", "word.ngc"},
                                                          {"inspect", "comment.ngc"},
                                                          {"inspect", "a" + escape + ".obj"},
                                                          {"run", "no" + escape + ".toml"}};
  for (const auto& command : commands) {
    CAPTURE(command);
    const Outcome outcome = limitgauge(scratch, command);
    const std::string said = outcome.out + outcome.errors;
    CHECK(!said.empty());
    for (const char* bad : {"\x1b", "\x07", "\u009b", "\u202e"})
      CHECK(said.find(bad) == std::string::npos);
  }
}

TEST_CASE("a disk that is full while the stock is written leaves no half of it",
          "[e2e][bad_input]") {
  const Scratch scratch;
  Conditions conditions;
  // Less than the stock of the first stage, more than what is written before it.
  conditions.largest_file_bytes = 420 * 1024;
  const Outcome outcome = limitgauge(
      scratch, {"run", fixture("jobs/quick-dome.toml"), "--no-pictures", "-o", "out"}, conditions);
  CHECK(outcome.exit_code == 4);
  CHECK_THAT(outcome.errors,
             ContainsSubstring("rough/stock.vdb: error: cannot write the file: File too large"));
  CHECK(!std::filesystem::exists(scratch / "out"));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch.path()))
    CHECK(entry.path().filename() != "stock.vdb");
}

}  // namespace
}  // namespace limitgauge::e2e
