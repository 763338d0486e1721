#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/strategy/stage_path.h"
#include "model/gcode/program_path.h"
#include "model/machine/machine_setup.h"
#include "model/part/cage.h"
#include "model/part/fixture.h"
#include "model/part/setup.h"
#include "model/part/tolerances.h"
#include "reports/page/path_view.h"
#include "reports/page/stock_view.h"
#include "reports/record/process_limits.h"
#include "reports/run/published.h"
#include "simulator/instrument/dexel_agreement.h"
#include "simulator/instrument/dexel_stock.h"
#include "simulator/process/finding.h"
#include "simulator/stock/stock_model.h"
#include "verifier/gate/deviation.h"
#include "verifier/surface/surface_rules.h"
#include "witness/agreement.h"

namespace limitgauge::reports {

/// The pictures of one stage as PNG bytes; empty where there is nothing to show.
struct StagePictures {
  std::string deviation_png;    ///< error map from +Z with colour bar and worst places, on white
  std::string perspective_png;  ///< the error map in perspective, likewise
  std::string stock_png;        ///< the cut stock in parallel projection, transparent ground
};

/// The stock's surface as stock.vtp has it: closed, manifold, its vertices on the exact surface.
struct StockSurfaceFigures {
  std::size_t vertices = 0, triangles = 0;
  double voxel_mm = 0;  ///< of the grid that it was taken from; coarser where memory is short
  std::size_t unmoved_vertices = 0;  ///< that could not be put onto the exact surface
};

inline constexpr int kPatchesOfTriangle = 3;

/// What is known of a design that is a mesh.
struct MeshDesign {
  std::vector<std::size_t> numbers;   ///< of its triangles in the file, from 0; three patches each
  std::size_t dropped_triangles = 0;  ///< with two corners in one point

  /// As people count, from 1.
  std::size_t triangle_of(int patch) const {
    return numbers[std::size_t(patch) / kPatchesOfTriangle] + 1;
  }
};

/// The design surface's part of result.json.
struct SurfaceResult {
  std::string cage;                ///< file of the cage, or of the mesh, as the job states it
  std::optional<MeshDesign> mesh;  ///< the design is a mesh: its facets are the surface
  model::CageSummary summary;
  verifier::SurfaceRules rules;
  model::Box3 bbox_mm;  ///< of the limit surface, exact
  double area_mm2 = 0;
  witness::Agreement witness;  ///< of the reference surface with another evaluator of the cage
  int depth_min = 0, depth_max = 0;
  std::vector<int> depths;  ///< of the finish model, one a patch; empty where none was built
  int sampling_interval_min = 1, sampling_interval_max = 1;
  double seconds = 0;
  std::size_t memory_bytes = 0;
  /// Of CELL's control points in single precision: as the paper counts them, and as allocated.
  std::size_t cell_bytes_counted = 0, cell_bytes_allocated = 0;
};

/// What a stage that was run has left.
struct StageRun {
  std::shared_ptr<const model::Toolpath> path;
  std::shared_ptr<const model::ToolAxes> axes;  ///< of a path that turns its tool; else null
  /// How a planned tool leans along its rows: a tilt that was left to the program too.
  struct Lean {
    double lead_deg = 0, tilt_deg = 0;
    bool from_surface = false;
  };
  std::optional<Lean> lean;
  int planes = 0;
  int sampling_interval_min = 1, sampling_interval_max = 1;
  std::vector<int> sampling_intervals;  ///< one a patch
  double cut_length_mm = 0, rapid_length_mm = 0, machining_time_s = 0;
  double plan_seconds = 0;
  std::size_t path_memory_bytes = 0;
  std::shared_ptr<const std::string> program_text;  ///< what stands in toolpath.ngc
  std::vector<std::string> ignored_words;  ///< "line: word" of auxiliaries in a foreign program

  double voxel_mm = 0, removed_volume_mm3 = 0, simulation_seconds = 0;
  std::size_t tiles = 0;  ///< that the stock was worked out in; 0: as one whole
  std::size_t peak_memory_bytes = 0;
  std::optional<StockSurfaceFigures> surface;  ///< once the stage's files are written
  std::optional<simulator::StockModel> stock;  ///< let go once its files are written
  /// How the frame that `stock` lies in lies in the part's: that of the stage's setup, or of one
  /// before it where a stage passed the stock by.
  model::Pose stock_to_part;
  std::vector<model::Fixture> fixtures;  ///< that stand still about the part, in the stage's frame
  std::vector<std::string> moving_fixtures;   ///< names of those that do not
  std::vector<simulator::Finding> process;    ///< in the order of moves
  simulator::StockAgreement agreement;        ///< of the two stock models
  simulator::Removal removal;                 ///< its moves are let go with the stock
  std::optional<page::PathView> path_view;    ///< once the stage's files are written
  std::optional<page::StockView> stock_view;  ///< likewise, of a run without a design

  /// Empty where nothing is measured against a design.
  std::optional<verifier::StageDeviation> deviation;
};

/// One stage as asked for and as it came out. A stage that was not run has only its request part.
struct StageResult {
  std::string name, tool;
  /// Where the stage was cut. `ran->path` and the program are in its frame; findings and the
  /// deviation field are in the part's.
  model::Setup setup;
  model::Cutter cutter;
  std::string strategy;  ///< empty when `program` names a file
  std::string program;
  std::string program_part;  ///< "T2", "section 3", "from (FINISH)"; empty: the whole program
  /// Of a program that turns rotary axes: the stretch of it that was cut while they stood still.
  struct Stretch {
    std::string stage;  ///< the job's
    std::size_t number = 1, count = 1;
    std::string axes;  ///< where they stood: "A90C45"
  };
  std::optional<Stretch> stretch;
  std::optional<double> allowance_mm;  ///< empty where there is no design
  double step_mm = 0, tolerance_mm = 0;
  verifier::GateLimits limits;
  verifier::GateDecision decision;

  std::optional<StageRun> ran;
  std::optional<StagePictures> pictures;  ///< empty: a page without pictures
  double seconds = 0;
  /// recorded_stage() of an earlier run whose stage this is. `ran` then has the path, its program
  /// and its sampling alone: result.json is all that can be written of it.
  std::shared_ptr<const std::string> recorded;

  /// The decision's; of a stage that was not run, just that.
  verifier::Verdict verdict() const { return ran ? decision.verdict : verifier::Verdict::not_run; }
};

/// A file that the run read.
struct InputFile {
  std::string role;  ///< "job", "cage", "stock", "program", "fixture", "tool table"
  std::string file;  ///< as the job or the command line states it
  std::uint64_t bytes = 0;
  std::string sha256;  ///< 64 lower-case hexadecimal digits
};

/// Everything a report shows.
struct RunResult {
  std::string job;      ///< the job's name
  std::string label;    ///< what the user calls this run; or empty
  std::string created;  ///< ISO 8601, UTC
  std::string version;
  std::vector<std::string> overrides;  ///< of the job's keys, by the command line: `key=value`
  unsigned threads = 1;
  verifier::Verdict verdict = verifier::Verdict::not_run;
  model::Stock raw_stock;
  std::optional<SurfaceResult> surface;  ///< empty: the run is about a program without a design
  model::RigidPlacement program_frame;   ///< programs' work frame in the cage's
  model::MachineSetup machine;           ///< what programs were told of the machine
  std::optional<model::ProgramStart> program_start;  ///< where a stage is a program
  /// What is not known of tools and zero; empty: they are taken as stated.
  std::optional<model::Tolerances> tolerances;
  record::ProcessLimits process_limits;
  std::vector<model::Setup> setups;  ///< as the job states them; empty: the part is never turned
  std::vector<StageResult> stages;
  std::vector<std::string>
      assumptions;  ///< stated in the report: straight rapids, start unknown, ...
  std::optional<PublishedFigures> published;
  std::vector<InputFile> inputs;  ///< each file once, in the order of the job

  /// The mesh that the run is measured against; null of a cage, and without a design.
  const MeshDesign* mesh_design() const {
    return surface && surface->mesh ? &*surface->mesh : nullptr;
  }
};

}  // namespace limitgauge::reports
