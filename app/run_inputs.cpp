#include "app/run_inputs.h"

#include <stdexcept>

#include "app/input_checksums.h"
#include "engine/model/cage_obj.h"
#include "engine/model/error.h"
#include "engine/model/mesh_reader.h"

namespace limitgauge::app {
namespace {

model::Cage load_cage(const Job& job) {
  return placed(model::read_cage_obj(job.cage), job.placement);
}

verifier::ReferenceSurface make_surface(const Job& job, const model::Cage& cage) {
  try {
    verifier::ReferenceSurface surface(cage);
    if (surface.bounding_box().empty()) {
      throw model::InputError({job.cage.string(), 0, 0}, "the cage has no limit surface",
                              "at least one face that is no hole");
    }
    return surface;
  } catch (const std::invalid_argument& error) {
    throw model::InputError({job.cage.string(), 0, 0}, error.what(), "a two-manifold cage");
  }
}

model::Fixture load_fixture(const JobFixture& asked) {
  model::TriangleMesh mesh = model::read_triangle_mesh(asked.file);
  for (model::Vec3& vertex : mesh.vertices) vertex += asked.translate_mm;
  return {asked.name, asked.file_as_stated,
          std::make_shared<const model::TriangleMesh>(std::move(mesh))};
}

std::vector<model::Fixture> load_fixtures(const Job& job) {
  std::vector<model::Fixture> fixtures;
  for (const JobFixture& asked : job.fixtures) fixtures.push_back(load_fixture(asked));
  return fixtures;
}

}  // namespace

JobSurface load_surface(const Job& job) {
  model::Cage cage = load_cage(job);
  verifier::ReferenceSurface surface = make_surface(job, cage);
  return {std::move(cage), std::move(surface)};
}

RunInputs load_inputs(const Job& job) {
  return load_inputs(job, load_surface(job));
}

RunInputs load_inputs(const Job& job, JobSurface surface) {
  Settings settings = choose_settings(job, surface.surface.bounding_box());
  std::vector<model::Fixture> fixtures = load_fixtures(job);
  auto programs = load_programs(job, settings, fixtures);
  return {std::move(surface.cage), std::move(surface.surface), std::move(settings),
          std::move(fixtures),     std::move(programs),        input_checksums(job)};
}

}  // namespace limitgauge::app
