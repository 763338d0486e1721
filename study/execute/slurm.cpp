#include "study/execute/slurm.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <system_error>
#include <thread>
#include <unordered_map>
#include <utility>

#include "model/base/error.h"
#include "study/execute/case_order.h"
#include "study/execute/slurm_commands.h"
#include "study/execute/slurm_folder.h"
#include "study/execute/slurm_stuck.h"
#include "study/execute/slurm_submitter.h"

namespace limitgauge::study {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;
using Batch = std::vector<std::size_t>;

/// Batches for each task that may run at a time: enough to even out, few enough to share stages.
constexpr std::size_t kBatchesEach = 4;
constexpr std::size_t kMostInBatch = 200;
/// Looks follow each other within a twentieth of the time that the study has taken by now.
constexpr std::chrono::milliseconds kShortestWait{500}, kLongestWait{15000}, kNap{50};
constexpr int kWaitsInStudy = 20;
/// A controller that is started again is away for minutes.
constexpr std::chrono::minutes kMostSilence{10};
/// For tasks that were cancelled to be gone.
constexpr std::chrono::milliseconds kLongestEnding{500};
/// Nodes are looked at so often within the patience with those that do not come back.
constexpr int kLooksAtNodes = 16;

struct Task {
  Batch open;  ///< positions without an answer
  bool started = false, closed = false;
  std::optional<Clock::time_point> gone_since;  ///< from Slurm's queue
};

struct Array {
  std::string job;
  ArrayFolder folder;
  std::vector<Task> tasks;
  std::size_t running;       ///< that Slurm lets run at a time
  std::size_t given_up = 0;  ///< that it may count among them until their nodes answer
  std::size_t left() const {
    return static_cast<std::size_t>(
        std::count_if(tasks.begin(), tasks.end(), [](const Task& task) { return !task.closed; }));
  }
};

std::string minutes_text(std::chrono::milliseconds time) {
  std::ostringstream text;
  text << std::chrono::duration<double, std::ratio<60>>(time).count() << " min";
  return text.str();
}

/// A task that waits again after it ran has another right to wait.
void remember_starts(std::vector<QueuedTask>& queue, std::vector<Array>& arrays) {
  for (QueuedTask& task : queue) {
    const auto array = std::find_if(arrays.begin(), arrays.end(),
                                    [&](const Array& one) { return one.job == task.job; });
    if (array == arrays.end() || task.number >= array->tasks.size()) continue;
    bool& started = array->tasks[task.number].started;
    task.ran_before = started;
    started |= task.started;
  }
}

class SlurmRun {
 public:
  SlurmRun(const SlurmOptions& options, const SlurmCommands& commands, const Store& store,
           const std::vector<CaseRequest>& requests, const ReportOutcome& report, fs::path folder);

  void work(const std::atomic<bool>& stop);
  bool anything_lost() const { return anything_lost_; }

 private:
  void submit_some();
  void submit(std::vector<Batch> batches, std::size_t running);
  std::size_t free_places() const;
  void share_free_places();
  void wait(const std::atomic<bool>& stop) const;
  void look();
  std::vector<NodeState> nodes_of(const std::vector<QueuedTask>& queue);
  void look_at_array(Array& array, const std::vector<const QueuedTask*>& queued);
  void look_at(Array& array, std::size_t number, const QueuedTask* queued);
  void give_up(Array& array, std::size_t number, const std::string& why);
  void cancel_given_up();
  void hear(Array& array, std::size_t number);
  void close_ended(Array& array, std::size_t number);
  void close_lost(Array& array, std::size_t number, const std::string& why, bool may_go_better);
  void take(const WorkerAnswer& answer);
  void end_attempt(std::size_t position, CaseOutcome outcome, bool may_go_better);

  const SlurmOptions& options_;
  const SlurmCommands& commands_;
  const Store& store_;
  const std::vector<CaseRequest>& requests_;
  const ReportOutcome& report_;
  const fs::path folder_;
  const Clock::time_point began_ = Clock::now();
  Clock::time_point heard_ = Clock::now();
  StuckTasks stuck_;
  Clock::time_point nodes_seen_{};
  std::vector<std::string> given_up_;  ///< and not cancelled yet
  std::unordered_map<std::size_t, std::size_t> position_of_;
  std::vector<unsigned> attempts_;
  std::deque<Batch> pending_;
  std::vector<Array> arrays_;  ///< with tasks that are not closed
  std::size_t submitted_ = 0, ended_ = 0;
  bool anything_lost_ = false;
};

SlurmRun::SlurmRun(const SlurmOptions& options, const SlurmCommands& commands, const Store& store,
                   const std::vector<CaseRequest>& requests, const ReportOutcome& report,
                   fs::path folder)
    : options_(options),
      commands_(commands),
      store_(store),
      requests_(requests),
      report_(report),
      folder_(std::move(folder)),
      stuck_(options.stuck_patience),
      attempts_(requests.size(), 0) {
  for (std::size_t i = 0; i < requests.size(); ++i) position_of_[requests[i].index] = i;
  const std::size_t wanted = kBatchesEach * options.running;
  const std::size_t most =
      std::clamp<std::size_t>((requests.size() + wanted - 1) / wanted, 1, kMostInBatch);
  for (Batch& batch : batches(requests, most)) pending_.push_back(std::move(batch));
}

void SlurmRun::work(const std::atomic<bool>& stop) {
  while (ended_ < requests_.size()) {
    if (stop) throw model::Interrupted();
    submit_some();
    wait(stop);
    if (stop) throw model::Interrupted();
    look();
  }
}

std::size_t SlurmRun::free_places() const {
  std::size_t taken = 0;
  for (const Array& array : arrays_) taken += std::min(array.running, array.left());
  return options_.running - std::min(taken, options_.running);
}

/// What an array that comes to its end no longer needs goes to the others.
void SlurmRun::share_free_places() {
  std::size_t free = free_places();
  for (Array& array : arrays_) {
    if (free == 0) return;
    const std::size_t more = std::min(free, array.left() - std::min(array.left(), array.running));
    if (more == 0) continue;
    array.running += more;
    free -= more;
    commands_.let_run(array.job, array.running + array.given_up);
  }
}

void SlurmRun::submit_some() {
  share_free_places();
  while (!pending_.empty() && free_places() > 0) {
    const std::size_t count =
        std::min({pending_.size(), commands_.most_tasks(), kMostTasksInFolder});
    const auto end = pending_.begin() + static_cast<std::ptrdiff_t>(count);
    std::vector<Batch> batches(std::make_move_iterator(pending_.begin()),
                               std::make_move_iterator(end));
    pending_.erase(pending_.begin(), end);
    submit(std::move(batches), std::min(free_places(), count));
  }
}

void SlurmRun::submit(std::vector<Batch> batches, std::size_t running) {
  ArrayFolder folder(folder_ / ("array-" + std::to_string(submitted_++)), requests_, batches,
                     options_.worker);
  const std::string job = commands_.submit(folder.script(), batches.size(), running);
  Array array{job, std::move(folder), {}, running};
  for (Batch& batch : batches) {
    for (const std::size_t position : batch) ++attempts_[position];
    array.tasks.emplace_back().open = std::move(batch);
  }
  arrays_.push_back(std::move(array));
}

void SlurmRun::wait(const std::atomic<bool>& stop) const {
  const auto so_far = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - began_);
  const auto until = Clock::now() + std::clamp<std::chrono::milliseconds>(
                                        so_far / kWaitsInStudy, kShortestWait, kLongestWait);
  while (!stop && Clock::now() < until) std::this_thread::sleep_for(kNap);
}

void SlurmRun::look() {
  std::string why;
  std::optional<std::vector<QueuedTask>> queue = commands_.queue(why);
  if (!queue) {
    if (Clock::now() - heard_ < kMostSilence) return;
    throw model::ResourceError("limitgauge: error: Slurm does not answer any more: " + why);
  }
  heard_ = Clock::now();
  std::map<std::string, std::vector<const QueuedTask*>> queued;
  for (const QueuedTask& task : *queue) queued[task.job].push_back(&task);
  remember_starts(*queue, arrays_);
  stuck_.see(*queue, nodes_of(*queue), Clock::now());
  for (Array& array : arrays_) look_at_array(array, queued[array.job]);
  cancel_given_up();
  arrays_.erase(std::remove_if(arrays_.begin(), arrays_.end(),
                               [](const Array& array) { return array.left() == 0; }),
                arrays_.end());
}

/// Not at every look: a large cluster has thousands.
std::vector<NodeState> SlurmRun::nodes_of(const std::vector<QueuedTask>& queue) {
  if (Clock::now() - nodes_seen_ < options_.stuck_patience / kLooksAtNodes) return {};
  nodes_seen_ = Clock::now();
  std::set<std::string> partitions;
  for (const QueuedTask& task : queue)
    if (!task.partition.empty()) partitions.insert(task.partition);
  return commands_.nodes({partitions.begin(), partitions.end()});
}

void SlurmRun::look_at_array(Array& array, const std::vector<const QueuedTask*>& queued) {
  std::vector<const QueuedTask*> there(array.tasks.size(), nullptr);
  for (const QueuedTask* task : queued)
    if (task->number < there.size()) there[task->number] = task;
  const std::size_t given_up = array.given_up;
  for (std::size_t i = 0; i < array.tasks.size(); ++i)
    if (!array.tasks[i].closed) look_at(array, i, there[i]);
  if (array.given_up > given_up && array.left() > 0)
    commands_.let_run(array.job, array.running + array.given_up);
}

void SlurmRun::look_at(Array& array, std::size_t number, const QueuedTask* queued) {
  Task& task = array.tasks[number];
  if (task.started || queued == nullptr) hear(array, number);
  if (queued != nullptr) {
    // Slurm may start a task again that its node has lost.
    task.gone_since.reset();
    if (const auto why = stuck_.why(*queued)) give_up(array, number, *why);
    return;
  }
  if (!task.gone_since) task.gone_since = Clock::now();
  task.closed = task.open.empty();
  if (!task.closed && Clock::now() - *task.gone_since >= options_.patience)
    close_ended(array, number);
}

void SlurmRun::give_up(Array& array, std::size_t number, const std::string& why) {
  const std::string task = array.job + "_" + std::to_string(number);
  given_up_.push_back(task);
  ++array.given_up;
  close_lost(array, number,
             "its Slurm task " + task + " has not come back for " +
                 minutes_text(options_.stuck_patience) + " (" + why +
                 "); log: " + array.folder.log(number).string(),
             false);
  anything_lost_ = true;
}

/// Should they come back after all, they find no work.
void SlurmRun::cancel_given_up() {
  if (!given_up_.empty()) commands_.cancel_tasks(std::exchange(given_up_, {}));
}

void SlurmRun::hear(Array& array, std::size_t number) {
  Batch& open = array.tasks[number].open;
  for (const WorkerAnswer& answer : array.folder.new_answers(number)) {
    const auto position = position_of_.find(answer.index);
    if (position == position_of_.end()) continue;
    const auto place = std::find(open.begin(), open.end(), position->second);
    if (place == open.end()) continue;
    open.erase(place);
    take(answer);
  }
}

void SlurmRun::take(const WorkerAnswer& answer) {
  CaseOutcome outcome;
  outcome.ending = answer.kind == WorkerAnswer::Kind::done ? CaseOutcome::Ending::done
                                                           : CaseOutcome::Ending::error;
  outcome.reason = answer.reason;
  outcome.seconds = answer.seconds;
  end_attempt(position_of_.at(answer.index), std::move(outcome),
              answer.kind == WorkerAnswer::Kind::again);
}

/// The task has ended, and not all of its cases have an answer.
void SlurmRun::close_ended(Array& array, std::size_t number) {
  const std::string ending = commands_.ending(array.job, number);
  close_lost(array, number,
             "its Slurm task " + array.job + "_" + std::to_string(number) +
                 " ended without an answer" + (ending.empty() ? "" : " (" + ending + ")") +
                 "; log: " + array.folder.log(number).string(),
             true);
}

void SlurmRun::close_lost(Array& array, std::size_t number, const std::string& why,
                          bool may_go_better) {
  bool said = false;
  for (const std::size_t position : std::exchange(array.tasks[number].open, {})) {
    CaseOutcome outcome;
    // Killed between the result and its answer.
    const bool done = store_.has("result", requests_[position].key);
    outcome.ending = done ? CaseOutcome::Ending::done : CaseOutcome::Ending::lost;
    if (!done) outcome.reason = why;
    if (!done && !std::exchange(said, true))
      options_.note("case " + std::to_string(requests_[position].index) + ", attempt " +
                    std::to_string(attempts_[position]) + ": " + why);
    end_attempt(position, std::move(outcome), !done && may_go_better);
  }
  array.tasks[number].closed = true;
}

void SlurmRun::end_attempt(std::size_t position, CaseOutcome outcome, bool may_go_better) {
  if (may_go_better && attempts_[position] <= options_.retries) {
    // Alone: whatever it is that ends tasks, it takes no other case with it.
    pending_.push_back({position});
    return;
  }
  anything_lost_ |= may_go_better;
  outcome.index = requests_[position].index;
  outcome.attempts = attempts_[position];
  ++ended_;
  report_(outcome);
}

}  // namespace

struct Slurm::Parts {
  Parts(SlurmOptions stated, const Store& of)
      : options(std::move(stated)),
        store(of),
        commands(options.name, options.options, options.working_directory, options.stop) {
    cancel_orphans(options.folder.parent_path(), commands, options.note);
    submitter.emplace(options.folder);
  }
  /// What is not done soon is left to the next study: whoever stops this one does not wait for it.
  void end_jobs() {
    if (commands.cancel(options.name) && commands.wait_for_cancelled(options.name, kLongestEnding))
      return;
    submitter->leave();
    keep_folder = true;
  }
  SlurmOptions options;
  const Store& store;
  SlurmCommands commands;
  std::optional<SlurmSubmitter> submitter;
  std::size_t runs = 0;
  bool keep_folder = false;
};

Slurm::Slurm(SlurmOptions options, const Store& store)
    : parts_(std::make_unique<Parts>(std::move(options), store)) {}

Slurm::~Slurm() {
  parts_->submitter.reset();
  std::error_code ignored;
  if (!parts_->keep_folder) fs::remove_all(parts_->options.folder, ignored);
}

void Slurm::run(const std::vector<CaseRequest>& requests, const ReportOutcome& report,
                const std::atomic<bool>& stop) {
  if (requests.empty()) return;
  parts_->commands.heed(&stop);
  SlurmRun run(parts_->options, parts_->commands, parts_->store, requests, report,
               parts_->options.folder / ("run-" + std::to_string(parts_->runs++)));
  try {
    run.work(stop);
  } catch (...) {
    parts_->end_jobs();
    // Whatever came of the programs that were no longer waited for.
    if (stop) throw model::Interrupted();
    throw;
  }
  parts_->keep_folder |= run.anything_lost();
}

}  // namespace limitgauge::study
