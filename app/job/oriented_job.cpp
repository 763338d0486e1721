#include "app/job/oriented_job.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>

#include "app/job/foreign_programs.h"
#include "app/job/program_parts.h"
#include "app/job/setup_frame.h"
#include "model/base/error.h"
#include "model/gcode/turning/turning_path.h"

namespace limitgauge::app {
namespace {

using model::RotaryAngles;

/// A part of a program while whose motions the rotary axes stand still.
struct Stretch {
  model::SteadyRange range;
  bool cuts = false;  ///< some motion is no rapid
  /// Where this is a whole stage that cuts while they turn: its turns.
  std::vector<model::AxisTurn> turning = {};
};

bool cuts_in(const model::Program& program, const MotionRange& range) {
  const auto begin = program.motions.begin();
  return std::any_of(
      begin + static_cast<std::ptrdiff_t>(range.first),
      begin + static_cast<std::ptrdiff_t>(range.last),
      [](const model::Motion& motion) { return motion.kind != model::MotionKind::rapid; });
}

std::vector<Stretch> stretches_of(const model::Program& program, const MotionRange& range) {
  std::vector<Stretch> stretches;
  for (model::SteadyRange& steady : steady_ranges(program, range.first, range.last)) {
    const bool cuts = cuts_in(program, {steady.first, steady.last});
    stretches.push_back({std::move(steady), cuts});
  }
  return stretches;
}

/// The whole of it, with all its turns; its angles are those at its end.
Stretch turning_stage(const model::Program& program, const MotionRange& range,
                      const RotaryAngles& end_deg) {
  Stretch whole{{range.first, range.last, end_deg, {}}, cuts_in(program, range)};
  for (const model::AxisTurn& turn : program.turns)
    if (turn.motion >= range.first && turn.motion < range.last) whole.turning.push_back(turn);
  return whole;
}

/// The one that the stage's limits are asked of: the last that cuts, or of all.
std::size_t last_cut(const std::vector<Stretch>& stretches) {
  for (std::size_t i = stretches.size(); i-- > 0;)
    if (stretches[i].cuts) return i;
  return stretches.size() - 1;
}

/// The job with its stages taken apart.
class Orienter {
 public:
  explicit Orienter(Job job) : job_(std::move(job)), pieces_(job_.stages.size()) {}

  Job oriented();

 private:
  void take_apart(std::size_t setup);
  std::vector<Stretch> pieces_of(const StagePrograms& read, std::size_t index) const;
  void put_pieces(const StagePrograms& read);
  void take_up_axes();
  [[noreturn]] static void refuse_left(const JobStage& before, const JobStage& stage, char axis);
  void refuse_tolerances(const JobStage& stage) const;
  void add_pieces(const JobStage& stage, const std::vector<Stretch>& stretches,
                  std::vector<JobStage>& stages);
  std::size_t setup_at(std::size_t stated, const RotaryAngles& angles_deg);
  void name_first_setup();

  Job job_;
  std::vector<std::vector<Stretch>> pieces_;  ///< by stage; none: it stays whole
};

std::vector<Stretch> Orienter::pieces_of(const StagePrograms& read, std::size_t index) const {
  const MotionRange& range = read.ranges[index];
  std::vector<Stretch> ranges = stretches_of(read.program, range);
  if (ranges.size() <= kMostPieces &&
      !cuts_while_turning(read.program, job_.machine.kinematics.value(), range.first, range.last))
    return ranges;
  return {turning_stage(read.program, range, ranges.back().range.angles_deg)};
}

bool is_turning(const std::vector<Stretch>& ranges) {
  return ranges.size() == 1 && !ranges.front().turning.empty();
}

bool is_steady(const std::vector<Stretch>& ranges) {
  return ranges.size() == 1 && ranges.front().range.turns.empty() && !is_turning(ranges) &&
         ranges.front().range.angles_deg == RotaryAngles{};
}

/// The turns that a stage begins with, before anything else moves.
std::span<model::AxisTurn> first_turns(std::vector<Stretch>& ranges) {
  if (ranges.empty()) return {};
  Stretch& first = ranges.front();
  if (!is_turning(ranges)) return first.range.turns;
  std::size_t count = 0;
  while (count < first.turning.size() && first.turning[count].motion == first.range.first + count)
    ++count;
  return std::span(first.turning).first(count);
}

/// The first axis that does not stand at 0 and that no word of the turns says where to turn;
/// nothing where all are said. One that is said to turn to 0 is thought to be there already, be it
/// by whole turns that it makes on the way, and with the tip under control nobody knows where it
/// is.
std::optional<char> unnamed_axis(const RotaryAngles& left_deg,
                                 std::span<const model::AxisTurn> turns) {
  for (std::size_t axis = 0; axis < left_deg.size(); ++axis)
    if (left_deg[axis] != 0 && std::ranges::none_of(turns, [&](const model::AxisTurn& turn) {
          return turn.named[axis] && turn.turn.frame.control == model::TipControl::joints;
        }))
      return static_cast<char>('A' + axis);
  return std::nullopt;
}

/// Turns of a program that is read as if all axes stood at 0 go from where they were left: each
/// until a word says where to.
void begin_at(const RotaryAngles& left_deg, std::span<model::AxisTurn> turns) {
  std::array<bool, 3> named{};
  for (model::AxisTurn& turn : turns)
    for (std::size_t axis = 0; axis < left_deg.size(); ++axis) {
      if (named[axis]) continue;
      turn.turn.from_deg[axis] = left_deg[axis];
      named[axis] = turn.named[axis];
      if (!named[axis]) turn.turn.to_deg[axis] = left_deg[axis];
    }
}

/// Where one stage of a program turns an axis, the others take stretches of it too: which motions
/// are whose is then settled for all of them, in whatever setup they are.
void Orienter::put_pieces(const StagePrograms& read) {
  std::vector<std::vector<Stretch>> ranges;
  bool in_parts = false, turns = false;
  for (std::size_t i = 0; i < read.stages.size(); ++i) {
    ranges.push_back(pieces_of(read, i));
    in_parts = in_parts || !job_.stages[read.stages[i]].part.whole();
    turns = turns || !is_steady(ranges.back());
  }
  if (!turns && (!in_parts || read.program.turns.empty())) return;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    refuse_tolerances(job_.stages[read.stages[i]]);
    pieces_[read.stages[i]] = std::move(ranges[i]);
  }
}

/// A program that is begun after another one finds the axes where that left them, and is read as if
/// they stood at 0: those that were left turned it has to name before it moves.
void Orienter::take_up_axes() {
  const JobStage* before = nullptr;
  RotaryAngles left_deg{};
  for (std::size_t i = 0; i < job_.stages.size(); ++i) {
    const JobStage& stage = job_.stages[i];
    std::vector<Stretch>& pieces = pieces_[i];
    if (before && (stage.part.whole() || !same_program(*before, stage))) {
      const std::span<model::AxisTurn> turns = first_turns(pieces);
      if (const auto axis = unnamed_axis(left_deg, turns)) refuse_left(*before, stage, *axis);
      begin_at(left_deg, turns);
    }
    before = &stage;
    left_deg = pieces.empty() ? RotaryAngles{} : pieces.back().range.angles_deg;
  }
}

void Orienter::refuse_left(const JobStage& before, const JobStage& stage, char axis) {
  throw model::InputError(
      {before.program.string(), 0, 0},
      std::string("the program of stage \"") + before.name + "\" ends with " + axis +
          " turned, and stage \"" + stage.name + "\" begins as if it stood at 0",
      std::string("a program that turns its axes back before it ends, or a next one that names an "
                  "angle of ") +
          axis + ", other than 0 and with G90, before it moves");
}

void Orienter::refuse_tolerances(const JobStage& stage) const {
  if (!job_.tolerances) return;
  throw model::InputError(
      {stage.program.string(), 0, 0},
      "the program turns rotary axes, and the job has [tolerances]: figures over "
      "tolerances are proven for parts that are not turned",
      "a job without [tolerances]");
}

void Orienter::take_apart(std::size_t setup) {
  Job view = job_;
  view.at_setup = setup;
  view.machine = machine_in_setup(job_, setup);
  for (const StagePrograms& read : read_stage_programs(view)) put_pieces(read);
}

/// A setup without a name is the only one, of a job that states none.
void Orienter::name_first_setup() {
  if (has_setups(job_)) return;
  job_.setups.front().setup.name = job_.machine.kinematics->to_text({});
}

std::size_t Orienter::setup_at(std::size_t stated, const RotaryAngles& angles_deg) {
  if (angles_deg == RotaryAngles{}) return stated;
  for (std::size_t k = 0; k < job_.setups.size(); ++k)
    if (const auto& turned = job_.setups[k].turned;
        turned && turned->of == stated && turned->angles_deg == angles_deg)
      return k;
  JobSetup setup = job_.setups[stated];
  const std::string words = job_.machine.kinematics->to_text(angles_deg);
  const bool named = setup.setup.name != job_.machine.kinematics->to_text({});
  setup.setup.name = named ? setup.setup.name + "." + words : words;
  const auto is_taken = [&](const JobSetup& other) { return other.setup.name == setup.setup.name; };
  while (std::ranges::any_of(job_.setups, is_taken)) setup.setup.name += "+";
  Job view = job_;
  view.machine = machine_in_setup(job_, stated);
  setup.setup.from_part =
      turned_part(*job_.machine.kinematics, machine_in_setup_frame(view), angles_deg) *
      setup.setup.from_part;
  setup.turned = {stated, angles_deg};
  job_.setups.push_back(std::move(setup));
  return job_.setups.size() - 1;
}

void Orienter::add_pieces(const JobStage& stage, const std::vector<Stretch>& stretches,
                          std::vector<JobStage>& stages) {
  const std::size_t last = last_cut(stretches);
  const bool cuts = std::ranges::any_of(stretches, &Stretch::cuts);
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const model::SteadyRange& range = stretches[i].range;
    JobStage piece = stage;
    piece.piece = {stage.name,
                   range,
                   i + 1,
                   stretches.size(),
                   stretches[i].cuts,
                   cuts,
                   job_.machine.kinematics->to_text(range.angles_deg),
                   stage.limits};
    piece.piece->turning = stretches[i].turning;
    // A stage whose tool turns is cut as the part lies with the axes at zero.
    if (!is_turning(stretches)) piece.setup = setup_at(stage.setup, range.angles_deg);
    if (i != last) {
      piece.name += "." + std::to_string(i + 1);
      piece.limits = {};
      piece.limits.has_gouge = stage.limits.has_gouge;
      piece.limits.gouge_mm = stage.limits.gouge_mm;
    }
    stages.push_back(std::move(piece));
  }
}

/// Names of stages of a job differ: where two are alike now, a stretch has one of them, and begins
/// with a turn of its program unless it is the first.
void require_names(const std::vector<JobStage>& stages) {
  for (std::size_t i = 0; i < stages.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      if (stages[i].name != stages[k].name) continue;
      const JobStage& stretch = stages[k].piece ? stages[k] : stages[i];
      const std::vector<model::AxisTurn>& turns = stretch.piece->range.turns;
      const int line = turns.empty() ? 0 : static_cast<int>(turns.back().line);
      throw model::InputError({stretch.program.string(), line, 0},
                              "two stages are called \"" + stages[i].name +
                                  "\": one of them is a stretch of \"" + stretch.piece->stage +
                                  "\", whose program turns rotary axes",
                              "another name of the other in the job");
    }
}

Job Orienter::oriented() {
  for (std::size_t k = 0, stated = job_.setups.size(); k < stated; ++k) take_apart(k);
  const auto whole = [](const auto& ranges) { return ranges.empty(); };
  if (std::all_of(pieces_.begin(), pieces_.end(), whole)) return std::move(job_);
  take_up_axes();
  const auto stays_in_setup = [&](const auto& ranges) {
    return whole(ranges) || is_turning(ranges);
  };
  if (!std::all_of(pieces_.begin(), pieces_.end(), stays_in_setup)) name_first_setup();
  std::vector<JobStage> stages;
  for (std::size_t i = 0; i < job_.stages.size(); ++i) {
    if (pieces_[i].empty()) {
      stages.push_back(job_.stages[i]);
    } else {
      add_pieces(job_.stages[i], pieces_[i], stages);
    }
  }
  require_names(stages);
  job_.stages = std::move(stages);
  return std::move(job_);
}

}  // namespace

Job oriented(Job job) {
  if (!job.machine.kinematics) return job;
  return Orienter(std::move(job)).oriented();
}

}  // namespace limitgauge::app
