#include "app/run_inputs.h"

#include <sstream>
#include <stdexcept>

#include "engine/model/cage_obj.h"
#include "engine/model/error.h"
#include "engine/model/mesh_reader.h"
#include "engine/model/program_path.h"
#include "engine/model/text_file.h"

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

ForeignPath load_program(const JobStage& stage, double resolution_mm) {
  ForeignPath foreign;
  foreign.text = model::read_text_file(stage.program);
  std::istringstream in(foreign.text);
  const model::Program program = model::read_program(in, stage.program.string());
  foreign.path = model::to_toolpath(program, chord_error_mm(resolution_mm));
  if (foreign.path.moves.empty()) {
    throw model::InputError({stage.program.string(), 0, 0}, "the program moves nothing",
                            "moves that name every axis once");
  }
  for (const model::IgnoredWord& word : program.ignored) {
    foreign.ignored_words.push_back(std::to_string(word.line) + ": " + word.word);
  }
  return foreign;
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

RunInputs load_inputs(const Job& job) {
  model::Cage cage = load_cage(job);
  verifier::ReferenceSurface surface = make_surface(job, cage);
  Settings settings = choose_settings(job, surface.bounding_box());
  RunInputs inputs{
      std::move(cage), std::move(surface), std::move(settings), load_fixtures(job), {}};
  for (std::size_t i = 0; i < job.stages.size(); ++i) {
    const JobStage& stage = job.stages[i];
    if (stage.plan) {
      inputs.programs.emplace_back();
    } else {
      inputs.programs.emplace_back(load_program(stage, inputs.settings.resolution_mm[i]));
    }
  }
  return inputs;
}

}  // namespace limitgauge::app
