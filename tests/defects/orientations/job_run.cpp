#include "tests/defects/orientations/job_run.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "model/part/cage_obj.h"
#include "tests/e2e/program.h"
#include "tests/support/printed.h"

namespace limitgauge::tests::defects {
namespace {

namespace fs = std::filesystem;
using model::Vec3;
using nlohmann::json;

/// Grid of the simulated stock: coarse, since the certificate does not go by it.
constexpr double kVoxel_mm = 0.4;

/// The corners of a block as triangles' corners, outward: two of each side.
void write_block(const fs::path& file, const std::vector<Vec3>& corners) {
  std::ofstream out(file);
  for (const Vec3& p : corners) out << printed("v %.17g %.17g %.17g\n", p.x, p.y, p.z);
  for (const char* face : {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"})
    out << "f " << face << "\n";
}

std::string machine_text(const JobText& job) {
  if (!job.machine) return {};
  const Machine& m = *job.machine;
  std::string text = printed("[machine]\nkinematics = \"%s\"\ncontrol = \"%s\"\n", name(m.chain),
                             job.control.c_str()) +
                     "work_offsets = { G54 = " + toml_numbers(m.zero_mm) + " }\n";
  for (const Rotary& axis : m.axes)
    text += printed("[[machine.axis]]\nword = \"%c\"\n", axis.word) +
            "direction = " + toml_numbers(axis.direction) +
            "\npoint = " + toml_numbers(axis.point_mm) + "\nlimits = [-720, 720]\n";
  return text;
}

std::string tool_text(const JobText& job) {
  const model::Cutter& c = job.cutter;
  constexpr const char* kTypes[] = {"flat", "ball", "bull", "taper"};
  std::string text = printed("[[tool]]\nid = \"%s\"\ntype = \"%s\"\ndiameter = %.17g\n",
                             c.id.c_str(), kTypes[static_cast<int>(c.type)], c.diameter_mm) +
                     printed("flute_length = %.17g\nplunge = true\n", c.flute_length_mm);
  if (c.type == model::CutterType::bull || c.type == model::CutterType::taper)
    text += printed("corner_radius = %.17g\n", c.corner_radius_mm);
  if (c.type == model::CutterType::taper) text += printed("angle = %.17g\n", c.taper_angle_deg);
  if (job.machine) text += printed("number = 1\nlength = %.17g\n", job.machine->length_mm);
  return text;
}

std::string text_of(const JobText& job) {
  return "name = \"lying\"\n[surface]\ncage = \"part.obj\"\n[stock]\nshape = \"mesh\"\nfile = "
         "\"block.obj\"\n" +
         machine_text(job) + job.setup.text() + tool_text(job) +
         printed("[[stage]]\nname = \"cut\"\ntool = \"%s\"\nsetup = \"vice\"\n",
                 job.cutter.id.c_str()) +
         printed("program = \"part.nc\"\nallowance = %.17g\n[stage.gate]\n", job.allowance_mm) +
         printed("gouge = %.17g\nuncut = %.17g\n", job.gouge_mm, job.uncut_mm) +
         printed("[simulation]\nvoxel = %.17g\n[verification]\nresolution = %.17g\n", kVoxel_mm,
                 job.resolution_mm);
}

verifier::Interval interval(const json& said) {
  return {said["low"].get<double>(), said["high"].get<double>()};
}

std::vector<NamedPlace> places(const json& findings) {
  std::vector<NamedPlace> out;
  for (const json& f : findings)
    out.push_back({{f["patch"].get<int>(), f["u"].get<double>(), f["v"].get<double>()},
                   {f["x"].get<double>(), f["y"].get<double>(), f["z"].get<double>()},
                   f["depth_mm"].get<double>(),
                   f.value("line", 0L)});
  return out;
}

StageSaid stage_said(const json& stage) {
  StageSaid out;
  out.verdict = stage["verdict"];
  if (stage.contains("stretch"))
    out.stretch = stage["stretch"]["number"], out.stretches = stage["stretch"]["count"];
  const json& d = stage["deviation"];
  out.gouge = interval(d["gouge_mm"]), out.uncut = interval(d["uncut_mm"]);
  out.gouges = places(d["gouges"]), out.uncuts = places(d["uncuts"]);
  for (const json& f : stage["simulation"]["findings"])
    out.process.push_back(f["kind"].get<std::string>() +
                          printed(" at line %ld", f.value("line", 0L)));
  return out;
}

void read_result(const fs::path& file, JobSaid& said) {
  std::ifstream in(file);
  if (!in) return;
  const json result = json::parse(in);
  said.verdict = result["verdict"];
  for (const json& stage : result["stages"])
    if (stage.contains("deviation")) said.stage = stage_said(stage);
}

}  // namespace

JobSaid run_job(const JobText& job, const std::string& keep) {
  const e2e::Scratch scratch;
  std::ofstream cage(scratch / "part.obj");
  model::write_cage_obj(job.cage, cage);
  cage.close();
  write_block(scratch / "block.obj", job.block);
  e2e::write_text(scratch / "part.nc", job.program);
  e2e::write_text(scratch / "job.toml", text_of(job));
  const e2e::Outcome outcome = e2e::limitgauge(
      scratch, {"run", "job.toml", "-o", "out", "--no-pictures", "--quiet", "--threads", "1"});
  JobSaid said;
  said.exit_code = outcome.exit_code, said.errors = outcome.errors;
  if (!keep.empty()) fs::copy(scratch.path(), keep, fs::copy_options::recursive);
  read_result(scratch / "out" / "result.json", said);
  return said;
}

}  // namespace limitgauge::tests::defects
