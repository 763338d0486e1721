#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>

#include "app/cli/commands.h"
#include "app/inputs/mesh_target.h"
#include "app/inputs/run_inputs.h"
#include "app/inputs/surface_witness.h"
#include "model/base/absolute_path.h"
#include "model/base/error.h"
#include "model/base/output_file.h"
#include "model/gcode/program.h"
#include "model/part/target_mesh.h"
#include "model/text/clean_text.h"
#include "model/text/number_text.h"
#include "verifier/surface/reference_surface.h"

namespace limitgauge::app {
namespace {

using model::Motion;
using model::MotionKind;

/// Six decimals: a nanometre, finer than any program states. No "-0.000000".
std::string fixed(double value) {
  constexpr double kHalfUnit = 0.5e-6;
  std::array<char, 64> text{};
  const int length =
      std::snprintf(text.data(), text.size(), "%.6f", std::abs(value) < kHalfUnit ? 0.0 : value);
  return {text.data(), static_cast<std::size_t>(std::max(0, length))};
}

void print_motion(std::ostream& out, const Motion& motion) {
  out << motion.line << ' ';
  if (motion.kind == MotionKind::rapid) out << "rapid";
  if (motion.kind == MotionKind::feed) out << "feed";
  if (motion.kind == MotionKind::arc) out << "arc " << static_cast<int>(motion.plane);
  out << ' ' << fixed(motion.to.x) << ' ' << fixed(motion.to.y) << ' ' << fixed(motion.to.z);
  if (motion.kind == MotionKind::arc) {
    out << ' ' << fixed(motion.centre1) << ' ' << fixed(motion.centre2) << ' '
        << model::shortest(motion.turns);
  }
  out << '\n';
}

/// Where the program starts nobody stated: axes that it has not named stand at 0.
void print_start(std::ostream& out, const model::Program& program) {
  const auto leaning = std::find_if(program.motions.begin(), program.motions.end(),
                                    [](const Motion& motion) { return !motion.position_known; });
  if (leaning == program.motions.end()) return;
  out << "assumed: line " << leaning->line
      << ", moves before X, Y and Z have all been named; the others stand at 0 (--start)\n";
}

void print_summary(std::ostream& out, const model::Program& program) {
  const auto count = [&](MotionKind kind) {
    return std::count_if(program.motions.begin(), program.motions.end(),
                         [&](const Motion& motion) { return motion.kind == kind; });
  };
  model::Box3 box;
  for (const Motion& motion : program.motions) {
    box.add(motion.to);
  }
  out << "rapids        " << count(MotionKind::rapid) << '\n'
      << "feeds         " << count(MotionKind::feed) << '\n'
      << "arcs          " << count(MotionKind::arc) << '\n';
  if (!box.empty()) {
    out << "end points    " << fixed(box.low.x) << ' ' << fixed(box.low.y) << ' '
        << fixed(box.low.z) << " to " << fixed(box.high.x) << ' ' << fixed(box.high.y) << ' '
        << fixed(box.high.z) << " mm\n";
  }
  out << "tools         " << program.tool_changes.size() << " changes\n";
  for (const std::string& said : program.assumed)
    out << "assumed: " << model::one_line(said) << '\n';
  if (!program.has_end) out << "assumed: the program " << missing_end_words(program) << '\n';
  print_start(out, program);
  out << "words set aside " << program.ignored.size() << '\n';
  for (const model::IgnoredWord& word : program.ignored) {
    out << "  line " << word.line << ": " << model::one_line(word.word) << '\n';
  }
}

/// Prints what a program is: its canonical moves, one a line, or a summary of them.
void inspect_program(const InspectCommand& command, const CommonOptions& common,
                     const Console& console) {
  model::MachineSetup machine = machine_of(command.machine);
  machine.assume_fresh_machine = true;
  const model::Program program = model::read_program_or_name_control(command.file, machine);
  if (command.moves) {
    for (const Motion& motion : program.motions) print_motion(console.out, motion);
    console.out << std::flush;
  } else if (!common.quiet) {
    print_summary(console.out, program);
    console.out << std::flush;
  }
}

using verifier::ReferenceSurface;

const char* boundary_words(model::BoundaryRule rule) {
  switch (rule) {
    case model::BoundaryRule::none:
      return "none (faces at the boundary are no surface)";
    case model::BoundaryRule::edge_and_corner:
      return "edge and corner";
    case model::BoundaryRule::edge_only:
      return "edge only";
  }
  return "";
}

void print_counts(std::ostream& out, const char* title,
                  const std::vector<std::array<model::Index, 2>>& counts) {
  out << title;
  if (counts.empty()) out << " none";
  for (const auto& [what, how_many] : counts) out << ' ' << what << ':' << how_many;
  out << '\n';
}

/// What is to be said of the surface beside its figures.
std::string problems_of(const model::Cage& cage) {
  std::string problems = mesh_like_warning(summarize(cage));
  if (!cage.ends_in_line)
    problems += (problems.empty() ? "" : "; ") +
                std::string("the last line has no line end: the file may be cut off");
  return problems.empty() ? "none" : problems;
}

void print_cage(std::ostream& out, const model::Cage& cage, const ReferenceSurface& surface,
                const witness::Agreement& witness) {
  const model::CageSummary summary = summarize(cage);
  const model::Box3& box = surface.bounding_box();
  out << "vertices               " << summary.vertices << '\n'
      << "faces                  " << summary.faces << '\n'
      << "patches                " << summary.patches << '\n'
      << "boundary edges         " << summary.boundary_edges << '\n'
      << "extraordinary vertices " << summary.extraordinary_vertices << '\n';
  print_counts(out, "face sizes            ", summary.face_sizes);
  print_counts(out, "interior valences     ", summary.interior_valences);
  print_counts(out, "boundary valences     ", summary.boundary_valences);
  out << "creases                " << summary.creases << '\n'
      << "corners                " << summary.corners << '\n'
      << "holes                  " << summary.holes << '\n'
      << "boundary rule          " << boundary_words(cage.boundary) << '\n'
      << std::fixed << std::setprecision(6) << "limit surface low      " << box.low.x << ' '
      << box.low.y << ' ' << box.low.z << " mm\n"
      << "limit surface high     " << box.high.x << ' ' << box.high.y << ' ' << box.high.z
      << " mm\n"
      << "limit surface size     " << box.size().x << " x " << box.size().y << " x " << box.size().z
      << " mm\n"
      << "limit surface area     " << surface.area_mm2() << " mm2\n"
      << "witness                " << words_of(witness) << '\n'
      << "problems               " << problems_of(cage) << std::endl;
}

constexpr std::string_view kSampleColumns = "face,u,v,x,y,z,nx,ny,nz";

void write_samples(std::ostream& out, const ReferenceSurface& surface, int samples) {
  out << kSampleColumns << '\n' << std::setprecision(std::numeric_limits<double>::max_digits10);
  const double last = samples - 1;
  for (int patch = 0; patch < surface.patch_count(); ++patch) {
    if (!surface.has_surface(patch)) continue;
    for (int j = 0; j < samples; ++j) {
      for (int i = 0; i < samples; ++i) {
        const double u = i / last, v = j / last;
        const verifier::SurfaceSample s = surface.evaluate(patch, u, v);
        out << patch << ',' << u << ',' << v << ',' << s.position.x << ',' << s.position.y << ','
            << s.position.z << ',' << s.normal.x << ',' << s.normal.y << ',' << s.normal.z << '\n';
      }
    }
  }
}

/// Nothing else is overwritten, but for an empty file: --csv has no --force.
bool begins_with_header(const std::filesystem::path& csv) {
  std::ifstream in(csv, std::ios::binary);
  std::string line;
  return !std::getline(in, line) || line == kSampleColumns;
}

void require_writable(const std::filesystem::path& csv) {
  const auto refuse = [&](const std::string& wrong, const char* expected) {
    throw model::InputError({csv.string(), 0, 0}, wrong, expected);
  };
  const std::filesystem::path folder = csv.has_parent_path() ? csv.parent_path() : ".";
  std::error_code failure;
  if (!std::filesystem::is_directory(folder, failure))
    refuse("its folder does not exist" + (failure ? ": " + failure.message() : std::string()),
           "a file in a folder that does");
  const std::filesystem::file_status there = std::filesystem::status(csv, failure);
  if (there.type() == std::filesystem::file_type::none)
    refuse("cannot be written: " + failure.message(), "another name");
  if (std::filesystem::is_directory(there))
    refuse("this is a folder", "a file, or a name that is free");
  if (there.type() == std::filesystem::file_type::regular && !begins_with_header(csv))
    refuse("this file holds something else than samples, which would be lost",
           "a name that is free, or samples written before");
}

void print_mesh(std::ostream& out, const JobSurface& read) {
  const model::CageSummary summary = summarize(read.cage);
  const model::Box3& box = read.surface.bounding_box();
  out << "triangles              " << summary.faces << '\n'
      << "dropped triangles      " << read.mesh->dropped_triangles << '\n'
      << "vertices               " << summary.vertices << '\n'
      << "boundary edges         " << summary.boundary_edges << '\n'
      << std::fixed << std::setprecision(6) << "mesh low               " << box.low.x << ' '
      << box.low.y << ' ' << box.low.z << " mm\n"
      << "mesh high              " << box.high.x << ' ' << box.high.y << ' ' << box.high.z
      << " mm\n"
      << "mesh size              " << box.size().x << " x " << box.size().y << " x " << box.size().z
      << " mm\n"
      << "mesh area              " << read.surface.area_mm2() << " mm2\n"
      << "witness                " << words_of(read.witness) << '\n'
      << "problems               "
      << (is_open(read.cage) ? "none; open: the side from which triangles go round "
                               "counter-clockwise is machined"
                             : "none")
      << std::endl;
}

/// By its name; an OBJ is taken for a cage.
bool is_mesh_file(const std::filesystem::path& file) {
  const std::string extension = model::lower_extension(file);
  return extension == ".stl" || extension == ".ply";
}

void inspect_mesh(const InspectCommand& command, const CommonOptions& common,
                  const Console& console) {
  Job job;
  JobDesign& design = job.design.emplace();
  design.kind = DesignKind::mesh;
  design.file = command.file;
  const JobSurface read = load_surface(job, {common.threads, console.stop, {}});
  if (!common.quiet) print_mesh(console.out, read);
}

void inspect_cage(const InspectCommand& command, const CommonOptions& common,
                  const Console& console) {
  if (!command.csv.empty()) require_writable(command.csv);
  Job job;
  job.design.emplace().file = command.file;
  const JobSurface read = load_surface(job, {common.threads, console.stop, {}});
  if (!command.csv.empty())
    model::write_whole_file(
        command.csv, [&](std::ostream& out) { write_samples(out, read.surface, command.samples); });
  if (!common.quiet) print_cage(console.out, read.cage, read.surface, read.witness);
}

/// Throws UsageError for an option that a cage or a mesh has no use for.
void require_no_program_options(const InspectCommand& command) {
  const std::string option = command.moves ? "--moves" : stated_option(command.machine);
  if (!option.empty()) throw UsageError(option + " is for programs; expected a file of G-code");
}

}  // namespace

ExitCode execute(const InspectCommand& command, const CommonOptions& common,
                 const Console& console) {
  if (is_mesh_file(command.file)) {
    require_no_program_options(command);
    if (command.samples > 0) throw UsageError("--samples is for cages; expected a file .obj");
    inspect_mesh(command, common, console);
    return ExitCode::pass;
  }
  if (model::lower_extension(command.file) != ".obj") {
    if (command.samples > 0) {
      throw UsageError("--samples is for cages; expected a file .obj");
    }
    inspect_program(command, common, console);
    return ExitCode::pass;
  }
  require_no_program_options(command);
  inspect_cage(command, common, console);
  return ExitCode::pass;
}

}  // namespace limitgauge::app
