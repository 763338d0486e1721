#include "study/execute/local_pool.h"

#include <poll.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "model/base/error.h"
#include "study/execute/case_order.h"
#include "study/execute/memory_budget.h"
#include "study/execute/worker_lines.h"
#include "study/execute/worker_process.h"

namespace limitgauge::study {
namespace {

constexpr int kLook_ms = 200;
/// To leave a block of work and to clear up, all of them together: whoever stops a study waits for
/// two seconds at most. What is killed then loses nothing that was finished.
constexpr std::chrono::milliseconds kToStop{1200};
constexpr std::chrono::milliseconds kNoPatience{0};
/// A process whose socket is closed has ended or is about to.
constexpr std::chrono::milliseconds kToEnd{2000};

/// A worker with the case that it runs.
struct Seat {
  std::unique_ptr<WorkerProcess> worker;
  std::optional<std::size_t> position;
  std::uint64_t forecast_bytes = 0, taken_bytes = 0;
};

class PoolRun {
 public:
  PoolRun(const LocalPoolOptions& options, const std::vector<CaseRequest>& requests,
          const ReportOutcome& report)
      : options_(options),
        requests_(requests),
        report_(report),
        seats_(std::min<std::size_t>(std::max(1U, options.workers), requests.size())),
        queue_(requests, seats_.size()),
        budget_(options.memory_bytes),
        attempts_(requests.size(), 0),
        forecasts_(requests.size()) {}

  /// Whatever ended the work: what is still being computed is of no use to anybody.
  ~PoolRun();
  PoolRun(const PoolRun&) = delete;
  PoolRun& operator=(const PoolRun&) = delete;

  void work(const std::atomic<bool>& stop);

 private:
  void fill_seats();
  bool start(Seat& seat, std::size_t position);
  void wait_for_answers();
  void hear(Seat& seat);
  void take_answer(Seat& seat, const WorkerAnswer& answer);
  void mourn(Seat& seat);
  void leave(Seat& seat);
  void end_attempt(Seat& seat, CaseOutcome outcome, bool may_go_better);

  const LocalPoolOptions& options_;
  const std::vector<CaseRequest>& requests_;
  const ReportOutcome& report_;
  std::vector<Seat> seats_;
  CaseQueue queue_;
  MemoryBudget budget_;
  std::vector<unsigned> attempts_;
  std::vector<std::optional<std::uint64_t>> forecasts_;
  std::optional<std::size_t> waiting_;  ///< handed out, but there is no memory for it yet
  std::size_t ended_ = 0, busy_ = 0;
};

void PoolRun::work(const std::atomic<bool>& stop) {
  while (ended_ < requests_.size()) {
    if (stop) throw model::Interrupted();
    fill_seats();
    wait_for_answers();
    if (stop) throw model::Interrupted();
    for (Seat& seat : seats_)
      if (seat.position) hear(seat);
  }
}

PoolRun::~PoolRun() {
  // All are told before any is waited for.
  for (Seat& seat : seats_)
    if (seat.worker && seat.position) seat.worker->interrupt();
  const auto until = std::chrono::steady_clock::now() + kToStop;
  for (Seat& seat : seats_) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        until - std::chrono::steady_clock::now());
    if (seat.worker && seat.position) seat.worker->end(std::max(left, kNoPatience));
  }
}

void PoolRun::fill_seats() {
  for (std::size_t i = 0; i < seats_.size(); ++i) {
    if (seats_[i].position) continue;
    const std::optional<std::size_t> position = waiting_ ? waiting_ : queue_.next(i);
    waiting_.reset();
    if (!position) return;
    if (start(seats_[i], *position)) continue;
    waiting_ = position;
    return;
  }
}

/// False where there is no room for it beside the others.
bool PoolRun::start(Seat& seat, std::size_t position) {
  const CaseRequest& request = requests_[position];
  if (!forecasts_[position]) forecasts_[position] = options_.forecast_bytes(request);
  seat.forecast_bytes = *forecasts_[position];
  seat.taken_bytes = budget_.expected(seat.forecast_bytes);
  if (busy_ > 0 && !budget_.fits(seat.taken_bytes)) return false;
  budget_.take(seat.taken_bytes);
  ++busy_;
  ++attempts_[position];
  seat.position = position;
  if (!seat.worker) seat.worker = std::make_unique<WorkerProcess>(options_.worker);
  seat.worker->send(to_line(WorkerTask{request.index, request.key, request.overrides}));
  return true;
}

void PoolRun::wait_for_answers() {
  std::vector<pollfd> waiting;
  for (const Seat& seat : seats_)
    if (seat.position) waiting.push_back({seat.worker->descriptor(), POLLIN, 0});
  // Ended early by a signal as well: the stop flag is looked at next.
  ::poll(waiting.data(), waiting.size(), kLook_ms);
}

void PoolRun::hear(Seat& seat) {
  for (const std::string& line : seat.worker->lines()) {
    const std::optional<WorkerAnswer> answer = answer_of_line(line);
    if (answer && seat.position && answer->index == requests_[*seat.position].index)
      take_answer(seat, *answer);
  }
  if (!seat.worker->ended()) return;
  if (seat.position) mourn(seat);
  seat.worker.reset();
}

void PoolRun::take_answer(Seat& seat, const WorkerAnswer& answer) {
  budget_.learn(seat.forecast_bytes, answer.peak_bytes);
  CaseOutcome outcome;
  outcome.ending = answer.kind == WorkerAnswer::Kind::done ? CaseOutcome::Ending::done
                                                           : CaseOutcome::Ending::error;
  outcome.reason = answer.reason;
  outcome.seconds = answer.seconds;
  end_attempt(seat, std::move(outcome), answer.kind == WorkerAnswer::Kind::again);
}

void PoolRun::mourn(Seat& seat) {
  CaseOutcome outcome;
  outcome.reason = "the worker process " + seat.worker->end(kToEnd);
  options_.note("case " + std::to_string(requests_[*seat.position].index) + ", attempt " +
                std::to_string(attempts_[*seat.position]) + ": " + outcome.reason);
  end_attempt(seat, std::move(outcome), true);
}

void PoolRun::leave(Seat& seat) {
  budget_.give_back(seat.taken_bytes);
  seat.position.reset();
  --busy_;
}

void PoolRun::end_attempt(Seat& seat, CaseOutcome outcome, bool may_go_better) {
  const std::size_t position = *seat.position;
  leave(seat);
  if (may_go_better && attempts_[position] <= options_.retries) return queue_.again(position);
  outcome.index = requests_[position].index;
  outcome.attempts = attempts_[position];
  ++ended_;
  report_(outcome);
}

}  // namespace

void LocalPool::run(const std::vector<CaseRequest>& requests, const ReportOutcome& report,
                    const std::atomic<bool>& stop) {
  if (!requests.empty()) PoolRun(options_, requests, report).work(stop);
}

}  // namespace limitgauge::study
