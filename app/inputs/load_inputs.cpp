#include "app/inputs/run_inputs.h"

#include <algorithm>
#include <stdexcept>

#include "app/inputs/cage_fold.h"
#include "app/inputs/input_checksums.h"
#include "app/inputs/mesh_target.h"
#include "app/inputs/part_fit.h"
#include "app/inputs/run_forecast.h"
#include "app/inputs/setup_view.h"
#include "app/inputs/surface_witness.h"
#include "app/tolerance.h"
#include "model/base/coordinate_limit.h"
#include "model/base/error.h"
#include "model/base/text_file.h"
#include "model/mesh/mesh_reader.h"
#include "model/mesh/obj_lexer.h"
#include "model/part/cage_obj.h"

namespace limitgauge::app {
namespace {

/// Where the `index`th `v` or `f` stands in an OBJ file that has been read without complaint.
model::SourcePlace place_of(const std::filesystem::path& file, std::string_view statement,
                            std::size_t index) {
  const std::string text = model::read_text_file(file);
  model::ObjLexer lexer(text, file.string());
  for (; lexer.next_statement(); lexer.skip_statement())
    if (const model::ObjWord word = lexer.word(); word.text == statement && index-- == 0)
      return lexer.place(word);
  return {file.string(), 0, 0};
}

/// Placed; a vertex too far out is an error at its line.
model::Cage load_cage(const JobDesign& design) {
  model::Cage cage = placed(model::read_cage_obj(design.file), design.placement);
  for (std::size_t i = 0; i < cage.vertices.size(); ++i)
    if (!model::is_near(cage.vertices[i]))
      throw model::InputError(place_of(design.file, "v", i),
                              "the cage has a vertex at " + model::farthest_words(cage.vertices[i]),
                              model::kFarthestExpected);
  return cage;
}

/// Its distances would all be right and mean nothing, and to prove that takes without end.
void refuse_folded(const JobDesign& design, const model::Cage& cage) {
  const auto folded = folded_faces(cage);
  if (!folded) return;
  const auto [first, second] = *folded;
  throw model::InputError(place_of(design.file, "f", static_cast<std::size_t>(second)),
                          "face " + std::to_string(second + 1) + " of the cage lies back on " +
                              (first == second ? "itself" : "face " + std::to_string(first + 1)) +
                              ": the folded surface has no area to be cut from one side",
                          "faces that do not lie on each other");
}

[[noreturn]] void refuse_empty(const JobDesign& design) {
  throw model::InputError({design.file.string(), 0, 0},
                          "the limit surface has no area: there is nothing to measure",
                          "a cage whose points lie neither in one place nor on one line");
}

/// Before anything is built on it: a surface within one line has cells without a normal.
bool lies_on_a_line(const model::Cage& cage) {
  if (cage.face_corners.empty()) return false;
  const auto at = [&](model::Index corner) {
    return cage.vertices[static_cast<std::size_t>(corner)];
  };
  const model::Vec3 from = at(cage.face_corners.front());
  model::Vec3 along;
  for (const model::Index corner : cage.face_corners)
    if (length(at(corner) - from) > length(along)) along = at(corner) - from;
  const double extent_mm = length(along);
  if (extent_mm <= kLeastExtentMm) return true;
  double off_mm = 0;
  for (const model::Index corner : cage.face_corners)
    off_mm = std::max(off_mm, length(cross(at(corner) - from, along)) / extent_mm);
  return off_mm <= kLeastShare * extent_mm;
}

bool has_area(const verifier::ReferenceSurface& surface) {
  const double extent_mm = length(surface.bounding_box().size());
  return surface.area_mm2() > kLeastShare * extent_mm * extent_mm;
}

verifier::ReferenceSurface make_surface(const JobDesign& design, const model::Cage& cage,
                                        const model::RunControl& control) {
  if (lies_on_a_line(cage)) refuse_empty(design);
  refuse_folded(design, cage);
  try {
    verifier::ReferenceSurface surface(cage, control);
    if (surface.bounding_box().empty()) {
      throw model::InputError({design.file.string(), 0, 0}, "the cage has no limit surface",
                              "at least one face that is no hole");
    }
    if (!has_area(surface)) refuse_empty(design);
    return surface;
  } catch (const std::invalid_argument& error) {
    throw model::InputError({design.file.string(), 0, 0}, error.what(), "a two-manifold cage");
  }
}

model::Fixture load_fixture(const JobFixture& asked) {
  model::TriangleMesh mesh = model::read_triangle_mesh(asked.file);
  for (model::Vec3& vertex : mesh.vertices)
    vertex = asked.turned.point(vertex + asked.translate_mm);
  if (const model::Box3 box = bounding_box(mesh); !model::is_near(box))
    throw model::InputError({asked.file.string(), 0, 0},
                            "the fixture reaches to " + model::farthest_words(box),
                            model::kFarthestExpected);
  return {asked.name, asked.file_as_stated,
          std::make_shared<const model::TriangleMesh>(std::move(mesh))};
}

/// Those that go with the tool, or those that do not.
std::vector<model::Fixture> load_fixtures(const Job& job, bool with_tool) {
  std::vector<model::Fixture> fixtures;
  for (const JobFixture& asked : job.fixtures)
    if (asked.mount.with_tool() == with_tool) fixtures.push_back(load_fixture(asked));
  return fixtures;
}

}  // namespace

JobSurface load_surface(const Job& job, const model::RunControl& control) {
  if (job.design.value().kind == DesignKind::mesh) return load_mesh_target(job, control);
  const JobDesign& design = job.design.value();
  model::Cage cage = load_cage(design);
  require_fit(job, &cage);
  verifier::ReferenceSurface surface = make_surface(design, cage, control);
  control.check();
  witness::Agreement witness = witnessed(cage, surface);
  return {std::move(cage), std::move(surface), std::move(witness), std::nullopt};
}

RunInputs load_inputs(const Job& job, const RunTerms& terms, const model::RunControl& control) {
  auto design = job.design ? std::optional(load_surface(job, control)) : std::nullopt;
  if (has_setups(job)) return load_in_setups(job, terms, std::move(design), control);
  return load_inputs(job, terms, std::move(design));
}

RunInputs load_inputs(const Job& job, const RunTerms& terms, std::optional<JobSurface> design) {
  if (has_setups(job) && !job.at_setup) return load_in_setups(job, terms, std::move(design), {});
  // The surface may come from another job of the same cage.
  require_fit(job, design ? &design->cage : nullptr);
  const model::Box3 box = design ? design->surface.bounding_box() : model::Box3();
  Settings settings = choose_settings(job, box, terms.memory_limit_bytes);
  std::vector<model::Fixture> fixtures = load_fixtures(job, false);
  auto programs = load_programs(job, settings, fixtures, box);
  if (!job.at_setup) tell_offsets_left(programs);
  settings.stock_limit_bytes =
      stock_limit_bytes(scale_of(job, design ? &design->surface : nullptr, programs, terms));
  return {std::move(design),   std::move(settings),      terms,
          std::move(fixtures), load_fixtures(job, true), std::move(programs),
          input_checksums(job)};
}

}  // namespace limitgauge::app
