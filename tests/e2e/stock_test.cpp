#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "tests/e2e/program.h"
#include "tests/support/catch.h"
#include "tests/support/mesh_shapes.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

/// ASCII STL.
std::string stl(const model::TriangleMesh& mesh) {
  std::string text = "solid stock\n";
  for (const auto& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t v : t) {
      const model::Vec3& p = mesh.vertices[v];
      text += "vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " +
              std::to_string(p.z) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid\n";
}

/// `text` with what stands between `from` and the next `to` replaced.
std::string between(std::string text, const std::string& from, const std::string& to,
                    const std::string& by) {
  const std::size_t begin = text.find(from), end = text.find(to, begin);
  REQUIRE(begin != std::string::npos);
  REQUIRE(end != std::string::npos);
  return text.replace(begin, end - begin, by);
}

/// The quick job with another stock, from anywhere.
std::string quick_job(const std::string& stock) {
  std::string job = read_text(fixture("jobs/quick-dome.toml"));
  job = between(job, "cage = ", "\n", "cage = \"" + fixture("cages/quick-dome.obj") + "\"");
  return between(job, "[stock]", "[machine]", "[stock]\n" + stock + "\n");
}

json run_as(const Scratch& scratch, const std::string& job, const std::string& name) {
  write_text(scratch / (name + ".toml"), job);
  const Outcome outcome = limitgauge(scratch, {"run", name + ".toml", "-o", name, "--no-pictures"});
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  return json::parse(read_text(scratch / (name + "/result.json")));
}

void check_same_figures(const json& a, const json& b) {
  REQUIRE(a["stages"].size() == b["stages"].size());
  for (std::size_t s = 0; s < a["stages"].size(); ++s) {
    const json &da = a["stages"][s]["deviation"], &db = b["stages"][s]["deviation"];
    // The intervals of one truth, each no wider than the resolution: they overlap.
    for (const char* key : {"gouge_mm", "uncut_mm"}) {
      CHECK(da[key]["low"].get<double>() <= db[key]["high"].get<double>());
      CHECK(db[key]["low"].get<double>() <= da[key]["high"].get<double>());
      CHECK(da[key]["high"].get<double>() ==
            Approx(db[key]["high"].get<double>()).margin(da["resolution_mm"].get<double>()));
    }
    CHECK(da["coverage"].get<double>() == Approx(db["coverage"].get<double>()).margin(1e-9));
  }
}

}  // namespace

TEST_CASE("a mesh that is a box is judged as the box is", "[e2e][stock]") {
  const Scratch scratch;
  write_text(scratch / "block.stl", stl(tests::block_between({-3, -3, 6}, {23, 23, 15})));
  const json mesh = run_as(scratch,
                           quick_job("shape = \"mesh\"\nfile = \"block.stl\"\n"
                                     "translate = [-10, -10, -10]"),
                           "mesh");
  const json box = run_as(scratch,
                          quick_job("shape = \"box\"\nsize = [26, 26, 9]\n"
                                    "corner = [-13, -13, -4]"),
                          "box");
  CHECK(mesh["stock"] == json{{"shape", "mesh"},
                              {"file", "block.stl"},
                              {"triangles", 12},
                              {"corner_mm", {-13.0, -13.0, -4.0}},
                              {"size_mm", {26.0, 26.0, 9.0}},
                              {"volume_mm3", mesh["stock"]["volume_mm3"]}});
  CHECK(mesh["stock"]["volume_mm3"].get<double>() == Approx(26 * 26 * 9));
  for (const std::string stage : {"rough", "finish"})
    CHECK(read_text(scratch / ("mesh/" + stage + "/toolpath.ngc")) ==
          read_text(scratch / ("box/" + stage + "/toolpath.ngc")));
  check_same_figures(mesh, box);
  for (std::size_t s = 0; s < 2; ++s) {
    const auto removed = [&](const json& r) {
      return r["stages"][s]["simulation"]["removed_volume_mm3"].get<double>();
    };
    CHECK(removed(mesh) == Approx(removed(box)).epsilon(1e-4));
  }
  CHECK_THAT(mesh["assumptions"].dump(), ContainsSubstring("clear the box about the stock's mesh"));
  CHECK_THAT(read_text(scratch / "mesh/report.html"),
             ContainsSubstring("block.stl: mesh of 12 triangles"));
}

TEST_CASE("a finish from the stock that roughing left", "[e2e][stock]") {
  const Scratch scratch;
  const json both = run_as(scratch,
                           quick_job("shape = \"box\"\nsize = [26, 26, 9]\n"
                                     "corner = [-13, -13, -4]"),
                           "both");
  std::string later = quick_job("shape = \"vdb\"\nfile = \"both/rough/stock.vdb\"");
  later = between(later, "[[stage]]\nname = \"rough\"", "[[stage]]\nname = \"finish\"", "");
  const json second = run_as(scratch, later, "second");
  CHECK(second["stock"]["shape"] == "vdb");
  CHECK(second["stock"]["voxel_mm"] == 0.25);
  CHECK_THAT(second["assumptions"].dump(), ContainsSubstring("zero set at a voxel of 0.25 mm"));
  // What the finish leaves on the dome was made by the finish alone.
  json finish = both;
  finish["stages"].erase(0);
  check_same_figures(second, finish);
  const auto removed = [](const json& r) {
    return r["stages"].back()["simulation"]["removed_volume_mm3"].get<double>();
  };
  // The .vdb cuts edges of the rough stock off by up to a voxel.
  CHECK(removed(second) == Approx(removed(both)).epsilon(0.02));
}

// A voxel's edges are blunt: a cusp that one job leaves, and measures, is lower in its stock.vdb.
TEST_CASE("a cusp that an earlier run left is not passed for being blunt", "[e2e][stock]") {
  const Scratch scratch;
  write_text(scratch / "sheet.obj",
             "v 1 8.25 0\nv 19 8.25 0\nv 19 12.25 0\nv 1 12.25 0\nf 1 2 3\nf 1 3 4\n");
  const std::string first = "G0 X-10 Y8.25 Z20\nG0 Z0\nG1 X30 F500\nG0 Z20\n";
  const auto program = [](const std::string& moves) {
    return "G21 G90 G17 G94\nT1 M6\nS1000 M3\n" + moves + "M30\n";
  };
  write_text(scratch / "both.ngc", program(first + "G0 X-10 Y12.25\nG0 Z0\nG1 X30\nG0 Z20\n"));
  write_text(scratch / "again.ngc", program(first));
  const std::string tool = "1=ball:D=6,L=20";
  REQUIRE(limitgauge(scratch, {"cut", "--stock", "box:20,20,10@0,0,-5", "--tool", tool, "--program",
                               "both.ngc", "--voxel", "0.5", "--no-pictures", "-o", "cut"})
              .exit_code == 0);
  const auto uncut = [&](const std::string& stock, const std::string& file, const std::string& out,
                         int expected) {
    const Outcome outcome = limitgauge(
        scratch, {"verify", "--target", "sheet.obj", "--stock", stock, "--tool", tool, "--program",
                  file, "--gouge", "0.05", "--uncut", "0.7", "--no-pictures", "-o", out});
    INFO(outcome.out << outcome.errors);
    CHECK(outcome.exit_code == expected);
    return json::parse(read_text(scratch / (out + "/result.json")))["stages"][0]["deviation"];
  };
  // Two rows 4 mm apart of a ball of 3 mm.
  const double cusp = 3 - std::sqrt(9 - 2 * 2);
  const json whole = uncut("box:20,20,10@0,0,-5", "both.ngc", "whole", 1);
  CHECK(whole["uncut_mm"]["low"] > 0.7);
  CHECK(whole["uncut_mm"]["high"] >= cusp);
  const json chain = uncut("vdb:cut/program/stock.vdb", "again.ngc", "chain", 2);
  CHECK(chain["uncut_mm"]["low"] < cusp);
  CHECK(chain["uncut_mm"]["high"] > cusp);
  const auto& terms = chain["uncertainty"];
  CHECK(std::any_of(terms.begin(), terms.end(), [](const json& term) {
    return term["source"] == "edges of the stock, blunt by its voxels" &&
           std::abs(term["bound_mm"].get<double>() - std::sqrt(0.75)) < 1e-12;
  }));
}

TEST_CASE("verify takes a mesh and a .vdb, and refuses broken ones", "[e2e][stock]") {
  const Scratch scratch;
  REQUIRE(limitgauge(scratch, {"plan", fixture("jobs/quick-dome.toml"), "-o", "plan"}).exit_code ==
          0);
  write_text(scratch / "block.stl", stl(tests::block_between({-13, -13, -4}, {13, 13, 5})));
  const auto verify = [&](const std::string& stock) {
    return limitgauge(
        scratch, {"verify", "--cage", fixture("cages/quick-dome.obj"), "--stock", stock, "--tool",
                  "flat:D=6,L=20,shank=6:30", "--program", "plan/rough/toolpath.ngc", "--allowance",
                  "0.3", "--voxel", "0.5", "--set", "verification.resolution=0.02", "-o", "out",
                  "--no-pictures", "--force"});
  };
  CHECK(verify("mesh:block.stl").exit_code == 0);
  CHECK(verify("vdb:out/program/stock.vdb").exit_code == 0);
  write_text(scratch / "open.stl", read_text(scratch / "block.stl").substr(0, 1000));
  for (const char* broken : {"mesh:open.stl", "mesh:none.stl", "vdb:block.stl", "vdb:none.vdb"}) {
    const Outcome outcome = verify(broken);
    CHECK(outcome.exit_code == 3);
    CHECK_THAT(outcome.errors,
               ContainsSubstring(std::string(broken).substr(std::string(broken).find(':') + 1)));
  }
}

}  // namespace limitgauge::e2e
