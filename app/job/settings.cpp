#include "app/job/settings.h"

#include <algorithm>
#include <limits>

#include "model/text/number_text.h"
#include "simulator/instrument/dexel_removal.h"
#include "verifier/gate/verify.h"

namespace limitgauge::app {
namespace {

constexpr double kVoxelsPerGate = 10;
constexpr double kSmallestVoxel_mm = 0.05;
constexpr double kLargestVoxel_mm = 0.25;
constexpr double kMostSurfaceVoxels = 5e6;
constexpr double kVoxelWithoutGate_mm = 0.1;

std::string machining_time_words(const Job& job) {
  const std::string rates = "machining time: programmed feeds and a rapid rate of " +
                            model::shortest(job.rapid_mm_min) + " mm/min, ";
  if (!job.acceleration_mm_s2) return rates + "no acceleration: speeds change at once";
  return rates + "acceleration of " + model::shortest(*job.acceleration_mm_s2) +
         " mm/s² along the path, corners rounded off by at most " +
         model::shortest(job.junction_deviation_mm) +
         " mm; tool changes and spindle starts take no time";
}

std::string point_words(const model::Vec3& p) {
  return "(" + model::shortest(p.x) + ", " + model::shortest(p.y) + ", " + model::shortest(p.z) +
         ")";
}

std::string frame_words(const Job& job) {
  if (job.program_frame == model::RigidPlacement())
    return "cage, stock and programs share one frame in millimetres; no alignment is made";
  return "cage and stock share one frame in millimetres; the zero of programs lies at " +
         point_words(job.program_frame.translate_mm) + " in it, turned about Z by " +
         model::shortest(job.program_frame.rotate_z_deg) + " degrees; no alignment is made";
}

void state_stage(const JobStage& stage, double resolution_mm, double floor_z_mm,
                 bool automatic_resolution, const Post& post, std::vector<std::string>& said) {
  const std::string head = "stage " + stage.name + ": ";
  if (automatic_resolution) {
    said.push_back(head + "resolution " + model::shortest(resolution_mm) +
                   " mm (auto: a tenth of the tightest gate limit)");
  }
  if (stage.plan && !stage.plan->floor_z_mm) {
    said.push_back(head + "lowest tip height z " + model::shortest(floor_z_mm) +
                   " mm (default: lowest point of the surface less the cutter's corner radius)");
  }
  if (stage.plan && post.arc_tolerance_mm) {
    said.push_back(head + "arcs stand for runs of planned moves within " +
                   model::shortest(*post.arc_tolerance_mm) +
                   " mm; the program is measured as it is written, arcs as chords within " +
                   model::shortest(chord_error_mm(resolution_mm)) + " mm");
  }
  if (stage.plan && stage.plan->cut.strategy == engine::strategy::Strategy::rest) {
    said.push_back(head + "cuts where more than " + model::shortest(rest_threshold_mm(stage)) +
                   " mm stand that its cutter can reach (" +
                   (stage.limits.has_uncut ? "half of its uncut limit" : "its tolerance") + ")");
  }
  if (!stage.plan) {
    said.push_back(head + "arcs as chords within " +
                   model::shortest(chord_error_mm(resolution_mm)) + " mm");
    said.push_back(head + "the tool is taken to be " + model::to_text(stage.cutter) +
                   (stage.tool_number ? ", T" + std::to_string(*stage.tool_number)
                                      : std::string(", whatever number the program gives it")));
  }
}

}  // namespace

double automatic_voxel_mm(const Job& job) {
  double tightest = std::numeric_limits<double>::infinity();
  for (const JobStage& stage : job.stages) {
    if (stage.limits.has_gouge) tightest = std::min(tightest, stage.limits.gouge_mm);
    if (stage.limits.has_uncut) tightest = std::min(tightest, stage.limits.uncut_mm);
  }
  if (tightest == std::numeric_limits<double>::infinity())
    tightest = kVoxelWithoutGate_mm / kVoxelsPerGate;
  // In whole micrometres, so that the report can say it.
  const double by_gate = std::round(kVoxelsPerGate * tightest * 1000) / 1000;
  const double wanted = std::clamp(by_gate, kSmallestVoxel_mm, kLargestVoxel_mm);
  // A grid costs time and memory by the surface of the stock; the verdict comes from the
  // certificate.
  const model::Vec3 size = model::bounding_box(job.stock).size();
  const double surface_mm2 = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  return std::max(wanted, std::ceil(std::sqrt(surface_mm2 / kMostSurfaceVoxels) * 100) / 100);
}

double automatic_floor_mm(const model::Cutter& cutter, const model::Box3& surface) {
  return surface.low.z - cutter.corner_radius_mm;
}

double chord_error_mm(double resolution_mm) {
  return resolution_mm / 4;
}

double rest_threshold_mm(const JobStage& stage) {
  return stage.limits.has_uncut ? stage.limits.uncut_mm / 2 : stage.plan->cut.tolerance_mm;
}

/// What one calls a touch, whatever the voxel is: the search knows the stock exactly. Well above
/// the rounding of coordinates and the chords of arcs, well below what leaves a mark that matters.
constexpr double kContactTolerance_mm = 0.01;

Settings choose_settings(const Job& job, const model::Box3& surface,
                         std::size_t memory_limit_bytes) {
  Settings settings;
  settings.voxel_mm = job.voxel_mm.value_or(automatic_voxel_mm(job));
  settings.contact_tolerance_mm = job.contact_tolerance_mm.value_or(kContactTolerance_mm);
  settings.memory_limit_bytes = settings.stock_limit_bytes = memory_limit_bytes;
  settings.line_spacing_mm = simulator::removal_spacing_mm(settings.voxel_mm, job.stock, {});
  for (const JobStage& stage : job.stages) {
    settings.resolution_mm.push_back(
        job.resolution_mm.value_or(verifier::automatic_resolution_mm(stage.limits)));
    settings.floor_z_mm.push_back(
        !stage.plan ? std::numeric_limits<double>::quiet_NaN()
                    : stage.plan->floor_z_mm.value_or(automatic_floor_mm(stage.cutter, surface)));
  }
  return settings;
}

std::vector<std::string> assumptions(const Job& job, const Settings& settings) {
  std::vector<std::string> said = {
      "rapids are straight moves of the tool tip; a machine's own rapid need not be straight",
      frame_words(job),
      machining_time_words(job),
      "tool changes move nothing: each tool starts where the one before stood",
      "collisions: contacts shallower than " +
          model::shortest(1e3 * settings.contact_tolerance_mm) + " µm" +
          (job.contact_tolerance_mm ? "" : " (not stated)") +
          " fail nothing; those of a tenth of that and more are listed",
      job.travel_mm ? "travel limits: as the job states them, for the tool tip in the job's frame"
                    : "travel limits: none stated, none checked",
      job.near_miss_mm > 0
          ? "near misses: rapids, shanks and holders within " + model::shortest(job.near_miss_mm) +
                " mm of stock or fixtures are listed and do not fail a stage"
          : "near misses: no clearance stated, not looked for",
  };
  const auto is_program = [](const JobStage& stage) { return !stage.plan.has_value(); };
  if (std::any_of(job.stages.begin(), job.stages.end(), is_program))
    said.push_back("programs are read by the habits of control " +
                   std::string(model::name(job.machine.control)) +
                   (job.machine.control_is_stated ? "" : " (not stated)"));
  if (!job.voxel_mm) {
    said.push_back(
        "voxel " + model::shortest(settings.voxel_mm) +
        " mm (auto: ten times the tightest gate limit, within 0.05 and 0.25 mm, or as fine as five "
        "million voxels cover the surface of the stock)");
  }
  said.insert(said.end(), job.defaulted.begin(), job.defaulted.end());
  for (std::size_t i = 0; i < job.stages.size(); ++i) {
    state_stage(job.stages[i], settings.resolution_mm[i], settings.floor_z_mm[i],
                !job.resolution_mm, job.post, said);
  }
  return said;
}

}  // namespace limitgauge::app
