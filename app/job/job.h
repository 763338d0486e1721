#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/strategy/stage_path.h"
#include "model/base/error.h"
#include "model/gcode/dialect.h"
#include "model/gcode/program_path.h"
#include "model/part/cage.h"
#include "model/part/cutter.h"
#include "model/part/setup.h"
#include "model/part/stock.h"
#include "model/part/tolerances.h"
#include "reports/run/published.h"
#include "reports/run/report.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::app {

/// The job file's word for `strategy`.
const char* strategy_name(engine::strategy::Strategy strategy);

/// What a stage asks of the planner; only of stages that are planned here.
struct StagePlan {
  engine::strategy::CutOptions cut;
  std::optional<double> floor_z_mm;  ///< empty: chosen from the surface and the cutter
  /// Of cut.lean: its tilt is the least of tilt_grid() that is proven free of collisions.
  bool tilt_is_auto = false;
  model::SourcePlace tilt_place = {};  ///< where the job states it
};
/// The tilts that "auto" tries, in degrees, in this order.
std::vector<double> tilt_grid();

/// A cutter of the job, as the machine's tool table has it.
struct JobTool {
  model::Cutter cutter;
  std::optional<int> number;        ///< T of programs; empty: whatever number a program says
  std::optional<double> length_mm;  ///< from the gauge line to the tip
};

/// Which motions of a program a stage takes; nothing stated: all of them, by one tool. A part ends
/// where the next part that a stage takes begins, or with the program.
struct ProgramPart {
  std::optional<int> tool;     ///< from where T is loaded
  std::optional<int> section;  ///< from the n-th loading of a tool on, counted from 1
  std::string comment;         ///< from the comment that says this on

  bool whole() const { return !tool && !section && comment.empty(); }
};
/// "T2", "section 3", "from (FINISH)"; empty for the whole program.
std::string to_text(const ProgramPart& part);

/// The part of a stage's program that a stage takes while the rotary axes stand still: which of its
/// parts it is, and what leads to it. Or all of it, where it cuts while they turn.
struct StagePiece {
  std::string stage;  ///< the one that the job states
  model::SteadyRange range;
  std::size_t number = 1, count = 1;
  bool cuts = true;             ///< some motion of it is no rapid
  bool stage_cuts = true;       ///< some stretch of the stage does
  std::string angles;           ///< "A90C45"
  verifier::GateLimits limits;  ///< of the stage
  /// Of a stage that cuts while its axes turn: every turn of it. It is the whole stage then, in the
  /// setup that the job states, and `range` has no turns.
  std::vector<model::AxisTurn> turning = {};

  bool turns_while_cutting() const { return !turning.empty(); }
};
/// "stretch 2 of 3, A90C45".
std::string to_text(const StagePiece& piece);

/// One stage of a job: either planned here (`plan`) or read from a program.
struct JobStage {
  std::string name;
  model::Cutter cutter;
  std::optional<StagePlan> plan;
  std::filesystem::path program;  ///< where `plan` is empty
  std::string program_as_stated;  ///< as the job or the command line names it
  ProgramPart part;
  std::optional<StagePiece> piece;       ///< of a program that turns rotary axes
  std::size_t setup = 0;                 ///< index among the job's setups
  std::optional<int> tool_number;        ///< T of `cutter`; empty: whatever number the program says
  std::optional<double> tool_length_mm;  ///< from the gauge line to the tip, where it is stated
  double allowance_mm = 0;  ///< material the stage must leave, along the surface normal
  verifier::GateLimits limits;
};
/// Whether a stage is a stretch that only brings its tool to where another stretch of its program
/// begins. Of a program that never cuts none is: it answers for every way in which its tool stood.
bool only_positions(const JobStage& stage);

/// A setup of the job.
struct JobSetup {
  model::Setup setup;
  /// The machine with this setup's work offsets; empty: as [machine] has it.
  std::optional<model::MachineSetup> machine;
  /// Of a setup that rotary axes make of another one of the job: which, and where they stand.
  struct Turned {
    std::size_t of = 0;
    model::RotaryAngles angles_deg{};
  };
  std::optional<Turned> turned;
};

/// What turns a fixture with it on a machine with rotary axes, or carries it with the tool.
struct FixtureMount {
  enum class Kind { part, axis, machine, spindle, head };
  /// All tables, one of them with what carries it, nothing; the spindle, or an axis of the head
  /// with what carries it.
  Kind kind = Kind::part;
  std::optional<char> axis;  ///< of `axis` and `head`

  /// Whether it goes with the tool: its mesh's zero is then the spindle's gauge point.
  bool with_tool() const { return kind == Kind::spindle || kind == Kind::head; }
};

/// A mesh that nothing of the tool may touch.
struct JobFixture {
  std::string name;
  std::filesystem::path file;
  std::string file_as_stated;
  model::Vec3 translate_mm;
  /// Where it stands, in that setup's frame; empty: in all.
  std::optional<std::size_t> setup = std::nullopt;
  FixtureMount mount = {};
  model::Pose turned = {};  ///< of a view: how it stands there, after the shift
};

/// How programs of planned stages are written.
struct Post {
  model::Dialect dialect = model::Dialect::linuxcnc;
  int decimals = 4;
  std::optional<double> arc_tolerance_mm;  ///< empty: no arcs
  bool line_numbers = false;
  bool cl_data = false;  ///< toolpath.apt too
};

/// A length that divides the part or is measured on it: beyond the part's extent it says nothing.
struct PartLength {
  std::string what;  ///< "\"step\" in [[stage]]"
  double mm = 0;
  model::SourcePlace place;
};

/// What a design is given as: its limit surface, or its facets, is the truth.
enum class DesignKind { cage, mesh };

/// A file that a job names.
struct JobFile {
  enum class Role { job, cage, mesh, stock, program, fixture, tool_table };
  Role role = Role::job;
  std::filesystem::path path;
  std::string as_stated;
};

/// The design that stages are measured against: a cage or a mesh.
struct JobDesign {
  DesignKind kind = DesignKind::cage;
  std::filesystem::path file;
  std::string as_stated;
  double precision_mm = 0.01;  ///< bound on the chord error of the engine's limit mesh
  model::Placement placement;
};

/// A job as the file states it, defaults filled in; paths are resolved against the job file.
struct Job {
  std::string name;
  /// Empty: programs are cut, and nothing is measured against a surface; no stage is planned then
  /// and none has limits or an allowance.
  std::optional<JobDesign> design;
  model::Stock stock;
  double rapid_mm_min = 5000;
  double clearance_mm = 5;                   ///< height of rapids above the stock
  std::optional<double> acceleration_mm_s2;  ///< empty: speeds change at once
  double junction_deviation_mm = 0.01;       ///< how far a corner may be rounded off
  Post post;
  model::MachineSetup machine;          ///< what programs take from the machine
  model::RigidPlacement program_frame;  ///< the programs' work frame (G54) in the cage's frame
  std::vector<JobSetup> setups = {{}};  ///< one without a name where the job states none
  /// Of a view of the job (inputs/setup_view.h): the setup in whose frame everything lies and whose
  /// stages alone count. Empty: the part's frame.
  std::optional<std::size_t> at_setup;
  std::vector<JobStage> stages;
  std::optional<double> voxel_mm;       ///< empty: "auto"
  std::optional<double> resolution_mm;  ///< empty: "auto"
  bool pictures = true;
  reports::StockSurfaceFile stock_surface = reports::StockSurfaceFile::cut;
  std::optional<model::Box3> travel_mm;        ///< of the tip; infinite where an axis has no limit
  double near_miss_mm = 0;                     ///< 0: near misses are not looked for
  std::optional<double> contact_tolerance_mm;  ///< empty: not stated
  /// What is not known of tools and zero; empty: they are taken as stated.
  std::optional<model::Tolerances> tolerances;
  bool finds_margin = true;  ///< how far the tolerances could grow
  std::vector<JobFixture> fixtures;
  std::optional<reports::PublishedFigures> published;
  /// Keys that the command line sets, `key=value`, in its order.
  std::vector<std::string> overrides;
  /// What the job was read from and is named nowhere else here: job file, stock, tool table.
  std::vector<JobFile> sources;
  std::vector<PartLength> part_lengths;  ///< as far as they are stated
  std::optional<PartLength> stated_voxel;
  /// Values that the job left to a default, in words, for the report's assumptions.
  std::vector<std::string> defaulted;
};

/// Whether the job says how the part lies for each stage.
inline bool has_setups(const Job& job) {
  return !job.setups.front().setup.name.empty();
}

/// Share of the feed at which the cutter plunges where the job says nothing.
inline constexpr double kDefaultPlungeShare = 1.0 / 3.0;

}  // namespace limitgauge::app
