#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "model/part/cage.h"
#include "model/part/cage_obj.h"
#include "tests/e2e/program.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

const std::string kTwoSides = fixture("jobs/two-sides.toml");

json result_in(const fs::path& folder) {
  return json::parse(read_text(folder / "result.json"));
}

/// How far a point lies off the middle circle of the torus, in its own section. A uniform cubic
/// B-spline takes a circle of n control points to one (2 + cos(2π/n))/3 as large: twelve round Z.
double radius_in_tube(const json& f) {
  constexpr double kMiddle_mm = 9.55;
  const double x = f["x"], y = f["y"], z = f["z"];
  return std::hypot(std::hypot(x, y) - kMiddle_mm, z);
}

/// The quick dome in a frame of its own: what the job says of the part lies `turn` away, and one
/// setup turns it back.
class Reposed {
 public:
  Reposed(const Scratch& scratch, const model::Vec3& axis, double angle_deg)
      : turn_(model::turn_about(axis, angle_deg)) {
    turn_.shift_mm = {3, -2, 5};
    const model::Cage cage = model::read_cage_obj(fixture("cages/quick-dome.obj"));
    std::ofstream out(scratch / "dome.obj");
    out.precision(17);
    for (const model::Vec3& v : cage.vertices) {
      const model::Vec3 p = turn_.point_back(v);
      out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    for (model::Index f = 0; f < cage.face_count(); ++f) {
      out << 'f';
      for (const model::Index v : cage.face(f)) out << ' ' << v + 1;
      out << '\n';
    }
    write_block(scratch / "block.obj");
  }

  /// The setup's table.
  std::string table() const {
    std::ostringstream out;
    out.precision(17);
    out << "[[setup]]\nname = \"there\"\nmatrix = [";
    for (const model::Vec3& row : turn_.rows)
      out << "[" << row.x << ", " << row.y << ", " << row.z << "], ";
    out << "]\norigin = [" << turn_.shift_mm.x << ", " << turn_.shift_mm.y << ", "
        << turn_.shift_mm.z << "]\n";
    return out.str();
  }

 private:
  void write_block(const fs::path& file) const {
    std::ofstream out(file);
    out.precision(17);
    for (int corner = 0; corner < 8; ++corner) {
      const model::Vec3 p = turn_.point_back(
          {corner & 1 ? 13.0 : -13.0, corner & 2 ? 13.0 : -13.0, corner & 4 ? 5.0 : -4.0});
      out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    for (const char* face : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"})
      out << "f " << face << '\n';
  }

  model::Pose turn_;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// The quick dome's job with its part elsewhere.
std::string reposed_job(const Reposed& part) {
  std::string job = read_text(fixture("jobs/quick-dome.toml"));
  job = replaced(job, "../cages/quick-dome.obj", "dome.obj");
  job = replaced(job, "shape = \"box\"\nsize = [26, 26, 9]\ncorner = [-13, -13, -4]",
                 "shape = \"mesh\"\nfile = \"block.obj\"");
  job = replaced(job, "tool = \"", "setup = \"there\"\ntool = \"");
  return replaced(job, "[machine]", part.table() + "[machine]");
}

}  // namespace

TEST_CASE("a torus is cut from both sides, and all of it is certified", "[e2e][setups]") {
  const Scratch scratch;
  const Outcome outcome = limitgauge(scratch, {"run", kTwoSides, "-o", "out", "--no-pictures"});
  INFO(outcome.out << outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const json result = result_in(scratch / "out");
  REQUIRE(result["setups"].size() == 2);
  CHECK(result["setups"][1]["tool_axis"] == json({0, 0, -1}));
  CHECK(result["setups"][1]["rotation"] == json({{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}));
  const json& last = result["stages"][3];
  CHECK(last["setup"] == "bottom");
  CHECK(last["deviation"]["gouge_mm"]["high"] <= 0.02);
  CHECK(last["deviation"]["uncut_mm"]["high"] <= 0.02);
  // From above the lower half is out of reach, from both sides nothing is proven to be.
  const double area = result["surface"]["area_mm2"];
  CHECK(result["stages"][1]["deviation"]["reach"]["unreachable_mm2"] > 0.49 * area);
  CHECK(last["deviation"]["reach"]["unreachable_mm2"] == 0);
  CHECK(last["deviation"]["reach"]["undecided_mm2"] < 0.005 * area);
  // Places are the part's, where the tool came from below too: on the torus, whose tube has a
  // radius of some 3.6 mm, by the same rule of eight points.
  for (const json& stage : result["stages"])
    for (const char* kind : {"gouges", "uncuts"})
      for (const json& f : stage["deviation"][kind]) CHECK(std::abs(radius_in_tube(f) - 3.6) < 0.3);
  // Both halves are removed from the block alike.
  const double top = result["stages"][0]["simulation"]["removed_volume_mm3"];
  const double bottom = result["stages"][2]["simulation"]["removed_volume_mm3"];
  CHECK(top > 1000);
  CHECK(bottom > 1000);
}

TEST_CASE("a part that is turned by a sixth of a degree too much fails, with a line",
          "[e2e][setups][slow]") {
  const Scratch scratch;
  REQUIRE(limitgauge(scratch, {"plan", kTwoSides, "-o", "plan", "--quiet"}).exit_code == 0);
  // What was planned for the setups as they should be, as somebody's programs.
  std::ostringstream job;
  job << "name = \"off\"\nsurface = { cage = \"" << fixture("torture/torus.obj") << "\" }\n"
      << "stock = { shape = \"box\", size = [32, 32, 9], corner = [-16, -16, -4.5] }\n"
      << "simulation = { voxel = 0.2 }\n[[setup]]\nname = \"top\"\n[[setup]]\nname = \"bottom\"\n"
      << "rotate = [{ axis = [1, 0, 0], angle = 180.15 }]\n[[tool]]\nid = \"ball4\"\ntype = "
         "\"ball\"\n"
      << "diameter = 4\nflute_length = 30\n";
  for (const std::string side : {"bottom"})
    job << "[[stage]]\nname = \"" << side << "\"\nsetup = \"" << side
        << "\"\ntool = \"ball4\"\nprogram = \"plan/finish-" << side
        << "/toolpath.ngc\"\n[stage.gate]\ngouge = 0.02\n";
  write_text(scratch / "off.toml", job.str());
  const Outcome outcome =
      limitgauge(scratch, {"run", "off.toml", "-o", "out", "--no-pictures", "--quiet"});
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 1);
  const json result = result_in(scratch / "out");
  const json& failed = result["stages"][0];
  CHECK(failed["verdict"] == "fail");
  // On the one side of X the part stands in the way, 13 mm out by 13 · 0.15 · π/180 = 0.034 mm; on
  // the other it is left.
  const json& gouge = failed["deviation"]["gouge_mm"];
  CHECK(gouge["low"] > 0.02);
  CHECK(gouge["high"] < 0.05);
  REQUIRE_FALSE(failed["deviation"]["gouges"].empty());
  const json& worst = failed["deviation"]["gouges"][0];
  CHECK(worst["line"] > 0);
  CHECK(worst["z"] < 0);
}

TEST_CASE("figures do not depend on how the part lies", "[e2e][setups][slow]") {
  const Scratch scratch;
  REQUIRE(limitgauge(scratch, {"run", fixture("jobs/quick-dome.toml"), "-o", "nominal",
                               "--no-pictures", "--quiet"})
              .exit_code == 0);
  const json nominal = result_in(scratch / "nominal");
  const std::array<std::pair<model::Vec3, double>, 3> turns = {
      {{{1, 0, 0}, 180}, {{0, 1, 0}, 90}, {{1, 2, -3}, 77}}};
  for (const auto& [axis, angle] : turns) {
    const Reposed part(scratch, axis, angle);
    std::ofstream(scratch / "there.toml") << reposed_job(part);
    const Outcome outcome = limitgauge(
        scratch, {"run", "there.toml", "-o", "there", "--force", "--no-pictures", "--quiet"});
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    const json there = result_in(scratch / "there");
    for (std::size_t i = 0; i < 2; ++i) {
      const json &a = nominal["stages"][i]["deviation"], &b = there["stages"][i]["deviation"];
      for (const char* figure : {"gouge_mm", "uncut_mm"})
        for (const char* end : {"low", "high"}) {
          CAPTURE(i, figure, end);
          CHECK(std::abs(a[figure][end].get<double>() - b[figure][end].get<double>()) < 2e-5);
        }
    }
  }
}

}  // namespace limitgauge::e2e
