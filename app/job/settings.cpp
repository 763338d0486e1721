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
/// A cutter of that many voxels across leaves a stock that looks like its cuts.
constexpr double kVoxelsPerCutter = 40;
constexpr double kLargestVoxelOfCutter_mm = 0.5;
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
  if (has_setups(job))
    return std::string(job.design ? "cage and stock share the part's frame"
                                  : "the stock is in the part's frame") +
           " in millimetres; programs, fixtures, floors and travel are in the frame of their "
           "setup, "
           "in which the part lies as the setup says; no alignment is made";
  if (job.program_frame == model::RigidPlacement())
    return std::string(job.design ? "cage, stock and programs" : "stock and programs") +
           " share one frame in millimetres; no alignment is made";
  return std::string(job.design ? "cage and stock share one frame in millimetres"
                                : "the stock's frame is in millimetres") +
         "; the zero of programs lies at " + point_words(job.program_frame.translate_mm) +
         " in it, turned about Z by " + model::shortest(job.program_frame.rotate_z_deg) +
         " degrees; no alignment is made";
}

std::string travel_words(const Job& job) {
  if (!job.travel_mm) return "travel limits: none stated, none checked";
  return std::string("travel limits: as the job states them, for the tool tip in the job's frame") +
         (job.machine.kinematics ? ", which X, Y and Z show of a tool that stands upright" : "");
}

void state_lean(const JobStage& stage, const std::string& chords, std::vector<std::string>& said) {
  const std::string head = "stage " + stage.name + ": ";
  said.push_back(head +
                 "the program is measured as it is written and read again: rotary axes turn evenly "
                 "while the tip goes straight, no place of the tool further off than " +
                 chords + "; it has no arcs");
  if (stage.plan->tilt_is_auto)
    said.push_back(head +
                   "tilt auto: of 0, 5, -5, 10, -10, ... 60, -60 degrees the first for which "
                   "flutes, shank and holder are proven free of the part and the process of the "
                   "stock as it stands");
}

void state_stage(const Job& job, const Settings& settings, std::size_t index,
                 std::vector<std::string>& said) {
  const JobStage& stage = job.stages[index];
  const double floor_z_mm = settings.floor_z_mm[index];
  const std::string chords = model::shortest(settings.chord_error_mm[index]) + " mm";
  const std::string head = "stage " + stage.name + ": ";
  if (job.design && !job.resolution_mm) {
    said.push_back(head + "resolution " + model::shortest(settings.resolution_mm[index]) +
                   " mm (auto: a tenth of the tightest gate limit)");
  }
  std::string finer;
  for (const std::size_t i : finer_stages(job, index))
    finer += (finer.empty() ? "" : ", ") + job.stages[i].name;
  if (job.design && !finer.empty())
    said.push_back(head +
                   "no gouge of it is what finer stages of other setups took, which their own "
                   "gates judged: " +
                   finer);
  if (stage.plan && !stage.plan->floor_z_mm) {
    said.push_back(head + "lowest tip height z " + model::shortest(floor_z_mm) +
                   " mm (default: lowest point of the surface less the cutter's corner radius)");
  }
  if (stage.plan && stage.plan->cut.lean) state_lean(stage, chords, said);
  if (stage.plan && job.post.arc_tolerance_mm && !stage.plan->cut.lean) {
    said.push_back(head + "arcs stand for runs of planned moves within " +
                   model::shortest(*job.post.arc_tolerance_mm) +
                   " mm; the program is measured as it is written, arcs as chords within " +
                   chords);
  }
  if (stage.plan && stage.plan->cut.strategy == engine::strategy::Strategy::rest) {
    said.push_back(head + "cuts where more than " + model::shortest(rest_threshold_mm(stage)) +
                   " mm stand that its cutter can reach (" +
                   (stage.limits.has_uncut ? "half of its uncut limit" : "its tolerance") + ")");
  }
  if (!stage.plan) {
    const bool turns = stage.piece && stage.piece->turns_while_cutting();
    said.push_back(head + "arcs as chords within " + chords +
                   (job.design && !turns ? "; certified figures are of finer ones, whose error "
                                           "stands in the uncertainty budget"
                                         : ""));
    if (turns)
      said.push_back(
          head +
          "rotary axes are taken to turn evenly while X, Y and Z go; each such motion is "
          "moves whose tip goes straight and whose axis goes evenly along a great "
          "circle, no place of the tool further off than " +
          chords +
          "; feeds a minute are taken to be of X, Y and Z, and degrees a minute where "
          "those stand still");
    said.push_back(head + "the tool is taken to be " + model::to_text(stage.cutter) +
                   (stage.tool_number ? ", T" + std::to_string(*stage.tool_number)
                                      : std::string(", whatever number the program gives it")));
  }
}

}  // namespace

namespace {

/// In whole micrometres, so that the report can say it.
double in_micrometres(double mm) {
  return std::round(mm * 1000) / 1000;
}

double voxel_by_cutters_mm(const Job& job) {
  double smallest_mm = std::numeric_limits<double>::infinity();
  for (const JobStage& stage : job.stages)
    smallest_mm = std::min(smallest_mm, stage.cutter.diameter_mm);
  return std::clamp(in_micrometres(smallest_mm / kVoxelsPerCutter), kSmallestVoxel_mm,
                    kLargestVoxelOfCutter_mm);
}

double voxel_by_gates_mm(const Job& job) {
  double tightest = std::numeric_limits<double>::infinity();
  for (const JobStage& stage : job.stages) {
    if (stage.limits.has_gouge) tightest = std::min(tightest, stage.limits.gouge_mm);
    if (stage.limits.has_uncut) tightest = std::min(tightest, stage.limits.uncut_mm);
  }
  if (tightest == std::numeric_limits<double>::infinity())
    tightest = kVoxelWithoutGate_mm / kVoxelsPerGate;
  return std::clamp(in_micrometres(kVoxelsPerGate * tightest), kSmallestVoxel_mm, kLargestVoxel_mm);
}

}  // namespace

double automatic_voxel_mm(const Job& job) {
  const double wanted = job.design ? voxel_by_gates_mm(job) : voxel_by_cutters_mm(job);
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
/// Without a design arcs are as exact as the findings need them: contacts of a tenth of the
/// tolerance are listed.
constexpr double kChordsPerContact = 0.05;

std::vector<std::size_t> finer_stages(const Job& job, std::size_t index) {
  const JobStage& stage = job.stages[index];
  std::vector<std::size_t> finer;
  for (std::size_t i = 0; i < index; ++i) {
    const JobStage& before = job.stages[i];
    if (before.setup != stage.setup && before.allowance_mm < stage.allowance_mm &&
        before.limits.has_gouge)
      finer.push_back(i);
  }
  return finer;
}

double near_miss_mm(const Job& job) {
  return std::max(job.near_miss_mm, job.tolerances ? model::farthest_off_mm(*job.tolerances) : 0.0);
}

Settings choose_settings(const Job& job, const model::Box3& surface,
                         std::size_t memory_limit_bytes) {
  Settings settings;
  settings.voxel_mm = job.voxel_mm.value_or(automatic_voxel_mm(job));
  settings.contact_tolerance_mm = job.contact_tolerance_mm.value_or(kContactTolerance_mm);
  settings.memory_limit_bytes = settings.stock_limit_bytes = memory_limit_bytes;
  settings.line_spacing_mm = simulator::removal_spacing_mm(settings.voxel_mm, job.stock, {});
  for (const JobStage& stage : job.stages) {
    if (job.design)
      settings.resolution_mm.push_back(job.resolution_mm.value_or(
          verifier::automatic_resolution_mm(stage.piece ? stage.piece->limits : stage.limits)));
    settings.chord_error_mm.push_back(job.design
                                          ? chord_error_mm(settings.resolution_mm.back())
                                          : kChordsPerContact * settings.contact_tolerance_mm);
    settings.floor_z_mm.push_back(
        !stage.plan ? std::numeric_limits<double>::quiet_NaN()
                    : stage.plan->floor_z_mm.value_or(automatic_floor_mm(stage.cutter, surface)));
  }
  return settings;
}

std::vector<std::string> assumptions(const Job& job, const Settings& settings) {
  std::vector<std::string> said;
  if (!job.design)
    said.push_back(
        "no design: nothing is measured against a surface; a stage passes where nothing that fails "
        "was found in the process");
  const std::vector<std::string> always = {
      "rapids are straight moves of the tool tip; a machine's own rapid need not be straight",
      frame_words(job),
      machining_time_words(job),
      "tool changes move nothing: the spindle stands still, and a tool of no known length starts "
      "where the tip of the one before stood",
      "collisions: contacts shallower than " +
          model::shortest(1e3 * settings.contact_tolerance_mm) + " µm" +
          (job.contact_tolerance_mm ? "" : " (not stated)") +
          " fail nothing; those of a tenth of that and more are listed",
      travel_words(job),
      near_miss_mm(job) > 0
          ? "near misses: rapids, shanks and holders within " + model::shortest(near_miss_mm(job)) +
                " mm of stock or fixtures are listed and do not fail a stage" +
                (near_miss_mm(job) > job.near_miss_mm ? ": so far the tolerances may move a tool"
                                                      : "")
          : "near misses: no clearance stated, not looked for",
  };
  said.insert(said.end(), always.begin(), always.end());
  if (job.tolerances && job.design)
    said.push_back(
        "tolerances: gouge and uncut are certified and judged for all their values together; "
        "reach, coverage, maps and findings, and the simulated stock are of the stated tools and "
        "zero");
  const auto turns = [](const JobStage& stage) {
    return stage.piece && !stage.piece->range.turns.empty();
  };
  if (std::any_of(job.stages.begin(), job.stages.end(), turns))
    said.push_back("turns of rotary axes: the tool is proven to come no deeper than " +
                   model::shortest(1.5e3 * settings.contact_tolerance_mm) +
                   " µm into stock and part while they turn; what it takes there is in no figure");
  const auto is_program = [](const JobStage& stage) { return !stage.plan.has_value(); };
  if (std::any_of(job.stages.begin(), job.stages.end(), is_program))
    said.push_back("programs are read by the habits of control " +
                   std::string(model::name(job.machine.control)) +
                   (job.machine.control_is_stated ? "" : " (not stated)"));
  if (!job.voxel_mm) {
    said.push_back(
        "voxel " + model::shortest(settings.voxel_mm) +
        (job.design ? " mm (auto: ten times the tightest gate limit, within 0.05 and 0.25 mm"
                    : " mm (auto: a fortieth of the smallest cutter's diameter, within 0.05 and "
                      "0.5 mm") +
        ", or as fine as five million voxels cover the surface of the stock)");
  }
  said.insert(said.end(), job.defaulted.begin(), job.defaulted.end());
  for (std::size_t i = 0; i < job.stages.size(); ++i) state_stage(job, settings, i, said);
  return said;
}

}  // namespace limitgauge::app
