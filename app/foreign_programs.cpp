#include "app/foreign_programs.h"

#include <algorithm>
#include <sstream>

#include "app/program_parts.h"
#include "engine/model/error.h"
#include "engine/model/text_file.h"

namespace limitgauge::app {
namespace {

/// The stages that take parts of one file, by their index; one that takes all of it stands alone.
using Group = std::vector<std::size_t>;

std::vector<Group> groups_of(const Job& job) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < job.stages.size(); ++i) {
    if (job.stages[i].plan) continue;
    const auto same = [&](const Group& group) {
      const JobStage &first = job.stages[group.front()], &second = job.stages[i];
      return first.program == second.program && !(first.part.whole() && second.part.whole());
    };
    const auto known = std::find_if(groups.begin(), groups.end(), same);
    if (known == groups.end()) {
      groups.push_back({i});
    } else {
      known->push_back(i);
    }
  }
  return groups;
}

/// Above stock, fixtures and everything that the program reaches, by the job's clearance; no higher
/// than the machine can go.
double park_height_mm(const Job& job, const std::vector<model::Fixture>& fixtures,
                      const model::Program& program, const model::RigidPlacement& placement) {
  double top = std::max(model::bounding_box(job.stock).high.z, highest_z_mm(program, placement));
  for (const model::Fixture& fixture : fixtures)
    for (const model::Vec3& vertex : fixture.mesh->vertices) top = std::max(top, vertex.z);
  const double wanted = top + job.clearance_mm;
  return job.travel_mm ? std::max(top, std::min(wanted, job.travel_mm->high.z)) : wanted;
}

class GroupReader {
 public:
  GroupReader(const Job& job, const Settings& settings, const std::vector<model::Fixture>& fixtures,
              const Group& group);
  ForeignPath path_of(std::size_t index) const;

 private:
  double start_shift_mm(std::size_t first) const;
  const JobStage& stage(std::size_t index) const { return job_.stages[group_[index]]; }

  const Job& job_;
  const Settings& settings_;
  const Group& group_;
  std::string file_, text_;
  model::Program program_;
  std::vector<MotionRange> ranges_;
  model::PathOptions options_;
};

GroupReader::GroupReader(const Job& job, const Settings& settings,
                         const std::vector<model::Fixture>& fixtures, const Group& group)
    : job_(job), settings_(settings), group_(group), file_(stage(0).program.string()) {
  text_ = model::read_text_file(stage(0).program);
  std::istringstream in(text_);
  const model::MachineSetup machine = machine_for(job, stage(0).cutter);
  program_ = model::read_program(in, file_, machine);
  std::vector<const JobStage*> stages;
  for (const std::size_t i : group) stages.push_back(&job.stages[i]);
  ranges_ = assign_parts(program_, file_, stages);
  options_.machine_in_part = model::machine_in_part(
      job.program_frame, machine.work_offsets.front().value_or(model::WorkOffset()));
  // What is made of a path, its copy included, takes several times its own room.
  constexpr double kRoom = 8;
  options_.most_moves =
      static_cast<double>(settings.memory_limit_bytes) / (kRoom * sizeof(model::Move));
  options_.park_z_mm = park_height_mm(job, fixtures, program_, options_.machine_in_part);
}

/// A tool change moves nothing: the tip of a longer tool comes to stand lower. Without lengths each
/// tool is taken to have been set to where the one before stood.
double GroupReader::start_shift_mm(std::size_t first) const {
  const auto length_of = [this](int number) -> std::optional<double> {
    for (const model::ToolEntry& tool : job_.machine.tools)
      if (tool.number == number) return tool.length_mm;
    return std::nullopt;
  };
  const std::vector<model::ToolChange> changes = loadings(program_);
  for (std::size_t i = 1; i < changes.size(); ++i) {
    if (changes[i].motion != first) continue;
    const auto before = length_of(changes[i - 1].tool), after = length_of(changes[i].tool);
    if (before && after) return *before - *after;
  }
  return 0;
}

ForeignPath GroupReader::path_of(std::size_t index) const {
  model::PathOptions options = options_;
  options.chord_error_mm = chord_error_mm(settings_.resolution_mm[group_[index]]);
  options.first = ranges_[index].first, options.last = ranges_[index].last;
  options.start_shift_z_mm = start_shift_mm(options.first);
  ForeignPath foreign;
  foreign.path = to_toolpath(program_, options);
  if (foreign.path.moves.empty())
    throw model::InputError(
        {file_, 0, 0},
        "the program moves nothing" +
            (stage(index).part.whole() ? std::string() : " in stage " + stage(index).name),
        "moves that name every axis once");
  for (const model::IgnoredWord& word : program_.ignored)
    foreign.ignored_words.push_back(std::to_string(word.line) + ": " + word.word);
  for (const std::string& said : program_.assumed)
    foreign.assumed.push_back(stage(index).program_as_stated + ", " + said);
  foreign.text = text_;
  return foreign;
}

}  // namespace

model::MachineSetup machine_for(const Job& job, const model::Cutter& cutter) {
  model::MachineSetup machine = job.machine;
  if (machine.tools.empty()) machine.only_tool = {0, std::nullopt, cutter.diameter_mm};
  return machine;
}

std::vector<std::optional<ForeignPath>> load_programs(const Job& job, const Settings& settings,
                                                      const std::vector<model::Fixture>& fixtures) {
  std::vector<std::optional<ForeignPath>> programs(job.stages.size());
  for (const Group& group : groups_of(job)) {
    const GroupReader reader(job, settings, fixtures, group);
    for (std::size_t i = 0; i < group.size(); ++i) programs[group[i]] = reader.path_of(i);
  }
  return programs;
}

}  // namespace limitgauge::app
