#include "app/job/foreign_programs.h"

#include <algorithm>
#include <deque>

#include "app/job/program_parts.h"
#include "app/job/setup_frame.h"
#include "app/job/turning_stage.h"
#include "model/base/coordinate_limit.h"
#include "model/base/error.h"
#include "model/base/memory.h"
#include "model/gcode/text/program_text.h"
#include "model/gcode/turning/turning_path.h"

namespace limitgauge::app {
namespace {

/// The stages that take parts of one file, by their index; one that takes all of it stands alone.
using Group = std::vector<std::size_t>;

std::vector<Group> groups_of(const Job& job) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < job.stages.size(); ++i) {
    if (job.stages[i].plan || (job.at_setup && job.stages[i].setup != *job.at_setup)) continue;
    const auto same = [&](const Group& group) {
      const JobStage &first = job.stages[group.front()], &second = job.stages[i];
      // Stretches of one program are its parts, whatever they belong to.
      const bool alone = first.part.whole() && second.part.whole() && !first.piece;
      return same_program(first, second) && first.piece.has_value() == second.piece.has_value() &&
             !alone;
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

/// What a job's programs share beyond their machine.
struct Surroundings {
  double above_all_mm = 0;  ///< where parked tools stand, in the cage's frame
  model::Box3 around_mm;    ///< stock, part and fixtures
  model::ProgramStart start;
};

/// The program of one group, read, and its parts as paths.
class GroupReader {
 public:
  GroupReader(const Job& job, const Settings& settings, const Group& group);
  const Group& group() const { return group_; }
  const model::Program& program() const { return program_; }
  const std::vector<MotionRange>& ranges() const { return ranges_; }
  double highest_mm() const { return highest_z_mm(program_, options_.machine_in_part); }
  void place(const Surroundings& surroundings);
  ForeignPath path_of(std::size_t index) const;

 private:
  void read(const std::optional<model::Vec3>& assumed_start_mm);
  std::vector<MotionRange> ranges_of_parts() const;
  std::vector<MotionRange> ranges_of_pieces() const;
  bool leans_on_start() const;
  model::Vec3 start_of(const model::ProgramStart& start) const;
  model::ProgramStart start_told() const;
  void stand_still(std::size_t index, model::Toolpath& path) const;
  void make_path(std::size_t index, model::PathOptions options, ForeignPath& foreign) const;
  void require_near(const model::Vec3& tip_mm, std::uint32_t line) const;
  void list_assumed(ForeignPath& foreign, std::size_t index) const;
  std::vector<model::TravelBreach> beyond_travel(std::size_t index) const;
  const JobStage& stage(std::size_t index) const { return job_.stages[group_[index]]; }

  const Job& job_;
  const Settings& settings_;
  const Group& group_;
  std::string file_;
  std::shared_ptr<const std::string> text_;
  model::Program program_;
  std::vector<MotionRange> ranges_;
  model::PathOptions options_;
  model::ProgramStart start_;
};

GroupReader::GroupReader(const Job& job, const Settings& settings, const Group& group)
    : job_(job), settings_(settings), group_(group), file_(stage(0).program.string()) {
  text_ = std::make_shared<const std::string>(model::read_program_text(stage(0).program));
  options_.machine_in_part = machine_in_setup_frame(job);
  options_.kinematics = job.machine.kinematics;
  // What is made of a path takes several times its own room (app/inputs/run_forecast.cpp).
  constexpr double kRoom = 10;
  options_.most_moves =
      static_cast<double>(settings.memory_limit_bytes) / (kRoom * sizeof(model::Move));
  read(model::Vec3());
}

/// Without a start of the job's, from `assumed_start_mm`.
void GroupReader::read(const std::optional<model::Vec3>& assumed_start_mm) {
  model::MachineSetup machine = machine_for(job_, stage(0).cutter);
  machine.start_is_assumed = !machine.start_mm;
  if (machine.start_is_assumed) machine.start_mm = assumed_start_mm;
  program_ = model::read_program_or_name_control(std::string_view(*text_), file_, machine);
  ranges_ = stage(0).piece ? ranges_of_pieces() : ranges_of_parts();
}

std::vector<MotionRange> GroupReader::ranges_of_parts() const {
  // Stages of other setups take their parts too.
  std::vector<const JobStage*> stages;
  std::vector<std::size_t> own;
  for (std::size_t i = 0; i < job_.stages.size(); ++i) {
    const JobStage& other = job_.stages[i];
    const bool is_own = std::find(group_.begin(), group_.end(), i) != group_.end();
    const bool alone = other.part.whole() && stage(0).part.whole();
    if (!is_own && (other.plan || other.piece || alone || !same_program(other, stage(0)))) continue;
    if (is_own) own.push_back(stages.size());
    stages.push_back(&other);
  }
  const std::vector<MotionRange> all = assign_parts(program_, file_, stages);
  std::vector<MotionRange> ranges;
  for (const std::size_t i : own) ranges.push_back(all[i]);
  return ranges;
}

std::vector<MotionRange> GroupReader::ranges_of_pieces() const {
  std::vector<MotionRange> ranges;
  for (const std::size_t i : group_) {
    const model::SteadyRange& range = job_.stages[i].piece->range;
    ranges.push_back({range.first, range.last});
  }
  return ranges;
}

/// Whether some motion ends at a place that depends on where the tip stood before the first line.
bool GroupReader::leans_on_start() const {
  const auto is_said = [](const std::optional<double>& said) { return said.has_value(); };
  return std::any_of(program_.start_said_mm.begin(), program_.start_said_mm.end(), is_said) ||
         std::any_of(program_.motions.begin(), program_.motions.end(),
                     [](const model::Motion& motion) { return !motion.position_known; });
}

/// What the program itself says of its start goes before what is assumed of all.
model::Vec3 GroupReader::start_of(const model::ProgramStart& start) const {
  model::Vec3 at_mm = start.at_mm;
  for (int axis = 0; axis < 3; ++axis)
    at_mm[axis] = program_.start_said_mm[static_cast<std::size_t>(axis)].value_or(at_mm[axis]);
  return at_mm;
}

/// The start as the record has it: the program's own where it says all of it.
model::ProgramStart GroupReader::start_told() const {
  const auto& said = program_.start_said_mm;
  if (!(said[0] && said[1] && said[2])) return start_;
  return {{*said[0], *said[1], *said[2]}, false};
}

void GroupReader::place(const Surroundings& surroundings) {
  start_ = surroundings.start;
  const model::Vec3 start_mm = start_of(start_);
  if (start_.assumed && leans_on_start()) read(start_mm);
  const model::WorkOffset g54 = job_.machine.work_offsets.front().value_or(model::WorkOffset());
  options_.start_mm = model::RigidPlacement{g54.rotation_deg, g54.origin_mm}(start_mm);
  options_.park_z_mm = surroundings.above_all_mm;
  options_.around_mm = surroundings.around_mm;
}

void GroupReader::require_near(const model::Vec3& tip_mm, std::uint32_t line) const {
  if (model::is_near(tip_mm)) return;
  throw model::InputError({file_, static_cast<int>(line), 0},
                          "the tip moves to " + model::farthest_words(tip_mm) +
                              " in the frame of the " + (job_.design ? "cage" : "stock"),
                          model::kFarthestExpected);
}

/// A program that ends with turns of its axes leaves the tool where they have brought it.
void GroupReader::stand_still(std::size_t index, model::Toolpath& path) const {
  const auto& piece = stage(index).piece;
  if (!path.moves.empty() || !piece || piece->range.turns.empty()) return;
  path.moves.emplace_back(path.start, 0.0F, piece->range.turns.back().line, model::MoveKind::rapid);
}

/// The path, and how the tool stands along it where it turns.
void GroupReader::make_path(std::size_t index, model::PathOptions options,
                            ForeignPath& foreign) const {
  const auto& piece = stage(index).piece;
  if (program_.axes || (piece && piece->turns_while_cutting())) {
    require_turning_tool(job_, stage(index));
    options.reach_mm = reach_mm(stage(index).cutter);
    model::TurningPath made = to_turning_path(program_, options);
    foreign.path = std::make_shared<const model::Toolpath>(std::move(made.path));
    foreign.axes = std::make_shared<const model::ToolAxes>(std::move(made.axes));
    return;
  }
  model::Toolpath path = to_toolpath(program_, options);
  stand_still(index, path);
  foreign.path = std::make_shared<const model::Toolpath>(std::move(path));
}

std::vector<model::TravelBreach> GroupReader::beyond_travel(std::size_t index) const {
  const JobStage& asked = stage(index);
  if (!job_.travel_mm || !asked.piece) return {};
  const model::SteadyRange& range = asked.piece->range;
  return model::beyond_travel(
      program_,
      {*job_.machine.kinematics, *job_.travel_mm, pose_of(options_.machine_in_part),
       options_.start_mm.value(), asked.tool_length_mm.value_or(0)},
      range.turns.empty() ? range.first : range.turns.front().motion, range.last);
}

ForeignPath GroupReader::path_of(std::size_t index) const {
  model::PathOptions options = options_;
  options.chord_error_mm = settings_.chord_error_mm[group_[index]];
  options.first = ranges_[index].first, options.last = ranges_[index].last;
  ForeignPath foreign;
  // Ends first: an arc to somewhere far away would have more chords than there is room for.
  for (std::size_t i = options.first; i < options.last && program_.frames.empty(); ++i)
    require_near(options.machine_in_part(program_.motions[i].to), program_.motions[i].line);
  make_path(index, options, foreign);
  for (const model::Move& move : foreign.path->moves) require_near(move.to, move.line);
  if (foreign.path->moves.empty())
    throw model::InputError(
        {file_, 0, 0},
        "the program moves nothing" +
            (stage(index).part.whole() ? std::string() : " in stage " + stage(index).name),
        "motions");
  for (const model::IgnoredWord& word : program_.ignored)
    foreign.ignored_words.push_back(std::to_string(word.line) + ": " + word.word);
  list_assumed(foreign, index);
  foreign.beyond_travel = beyond_travel(index);
  if (!program_.has_end)
    foreign.unended = stage(index).program_as_stated + " " + missing_end_words(program_);
  foreign.file = stage(index).program_as_stated;
  foreign.offsets_left = program_.offsets_left;
  foreign.start = start_told();
  foreign.text = text_;
  return foreign;
}

void GroupReader::list_assumed(ForeignPath& foreign, std::size_t index) const {
  const std::string head = stage(index).program_as_stated + ", ";
  for (const std::string& said : program_.assumed) foreign.assumed.push_back(head + said);
  if (foreign.axes) foreign.assumed.push_back(head + kTurnsInPlace);
  const auto leaning = std::find_if(
      program_.motions.begin(), program_.motions.end(), [](const model::Motion& motion) {
        return !motion.position_known && motion.kind != model::MotionKind::rapid;
      });
  if (leaning != program_.motions.end())
    foreign.assumed.push_back(head + "line " + std::to_string(leaning->line) +
                              ": cuts before X, Y and Z have all been named; the others are taken "
                              "to stand where the program starts");
}

/// What a program is read with while nothing is made of it yet.
Settings settings_for_reading(const Job& job) {
  Settings settings;
  settings.chord_error_mm.assign(job.stages.size(), 0);
  settings.memory_limit_bytes = model::memory_limit_bytes();
  return settings;
}

model::Box3 box_around(const Job& job, const std::vector<model::Fixture>& fixtures,
                       const model::Box3& part) {
  model::Box3 box = model::bounding_box(job.stock);
  box.add(part);
  for (const model::Fixture& fixture : fixtures) box.add(bounding_box(*fixture.mesh));
  return box;
}

/// Above stock, part, fixtures and everything that the programs reach and start at, by the job's
/// clearance; no higher than the machine can go.
double above_everything_mm(const Job& job, const std::vector<model::Fixture>& fixtures,
                           const model::Box3& part, const std::deque<GroupReader>& readers) {
  double top = box_around(job, fixtures, part).high.z;
  for (const GroupReader& reader : readers) top = std::max(top, reader.highest_mm());
  if (job.machine.start_mm)
    top = std::max(top, job.machine.start_mm->z + job.program_frame.translate_mm.z);
  const double wanted_mm = top + job.clearance_mm;
  return job.travel_mm ? std::max(top, std::min(wanted_mm, job.travel_mm->high.z)) : wanted_mm;
}

model::ProgramStart start_of(const Job& job, double above_all_mm) {
  if (job.machine.start_mm) return {*job.machine.start_mm, false};
  return {{0, 0, above_all_mm - job.program_frame.translate_mm.z}, true};
}

}  // namespace

std::vector<StagePrograms> read_stage_programs(const Job& job) {
  const Settings settings = settings_for_reading(job);
  std::vector<StagePrograms> read;
  const std::vector<Group> groups = groups_of(job);
  for (const Group& group : groups) {
    const GroupReader reader(job, settings, group);
    read.push_back({group, reader.program(), reader.ranges()});
  }
  return read;
}

model::MachineSetup machine_for(const Job& job, const model::Cutter& cutter) {
  model::MachineSetup machine = job.machine;
  if (machine.tools.empty()) machine.only_tool = {0, std::nullopt, cutter.diameter_mm};
  return machine;
}

std::vector<std::optional<ForeignPath>> load_programs(const Job& job, const Settings& settings,
                                                      const std::vector<model::Fixture>& fixtures,
                                                      const model::Box3& part) {
  const std::vector<Group> groups = groups_of(job);
  std::deque<GroupReader> readers;
  for (const Group& group : groups) readers.emplace_back(job, settings, group);
  const double above_all_mm = above_everything_mm(job, fixtures, part, readers);
  std::vector<std::optional<ForeignPath>> programs(job.stages.size());
  // Motions take twice what moves do: those of a program are let go once its paths are there.
  for (; !readers.empty(); readers.pop_front()) {
    GroupReader& reader = readers.front();
    reader.place({above_all_mm, box_around(job, fixtures, part), start_of(job, above_all_mm)});
    for (std::size_t i = 0; i < reader.group().size(); ++i)
      programs[reader.group()[i]] = reader.path_of(i);
  }
  return programs;
}

void tell_offsets_left(std::vector<std::optional<ForeignPath>>& programs) {
  const ForeignPath* leaving = nullptr;
  for (std::optional<ForeignPath>& program : programs) {
    if (!program) continue;
    if (leaving && leaving->file != program->file)
      program->assumed.push_back(
          program->file + " begins with the job's work and tool offsets, not with those that " +
          leaving->file + " ends with (line " + std::to_string(leaving->offsets_left) + ")");
    if (program->offsets_left != 0) leaving = &*program;
  }
}

}  // namespace limitgauge::app
