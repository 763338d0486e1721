#include "study/execute/slurm.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <map>
#include <optional>
#include <system_error>
#include <thread>
#include <unordered_map>
#include <utility>

#include "model/base/error.h"
#include "study/execute/case_order.h"
#include "study/execute/slurm_commands.h"
#include "study/execute/slurm_folder.h"

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
constexpr int kLooksAtCancelled = 20;

struct Task {
  Batch open;  ///< positions without an answer
  bool started = false, closed = false;
  std::optional<Clock::time_point> gone_since;  ///< from Slurm's queue
};

struct Array {
  std::string job;
  ArrayFolder folder;
  std::vector<Task> tasks;
  std::size_t running;  ///< that Slurm lets run at a time
  std::size_t left() const {
    return static_cast<std::size_t>(
        std::count_if(tasks.begin(), tasks.end(), [](const Task& task) { return !task.closed; }));
  }
};

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
  void look_at(Array& array, std::size_t number, bool queued);
  void hear(Array& array, std::size_t number);
  void close_lost(Array& array, std::size_t number);
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
    commands_.let_run(array.job, array.running);
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
  const std::optional<std::vector<QueuedTask>> queue = commands_.queue(why);
  if (!queue) {
    if (Clock::now() - heard_ < kMostSilence) return;
    throw model::ResourceError("limitgauge: Slurm does not answer any more: " + why);
  }
  heard_ = Clock::now();
  std::map<std::string, std::vector<const QueuedTask*>> queued;
  for (const QueuedTask& task : *queue) queued[task.job].push_back(&task);
  for (Array& array : arrays_) {
    std::vector<char> there(array.tasks.size(), 0);
    for (const QueuedTask* task : queued[array.job]) {
      if (task->number >= there.size()) continue;
      there[task->number] = 1;
      array.tasks[task->number].started |= task->started;
    }
    for (std::size_t i = 0; i < array.tasks.size(); ++i)
      if (!array.tasks[i].closed) look_at(array, i, there[i] != 0);
  }
  arrays_.erase(std::remove_if(arrays_.begin(), arrays_.end(),
                               [](const Array& array) { return array.left() == 0; }),
                arrays_.end());
}

void SlurmRun::look_at(Array& array, std::size_t number, bool queued) {
  Task& task = array.tasks[number];
  if (task.started || !queued) hear(array, number);
  if (queued) {
    // Slurm may start a task again that its node has lost.
    task.gone_since.reset();
    return;
  }
  if (!task.gone_since) task.gone_since = Clock::now();
  task.closed = task.open.empty();
  if (!task.closed && Clock::now() - *task.gone_since >= options_.patience)
    close_lost(array, number);
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
void SlurmRun::close_lost(Array& array, std::size_t number) {
  const std::string ending = commands_.ending(array.job, number);
  const std::string task =
      "its Slurm task " + array.job + "_" + std::to_string(number) + " ended without an answer" +
      (ending.empty() ? "" : " (" + ending + ")") + "; log: " + array.folder.log(number).string();
  bool said = false;
  for (const std::size_t position : std::exchange(array.tasks[number].open, {})) {
    CaseOutcome outcome;
    // Killed between the result and its answer.
    const bool done = store_.has("result", requests_[position].key);
    outcome.ending = done ? CaseOutcome::Ending::done : CaseOutcome::Ending::lost;
    if (!done) outcome.reason = task;
    if (!done && !std::exchange(said, true))
      options_.note("case " + std::to_string(requests_[position].index) + ", attempt " +
                    std::to_string(attempts_[position]) + ": " + task);
    end_attempt(position, std::move(outcome), !done);
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

/// Tasks that were told to end write to their folder until they do.
void wait_for_cancelled(const SlurmCommands& commands) {
  std::string why;
  for (int look = 0; look < kLooksAtCancelled; ++look) {
    const auto queue = commands.queue(why);
    if (!queue || queue->empty()) return;
    std::this_thread::sleep_for(kShortestWait / 2);
  }
}

}  // namespace

struct Slurm::Parts {
  Parts(SlurmOptions stated, const Store& of)
      : options(std::move(stated)),
        store(of),
        commands(options.name, options.options, options.working_directory) {}
  SlurmOptions options;
  const Store& store;
  SlurmCommands commands;
  std::size_t runs = 0;
  bool keep_folder = false;
};

Slurm::Slurm(SlurmOptions options, const Store& store)
    : parts_(std::make_unique<Parts>(std::move(options), store)) {}

Slurm::~Slurm() {
  std::error_code ignored;
  if (!parts_->keep_folder) fs::remove_all(parts_->options.folder, ignored);
}

void Slurm::run(const std::vector<CaseRequest>& requests, const ReportOutcome& report,
                const std::atomic<bool>& stop) {
  if (requests.empty()) return;
  SlurmRun run(parts_->options, parts_->commands, parts_->store, requests, report,
               parts_->options.folder / ("run-" + std::to_string(parts_->runs++)));
  try {
    run.work(stop);
  } catch (...) {
    parts_->commands.cancel();
    wait_for_cancelled(parts_->commands);
    throw;
  }
  parts_->keep_folder |= run.anything_lost();
}

}  // namespace limitgauge::study
