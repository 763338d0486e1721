#include "app/inputs/run_forecast.h"

#include <algorithm>
#include <cmath>

#include "model/base/error.h"
#include "model/base/memory.h"
#include "verifier/cells/surface_cells.h"
#include "verifier/cutter/chord_pieces.h"

namespace limitgauge::app {
namespace {

constexpr double kMib = 1024.0 * 1024.0;

// Measured on the fixtures, x86-64 and glibc, with two threads.

/// The program, its libraries and what every job takes.
constexpr double kProcessBytes = 60 * kMib;
/// Parts of cells that the verifier divides: their number is bounded, and goes by how the surface
/// bends and not by any figure of the job. 1 to 50 MiB on the fixtures.
constexpr double kCellsBytes = 10 * kMib;
/// Of a cell that the surface is cut into to begin with, with what a search for closest points
/// needs.
constexpr double kCellBytes = 1000;
/// Of one about an irregular vertex, where cells grow smaller down to rounding, for each face about
/// it beyond the third: the more there are, the more cells are divided. 1000 to 3000 about wavy
/// stars of valences 6 to 16, hardly any about a dodecahedron's vertices.
constexpr double kVertexCellBytes = 1500;
/// Of a facet of a mesh: three cells, normals between it and its neighbours, samples, each but for
/// the piece itself.
constexpr double kFacetBytes = 9500;
/// Files and pages of a stage; its pictures are drawn few rows at a time, two of them side by
/// side.
constexpr double kFilesBytes = 20 * kMib, kPicturesBytes = 12 * kMib;

/// Of a move: itself, in the sweep's tree (simulator/sweep/sweep_tree.h), and what it removed.
constexpr double kMoveBytes = 32, kTreeBytes = 144, kRemovalBytes = 32;
/// Of a move of a body that the verifier follows, and more while its tree is built
/// (verifier/cutter/removed_space.h).
constexpr double kBodyBytes = 90, kBodyWorkBytes = 48;
/// Of a move in toolpath.vtp, VTK's copy included.
constexpr double kFileMoveBytes = 100;
constexpr double kTextBytes = 25;  ///< of a planned move's line

/// Beside the model: what building it takes.
constexpr double kModelShare = 1.2;
/// Level sets while the stock is cut and read; each stage that is kept has its own.
constexpr double kCutShare = 1.3;
/// The stock's mesh, and VTK's copy of it, as multiples of the level set.
constexpr double kMeshShare = 2.3;

/// Chords of a planned path are about as long as a tolerance allows them on the cutter itself.
double expected_moves(const JobStage& stage, double area_mm2) {
  constexpr double kChord = 3;  // of 8 on a circle: surfaces bend more than the cutter
  const double radius_mm = std::max(stage.cutter.diameter_mm / 2, 0.1);
  const double chord_mm = std::sqrt(kChord * stage.plan->cut.tolerance_mm * radius_mm);
  return area_mm2 / (stage.plan->cut.step_mm * chord_mm);
}

/// The flutes, and the parts above them that are low enough to come near the surface.
double followed_bodies(const model::Cutter& cutter, double stock_height_mm) {
  double bodies = 1, base_mm = cutter.flute_length_mm;
  for (const auto* parts : {&cutter.shank, &cutter.holder})
    for (const model::CylinderPart& part : *parts) {
      if (base_mm < stock_height_mm) ++bodies;
      base_mm += part.length_mm;
    }
  return bodies;
}

/// The pieces that the verifier makes of a program's moves.
double followed_pieces(const std::optional<ForeignPath>& program, double moves) {
  if (!program || program->axes) return moves;
  return static_cast<double>(verifier::ChordPieces(*program->path).count());
}

double stock_share(const RunTerms& terms) {
  return kCutShare + static_cast<double>(terms.kept) + (terms.files ? kMeshShare : 0);
}

double cells_bytes(const RunScale& scale) {
  return scale.cells_bytes ? kCellsBytes + *scale.cells_bytes : 0;
}

double measuring_bytes(const RunScale& scale) {
  if (!scale.cells_bytes) return 0;
  return scale.swept * kBodyBytes + scale.largest_moves * kBodyWorkBytes;
}

double surface_bytes(const verifier::ReferenceSurface& surface) {
  const double facets =
      surface.tree().is_faceted() ? static_cast<double>(surface.patch_count()) / 3 : 0;
  const double radius_mm = verifier::first_cell_radius_mm(surface.tree());
  return static_cast<double>(surface.memory_bytes()) + kFacetBytes * facets +
         kCellBytes * surface.area_mm2() / (radius_mm * radius_mm) +
         kVertexCellBytes * static_cast<double>(surface.tree().bent_pieces_about_vertices());
}

double writing_bytes(const RunScale& scale) {
  if (!scale.terms.files) return 0;
  return kFilesBytes + (scale.pictures ? kPicturesBytes : 0) + scale.largest_moves * kFileMoveBytes;
}

/// Of stages that are kept, the moves are kept as well.
double moves_bytes(const RunScale& scale) {
  const double held = scale.moves * (kMoveBytes + kTreeBytes) + scale.text_bytes;
  return held * (1 + static_cast<double>(scale.terms.kept)) + scale.largest_moves * kRemovalBytes;
}

/// All but the stock. Its mesh is gone when the next stage is measured: files and measuring share
/// their room.
double other_bytes(const RunScale& scale) {
  return kProcessBytes + cells_bytes(scale) + kModelShare * scale.model_bytes + moves_bytes(scale) +
         std::max(measuring_bytes(scale), writing_bytes(scale));
}

}  // namespace

RunScale scale_of(const Job& job, const verifier::ReferenceSurface* surface,
                  const std::vector<std::optional<ForeignPath>>& programs, const RunTerms& terms) {
  RunScale scale;
  scale.pictures = job.pictures;
  scale.terms = terms;
  // Each setup has its own.
  if (surface != nullptr)
    scale.cells_bytes = static_cast<double>(job.setups.size()) * surface_bytes(*surface);
  const double height_mm = model::bounding_box(job.stock).size().z;
  const std::string* text = nullptr;
  for (std::size_t i = 0; i < job.stages.size(); ++i) {
    const JobStage& stage = job.stages[i];
    // Of another setup: load_in_setups counts them all.
    if (!programs[i] && !stage.plan) continue;
    const double moves = programs[i] ? static_cast<double>(programs[i]->path->moves.size())
                                     : expected_moves(stage, surface->area_mm2());
    scale.moves += moves;
    scale.swept += followed_pieces(programs[i], moves) * followed_bodies(stage.cutter, height_mm);
    scale.largest_moves = std::max(scale.largest_moves, moves);
    if (!programs[i]) scale.text_bytes += moves * kTextBytes;
    // Stages that take parts of one program hold one text.
    if (programs[i] && programs[i]->text.get() != text) {
      text = programs[i]->text.get();
      scale.text_bytes += static_cast<double>(text->size());
    }
  }
  return scale;
}

RunScale scale_of(const Job& job, const RunInputs& inputs,
                  const std::optional<engine::surface::FinishModel>& built,
                  const simulator::StockModel& stock) {
  RunScale scale = scale_of(job, inputs.design ? &inputs.design->surface : nullptr, inputs.programs,
                            inputs.terms);
  if (built) scale.model_bytes = static_cast<double>(built->figures().memory_bytes);
  // Tile by tile, as much as there is room for.
  scale.grid_bytes = stock.tiles() == 0 ? static_cast<double>(stock.memory_bytes())
                                        : static_cast<double>(inputs.settings.stock_limit_bytes) -
                                              scale.moves * kTreeBytes;
  return scale;
}

double forecast_bytes(const RunScale& scale) {
  return other_bytes(scale) + stock_share(scale.terms) * scale.grid_bytes;
}

std::size_t stock_limit_bytes(const RunScale& scale) {
  const auto limit = static_cast<double>(scale.terms.memory_limit_bytes);
  const double left = limit - other_bytes(scale);
  if (left > 0)
    return static_cast<std::size_t>(left / stock_share(scale.terms) + scale.moves * kTreeBytes);
  throw model::ResourceError(
      "limitgauge: error: the run does not fit into memory: without its stock it is forecast to "
      "take " +
      model::in_mib(other_bytes(scale)) + ", " +
      (scale.cells_bytes
           ? model::in_mib(*scale.cells_bytes) + " of it for the exact surface and its cells and "
           : std::string()) +
      model::in_mib(moves_bytes(scale)) + " of it for " +
      std::to_string(std::llround(scale.moves)) + " moves; allowed are " + model::in_mib(limit) +
      (scale.pictures ? "; --no-pictures takes less" : "") +
      "; a program of fewer moves, or more memory, would do");
}

}  // namespace limitgauge::app
