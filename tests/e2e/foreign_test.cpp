#include <nlohmann/json.hpp>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

std::string plate_program() {
  return read_text(fixture("foreign/plate.ngc"));
}

/// `text` with its one occurrence of `from` replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  REQUIRE(text.find(from, at + 1) == std::string::npos);
  return text.replace(at, from.size(), to);
}

/// The number of the line on which `part` stands.
int line_of(const std::string& text, const std::string& part) {
  const std::size_t at = text.find(part);
  REQUIRE(at != std::string::npos);
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
}

/// The plate job with another program.
struct Bench {
  explicit Bench(const std::string& program) {
    write_text(scratch / "plate.ngc", program);
    fs::copy_file(fixture("foreign/plate.obj"), scratch / "plate.obj");
    fs::copy_file(fixture("foreign/plate.toml"), scratch / "plate.toml");
    outcome = limitgauge(scratch, {"run", "plate.toml", "-o", "out", "--no-pictures"});
    INFO(outcome.errors);
    REQUIRE(fs::exists(scratch / "out/result.json"));
    result = json::parse(read_text(scratch / "out/result.json"));
  }
  const json& stage(const std::string& name) const {
    for (const json& stage : result["stages"])
      if (stage["name"] == name) return stage;
    throw std::runtime_error("no stage " + name);
  }

  Scratch scratch;
  Outcome outcome;
  json result;
};

double low(const json& stage, const char* figure) {
  return stage["deviation"][figure]["low"].get<double>();
}
double high(const json& stage, const char* figure) {
  return stage["deviation"][figure]["high"].get<double>();
}

/// Whether a gouge or a leftover, or a pass beside one, is on one of the lines.
bool names_line(const json& findings, int first, int last) {
  const auto within = [&](const json& line) { return line >= first && line <= last; };
  for (const json& finding : findings) {
    if (within(finding["line"])) return true;
    if (!finding.contains("passes")) continue;
    for (const json& pass : finding["passes"])
      if (within(pass["line"])) return true;
  }
  return false;
}

bool assumes(const json& result, const std::string& text) {
  for (const json& said : result["assumptions"])
    if (said.get<std::string>().find(text) != std::string::npos) return true;
  return false;
}

}  // namespace

TEST_CASE("a stranger's program of two tools passes stage by stage", "[e2e][foreign]") {
  const Bench bench(plate_program());
  REQUIRE(bench.outcome.exit_code == 0);
  const json& rough = bench.stage("rough");
  const json& finish = bench.stage("finish");
  CHECK(rough["program_part"] == "T1");
  CHECK(finish["cutter"]["diameter_mm"] == 6);
  // A plane cut by a flat cutter: exact, but for the certificate's width of 1 µm.
  for (const json* stage : {&rough, &finish}) {
    CHECK(high(*stage, "gouge_mm") < 0.002);
    CHECK(high(*stage, "uncut_mm") < 0.002);
    CHECK((*stage)["simulation"]["findings"].empty());
  }
  CHECK(bench.result["programs"]["tools"][1]["length_mm"] == 65.5);
  CHECK(assumes(bench.result, "G28"));
}

TEST_CASE("verify takes the same program with a tool for each number", "[e2e][foreign]") {
  const Scratch scratch;
  write_text(scratch / "tools.tbl", "T1 P1 Z80 D8\nT2 P2 Z65.5 D6\n");
  const Outcome outcome = limitgauge(scratch, {"verify",
                                               "--cage",
                                               fixture("foreign/plate.obj"),
                                               "--stock",
                                               "box:44,44,6@-22,-22,-5",
                                               "--tool",
                                               "1=flat:D=8,L=20",
                                               "--tool",
                                               "2=flat:D=6,L=18",
                                               "--tool-table",
                                               "tools.tbl",
                                               "--program",
                                               fixture("foreign/plate.ngc"),
                                               "--gouge",
                                               "0.01",
                                               "--uncut",
                                               "0.01",
                                               "-o",
                                               "out",
                                               "--no-pictures"});
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const json stages = json::parse(read_text(scratch / "out/result.json"))["stages"];
  REQUIRE(stages.size() == 2);
  CHECK(stages[0]["name"] == "T1");
  CHECK(stages[1]["name"] == "T2");
  // What the first tool left for the second: 0.3 mm along the normals.
  CHECK(low(stages[0], "uncut_mm") == Approx(0.3).margin(0.002));
  CHECK(high(stages[1], "uncut_mm") < 0.002);
  const Outcome one =
      limitgauge(scratch, {"verify", "--cage", fixture("foreign/plate.obj"), "--stock",
                           "box:44,44,6@-22,-22,-5", "--tool", "flat:D=8,L=20", "--program",
                           fixture("foreign/plate.ngc"), "-o", "one"});
  CHECK(one.exit_code == 3);
  CHECK_THAT(one.errors, ContainsSubstring(
                             "plate.ngc:" + std::to_string(line_of(plate_program(), "N130 T2 M6")) +
                             ": error: T2 is loaded"));
}

TEST_CASE("CL data and G-code of the same motions have the same verdict", "[e2e][foreign]") {
  const Scratch scratch;
  write_text(scratch / "down.cls", "RAPID\nGOTO/0,0,-3\nRAPID\nGOTO/0,0,20\nFINI\n");
  write_text(scratch / "down.ngc", "G0 X0 Y0\nG0 Z-3\nG0 Z20\nM2\n");
  for (const std::string start : {"0,0,20", "5,5,30", ""}) {
    for (const std::string program : {"down.cls", "down.ngc"}) {
      CAPTURE(program, start);
      std::vector<std::string> words = {"verify",
                                        "--cage",
                                        fixture("foreign/plate.obj"),
                                        "--stock",
                                        "box:44,44,6@-22,-22,-5",
                                        "--tool",
                                        "flat:D=8,L=20",
                                        "--program",
                                        program,
                                        "-o",
                                        "out" + start + program,
                                        "--set",
                                        "verification.resolution=0.02",
                                        "--no-pictures"};
      if (!start.empty()) words.push_back("--start=" + start);
      const Outcome outcome = limitgauge(scratch, words);
      CHECK(outcome.exit_code == 1);
      CHECK_THAT(outcome.out + outcome.errors,
                 ContainsSubstring("rapid through standing material"));
    }
  }
}

TEST_CASE("a slot cut before Y was named fails as with Y named", "[e2e][foreign]") {
  // A finished plate with a slot 3 mm deep across its middle.
  const Scratch scratch;
  const std::string face =
      "o100 repeat [7]\nG0 X-26 Z9\nG1 Z0 F400\nG1 X26 F1000\nG0 Z9\nG91\nG0 Y6.5\nG90\no100 "
      "endrepeat\n";
  const std::string slot = "G0 X-26\nG0 Z9\nG1 Z-3 F400\nG1 X26 F1000\nG0 Z9\n";
  write_text(scratch / "unnamed.ngc", slot + "G0 Y-19.5\n" + face);
  write_text(scratch / "named.ngc", "G0 Y0\n" + slot + "G0 Y-19.5\n" + face);
  const auto verify = [&](const std::string& program, std::vector<std::string> more) {
    std::vector<std::string> arguments = {"verify",
                                          "--cage",
                                          fixture("foreign/plate.obj"),
                                          "--stock",
                                          "box:44,44,6@-22,-22,-5",
                                          "--tool",
                                          "flat:D=8,L=20",
                                          "--program",
                                          program,
                                          "--gouge",
                                          "0.5",
                                          "--no-pictures"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return limitgauge(scratch, arguments);
  };
  const Outcome unnamed = verify("unnamed.ngc", {"-o", "unnamed"});
  CHECK(unnamed.exit_code == 1);
  CHECK(verify("named.ngc", {"-o", "named"}).exit_code == 1);
  const json first = json::parse(read_text(scratch / "unnamed/result.json"));
  const json second = json::parse(read_text(scratch / "named/result.json"));
  CHECK(first["stages"][0]["deviation"]["gouge_mm"] ==
        second["stages"][0]["deviation"]["gouge_mm"]);
  CHECK(first["stages"][0]["deviation"]["uncut_mm"] ==
        second["stages"][0]["deviation"]["uncut_mm"]);
  CHECK(low(first["stages"][0], "gouge_mm") > 2.9);
  CHECK(first["programs"]["start_mm"] == json({0.0, 0.0, 14.0}));
  CHECK(first["programs"]["start_assumed"] == true);
  CHECK(assumes(first, "programs start with the tip at (0, 0, 14) mm of their frame"));
  CHECK(assumes(first, "line 3: cuts before X, Y and Z have all been named"));
  CHECK(!assumes(second, "cuts before X, Y and Z"));
  // Stated beside the plate, the same slot cuts nothing that matters.
  const Outcome stated = verify("unnamed.ngc", {"-o", "stated", "--start", "0,60,20"});
  INFO(stated.errors);
  CHECK(stated.exit_code == 0);
  const json third = json::parse(read_text(scratch / "stated/result.json"));
  CHECK(third["programs"]["start_mm"] == json({0.0, 60.0, 20.0}));
  CHECK(third["programs"]["start_assumed"] == false);
  CHECK(!assumes(third, "programs start with"));
}

TEST_CASE("a program that lies elsewhere is laid over the cage", "[e2e][foreign]") {
  // The program in the frame of a pallet: its zero at (100, 50, 20), turned by a quarter.
  const Scratch scratch;
  const std::string job = with(read_text(fixture("foreign/plate.toml")), "[stock]",
                               "[program_frame]\noffset = [0, 0, 0]\nrotate_z = 90\n"
                               "[machine]\nwork_offsets = { G54 = [100, 50, 20] }\n"
                               "home = [0, 0, 300]\n[stock]");
  write_text(scratch / "plate.toml", job);
  fs::copy_file(fixture("foreign/plate.obj"), scratch / "plate.obj");
  fs::copy_file(fixture("foreign/plate.ngc"), scratch / "plate.ngc");
  const Outcome outcome = limitgauge(scratch, {"run", "plate.toml", "-o", "out", "--no-pictures"});
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const json result = json::parse(read_text(scratch / "out/result.json"));
  CHECK(result["programs"]["rotate_z_deg"] == 90);
  CHECK(result["programs"]["home_mm"][2] == 300);
  for (const json& stage : result["stages"]) {
    CHECK(high(stage, "gouge_mm") < 0.002);
    CHECK(high(stage, "uncut_mm") < 0.002);
  }
}

TEST_CASE("two stages may each take the whole of a program", "[e2e][foreign]") {
  const Scratch scratch;
  std::string job = read_text(fixture("findings/below-flutes-clean.toml"));
  const std::size_t stage = job.find("[[stage]]"), after = job.find("[simulation]");
  const std::string again = with(job.substr(stage, after - stage), "\"channel\"", "\"again\"");
  write_text(scratch / "job.toml", job.insert(after, again));
  fs::copy_file(fixture("findings/plate.obj"), scratch / "plate.obj");
  fs::copy_file(fixture("findings/two-levels.ngc"), scratch / "two-levels.ngc");
  const Outcome outcome = limitgauge(scratch, {"run", "job.toml", "-o", "out", "--no-pictures"});
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const json stages = json::parse(read_text(scratch / "out/result.json"))["stages"];
  REQUIRE(stages.size() == 2);
  CHECK(stages[0]["toolpath"]["moves"] == stages[1]["toolpath"]["moves"]);
}

TEST_CASE("one digit changed is found on its line", "[e2e][foreign]") {
  const std::string program = with(plate_program(), "N165 G1 Z0.", "N165 G1 Z-0.5");
  const Bench bench(program);
  CHECK(bench.outcome.exit_code == 1);
  const json& finish = bench.stage("finish");
  CHECK(low(finish, "gouge_mm") == Approx(0.5).margin(0.001));
  const int line = finish["deviation"]["gouges"][0]["line"];
  CHECK(line >= line_of(program, "N165"));
  CHECK(line <= line_of(program, "N230"));
  bool shown = false;
  for (const json& text : finish["program_lines"]) shown |= text["line"] == line;
  CHECK(shown);
  CHECK_THAT(read_text(bench.scratch / "out/report.html"), ContainsSubstring("N165 G1 Z-0.5"));
  // The same in the file that editors and code scanning read.
  const json run = json::parse(read_text(bench.scratch / "out/findings.sarif"))["runs"][0];
  CHECK(run["artifacts"].size() == 1);
  const json& first = run["results"][0];
  CHECK(first["ruleId"] == "gouge");
  CHECK(first["level"] == "error");
  const json& place = first["locations"][0]["physicalLocation"];
  CHECK(place["artifactLocation"]["uri"] == "plate.ngc");
  CHECK(place["artifactLocation"]["uriBaseId"] == "JOB");
  CHECK(place["region"]["startLine"] == line);
  CHECK(line_of(program, place["region"]["snippet"]["text"]) == line);
}

TEST_CASE("a line lost leaves material beside the lines that remain", "[e2e][foreign]") {
  const std::string program = with(plate_program(), "N200 X-14.\n", "");
  const Bench bench(program);
  CHECK(bench.outcome.exit_code == 1);
  const json& finish = bench.stage("finish");
  CHECK(low(finish, "uncut_mm") == Approx(0.3).margin(0.001));
  // The same 0.3 mm stand all over the gap: what bounds its deepest place may be any row around it.
  CHECK(names_line(finish["deviation"]["uncuts"], line_of(program, "N190"),
                   line_of(program, "N280")));
}

TEST_CASE("inches for millimetres are found and named", "[e2e][foreign]") {
  const std::string program = with(plate_program(), "N140 G54\nN145 M8", "N140 G54\nN145 G20 M8");
  const Bench bench(program);
  CHECK(bench.outcome.exit_code == 1);
  CHECK(low(bench.stage("finish"), "uncut_mm") > 0.29);
  CHECK(assumes(bench.result, "line " + std::to_string(line_of(program, "N145 G20"))));
}

TEST_CASE("a wrong length offset is found and named", "[e2e][foreign]") {
  // The longer tool with the shorter one's offset: 14.5 mm too deep.
  const std::string deep = with(plate_program(), "Z15. H1", "Z15. H2");
  const Bench crash(deep);
  CHECK(crash.outcome.exit_code == 1);
  CHECK(low(crash.stage("rough"), "gouge_mm") > 4);
  CHECK(assumes(crash.result, "line " + std::to_string(line_of(deep, "Z15. H2"))));
  // The shorter tool with the longer one's: it cuts air, and all of the 0.3 mm stays.
  const std::string high_up = with(plate_program(), "G43 Z15. H2", "G43 Z15. H1");
  const Bench air(high_up);
  CHECK(air.outcome.exit_code == 1);
  CHECK(low(air.stage("finish"), "uncut_mm") == Approx(0.3).margin(0.002));
  CHECK(assumes(air.result, "line " + std::to_string(line_of(high_up, "N155 G43"))));
}

TEST_CASE("compensation on the wrong side is found on its lines", "[e2e][foreign]") {
  const std::string program = with(plate_program(), "G41 D2", "G42 D2");
  const Bench bench(program);
  CHECK(bench.outcome.exit_code == 1);
  const json& finish = bench.stage("finish");
  CHECK(low(finish, "uncut_mm") == Approx(0.3).margin(0.001));
  CHECK(names_line(finish["deviation"]["uncuts"], line_of(program, "N250"),
                   line_of(program, "N280")));
}

}  // namespace limitgauge::e2e
