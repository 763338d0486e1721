#include "tests/e2e/probe/probed_part.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

/// A result and points, both in order, and what is said once something is wrong with them.
class Probed {
 public:
  Probed() {
    cut_part(scratch, "part");
    good_points();
  }
  void good_points() { write_text(scratch / "points.csv", "x,y,z\n20,10,-2.99\n"); }

  /// A copy of the result to spoil.
  fs::path copy(const std::string& name) {
    fs::copy(scratch / "part", scratch / name, fs::copy_options::recursive);
    return scratch / name;
  }
  std::string refusal(const std::string& result, const std::vector<std::string>& more = {}) {
    const Outcome outcome = probe(scratch, result, "out", more);
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.out.empty());
    CHECK_FALSE(fs::exists(scratch / "out"));
    return outcome.errors;
  }
  std::string refused_points(const std::string& table) {
    write_text(scratch / "points.csv", table);
    const std::string said = refusal("part");
    good_points();
    return said;
  }

  Scratch scratch;
};

TEST_CASE("points that are none are refused with their place", "[e2e][probe][bad_input]") {
  Probed at;
  CHECK_THAT(at.refused_points(""), ContainsSubstring("points.csv: error: is empty"));
  CHECK_THAT(at.refused_points("x,y,z,u_mm\n"), ContainsSubstring("has no points"));
  CHECK_THAT(at.refused_points("x,y,z\n1,2,3\n1,nan,3\n"),
             ContainsSubstring("points.csv:3:3: error: y: 'nan' is no number"));
  CHECK_THAT(at.refused_points("x,y\n1,2\n"), ContainsSubstring("points.csv:1:1: error"));
  CHECK_THAT(at.refused_points("x,y,z,u_mm\n1,2,3,0\n"),
             ContainsSubstring("points.csv:2:7: error: u_mm = 0"));
  CHECK_THAT(at.refused_points("x,y,z,u_mm\n1,2,3,\n"), ContainsSubstring("points.csv:2:7"));
  CHECK_THAT(at.refused_points("x,y,z\n1,2,1e9\n"), ContainsSubstring("points.csv:2:5"));
  fs::remove(at.scratch / "points.csv");
  CHECK_THAT(at.refusal("part"), ContainsSubstring("points.csv: error"));
}

TEST_CASE("results without a stock are refused by name", "[e2e][probe][bad_input]") {
  Probed at;
  CHECK_THAT(at.refusal("nowhere"), ContainsSubstring("nowhere: error"));
  fs::create_directory(at.scratch / "empty");
  CHECK_THAT(at.refusal("empty"), ContainsSubstring("empty: error: has no result.json"));
  const std::string whole = read_text(at.scratch / "part/result.json");
  fs::create_directory(at.scratch / "half");
  write_text(at.scratch / "half/result.json", whole.substr(0, whole.size() / 2));
  CHECK_THAT(at.refusal("half"), ContainsSubstring("half/result.json:"));
  // Alone, as a study keeps it.
  write_text(at.scratch / "half/result.json", whole);
  CHECK_THAT(at.refusal("half"),
             ContainsSubstring("half/T1/toolpath.vtp: error: is missing: it has the moves of stage "
                               "'T1'; expected the whole folder that run, verify or cut wrote"));
  fs::remove(at.copy("lost") / "T2/toolpath.vtp");
  CHECK_THAT(at.refusal("lost"), ContainsSubstring("lost/T2/toolpath.vtp: error: is missing"));
  // What comes before it is there.
  CHECK(probe(at.scratch, "lost", "first", {"--stage", "T1"}).exit_code == 0);
  CHECK_THAT(at.refusal("part", {"--stage", "T3"}), ContainsSubstring("has no stage 'T3'"));
  CHECK_THAT(at.refusal("part", {"--stock", "points.csv"}), ContainsSubstring("without --stock"));
}

TEST_CASE("files that are not those of the result are refused", "[e2e][probe][bad_input]") {
  Probed at;
  const fs::path changed = at.copy("changed");
  fs::copy_file(changed / "T2/toolpath.vtp", changed / "T1/toolpath.vtp",
                fs::copy_options::overwrite_existing);
  CHECK_THAT(at.refusal("changed"),
             ContainsSubstring("T1/toolpath.vtp: error: is not as it was written"));
  // Without a manifest nobody knows: but that there is another number of moves.
  fs::remove(changed / "manifest.sha256");
  CHECK_THAT(at.refusal("changed"), ContainsSubstring("moves and result.json says"));
  const fs::path unsealed = at.copy("unsealed");
  fs::remove(unsealed / "manifest.sha256");
  const Outcome outcome = probe(at.scratch, "unsealed", "unsealed-out");
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.out, ContainsSubstring("note: there is no manifest.sha256"));
}

TEST_CASE("a stage that was not run has no stock", "[e2e][probe][bad_input]") {
  Probed at;
  json result = json::parse(read_text(at.scratch / "part/result.json"));
  const fs::path folder = at.copy("failed");
  fs::remove(folder / "manifest.sha256");
  json& stage = result["stages"][1];
  stage.erase("toolpath");
  stage["verdict"] = "not_run";
  write_text(folder / "result.json", result.dump());
  CHECK_THAT(at.refusal("failed", {"--stage", "T2"}),
             ContainsSubstring("stage 'T2' was not run; expected one up to 'T1'"));
  REQUIRE(probe(at.scratch, "failed", "first").exit_code == 0);
  CHECK(probe_json(at.scratch, "first")["stage"] == "T1");
  result["stages"][0].erase("toolpath");
  write_text(folder / "result.json", result.dump());
  CHECK_THAT(at.refusal("failed"), ContainsSubstring("no stage of it was run"));
}

TEST_CASE("the page does not take the place of its result", "[e2e][probe][bad_input]") {
  Probed at;
  const Outcome outcome = probe(at.scratch, "part", "part", {"--force"});
  CHECK(outcome.exit_code == 3);
  CHECK_THAT(outcome.errors, ContainsSubstring("the result's own folder"));
  CHECK(fs::exists(at.scratch / "part/result.json"));
  CHECK(probe(at.scratch, "part", "out").exit_code == 0);
  CHECK(probe(at.scratch, "part", "out").exit_code == 3);
}

TEST_CASE("a raw stock from a file is asked for, and known by its checksum", "[e2e][probe]") {
  const Scratch scratch;
  const std::string block =
      "v 0 0 -20\nv 50 0 -20\nv 50 40 -20\nv 0 40 -20\nv 0 0 0\nv 50 0 0\nv 50 40 0\nv 0 40 0\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  write_text(scratch / "block.obj", block);
  write_text(scratch / "slot.ngc",
             "G21 G90 G17\nM3 S8000\nG0 Z10\nG0 X-8 Y20\nG1 Z-3 F600\nG1 X60\nG0 Z10\nM5\nM30\n");
  REQUIRE(limitgauge(scratch,
                     {"cut", "--stock", "mesh:block.obj", "--tool", "flat:D=6,L=20", "--program",
                      "slot.ngc", "--voxel", "0.5", "--no-pictures", "--quiet", "-o", "slot"})
              .exit_code == 0);
  write_text(scratch / "points.csv", "x,y,z\n25,20,-2.99\n50.005,10,-9\n");
  const Outcome without = probe(scratch, "slot", "out");
  CHECK(without.exit_code == 3);
  CHECK_THAT(without.errors, ContainsSubstring("the file 'block.obj'") &&
                                 ContainsSubstring("expected --stock FILE"));
  REQUIRE(probe(scratch, "slot", "out", {"--stock", "block.obj"}).exit_code == 0);
  for (const json& point : probe_json(scratch, "out")["worst"]) {
    const double truth = point["file_line"] == 2 ? 0.01 : 0.005;
    CHECK(point["residual"]["value_mm"].get<double>() == Approx(truth).margin(1e-9));
  }
  write_text(scratch / "other.obj", block + "# another file\n");
  CHECK_THAT(probe(scratch, "slot", "new", {"--stock", "other.obj"}).errors,
             ContainsSubstring("its checksum is another"));
}

}  // namespace
}  // namespace limitgauge::e2e
