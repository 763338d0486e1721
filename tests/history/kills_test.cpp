#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <random>
#include <set>
#include <thread>

#include "history/history.h"
#include "history/recorder.h"
#include "history/schema.h"
#include "tests/history/history_file.h"
#include "tests/support/catch.h"
#include "tests/support/effort.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::history {
namespace {

namespace fs = std::filesystem;
using tests::query;
using tests::sample_entry;
using tests::TemporaryFolder;

/// Memory where there is such a folder. What a killed process leaves is the same there; to wait for
/// the disk, which a power cut is what for, would take most of an hour.
fs::path quick_folder() {
  std::error_code missing;
  return fs::is_directory("/dev/shm", missing) ? "/dev/shm" : fs::temp_directory_path();
}

/// That a writer's run was added, as it says once append() has returned.
struct Receipt {
  int number = 0;  ///< of sample_entry()
  std::int64_t id = 0;
};

/// Carries receipts of all writers; each is written whole or not at all.
class Receipts {
 public:
  Receipts() { REQUIRE(::pipe2(ends_, O_NONBLOCK | O_CLOEXEC) == 0); }
  ~Receipts() {
    for (const int end : ends_) ::close(end);
  }
  Receipts(const Receipts&) = delete;
  Receipts& operator=(const Receipts&) = delete;

  bool give(const Receipt& receipt) const {
    return ::write(ends_[1], &receipt, sizeof receipt) == sizeof receipt;
  }
  /// Those that have come, waiting a little where there are none.
  std::vector<Receipt> take() const {
    constexpr int kWait_ms = 20;
    pollfd arrival{ends_[0], POLLIN, 0};
    ::poll(&arrival, 1, kWait_ms);
    std::vector<Receipt> taken;
    for (Receipt one; ::read(ends_[0], &one, sizeof one) == sizeof one;) taken.push_back(one);
    return taken;
  }

 private:
  int ends_[2] = {-1, -1};
};

/// More runs than a writer comes to: numbers of different writers differ.
constexpr int kNumbersOfAWriter = 100'000;

int write_for_ever(const fs::path& file, const Receipts& receipts, int first_number) {
  for (int number = first_number;; ++number) {
    const std::int64_t id = Recorder(file).append(sample_entry(number));
    if (!receipts.give({number, id})) return 1;
  }
}

bool is_whole(const Entry& run) {
  Entry expected = sample_entry(std::stoi(run.label.substr(4)));
  expected.id = run.id;
  return run == expected;
}

bool ids_rise(const std::vector<Entry>& runs) {
  return std::ranges::adjacent_find(runs, std::ranges::greater_equal{}, &Entry::id) == runs.end();
}

int read_for_ever(const fs::path& file) {
  Query newest;
  newest.last = 20;
  for (std::size_t seen = 0;;) {
    if (!fs::exists(file)) continue;
    const History history(file);
    const std::vector<Entry> runs = history.runs(newest);
    const std::size_t count = history.count({});
    if (!std::ranges::all_of(runs, is_whole) || !ids_rise(runs) || count < seen) return 1;
    seen = count;
  }
}

/// Writers and readers of one history, any of which is killed at any moment, and replaced.
class Crowd {
 public:
  explicit Crowd(fs::path file) : file_(std::move(file)) {
    for (std::size_t place = 0; place < kWriters + kReaders; ++place)
      children_.push_back(start(place));
  }

  /// Until there are so many receipts, and a moment longer.
  void wait_for_receipts(std::size_t count) {
    while (receipts_.size() < count) collect();
    std::this_thread::sleep_for(std::chrono::microseconds(random_() % kLongestAppend_us));
  }

  /// What the killed one has promised is there, already now.
  void kill_one() {
    const std::size_t place = random_() % children_.size();
    end(children_[place]);
    const std::size_t known = receipts_.size();
    collect();
    check_there(std::span(receipts_).subspan(known > kRecent ? known - kRecent : 0));
    children_[place] = start(place);
  }

  void kill_all() {
    for (const int child : children_) end(child);
    children_.clear();
    collect();
  }

  const std::vector<Receipt>& receipts() const { return receipts_; }

 private:
  static constexpr std::size_t kWriters = 3, kReaders = 2, kRecent = 10;
  static constexpr unsigned kLongestAppend_us = 10'000;

  int start(std::size_t place) {
    if (place >= kWriters) return tests::start_child([&] { return read_for_ever(file_); });
    const int first = kNumbersOfAWriter * ++writers_;
    return tests::start_child([&] { return write_for_ever(file_, pipe_, first); });
  }
  /// One that has found a fault has ended by itself.
  static void end(int child) {
    ::kill(child, SIGKILL);
    REQUIRE(tests::wait_for(child) == -SIGKILL);
  }
  void collect() {
    for (const Receipt& one : pipe_.take()) receipts_.push_back(one);
  }
  void check_there(std::span<const Receipt> some) const {
    if (some.empty()) return;
    std::string pairs;
    for (const auto& [number, id] : some)
      pairs += (pairs.empty() ? "(" : ", (") + std::to_string(id) + ", 'run " +
               std::to_string(number) + "')";
    CHECK(query(file_, "SELECT count(*) FROM run WHERE (id, label) IN (VALUES " + pairs + ")") ==
          std::to_string(some.size()));
  }

  fs::path file_;
  Receipts pipe_;
  std::vector<Receipt> receipts_;
  std::vector<int> children_;
  std::mt19937 random_{17};
  int writers_ = 0;
};

/// What stands in the folder of a history beside it.
std::string beside(const fs::path& file) {
  std::string names;
  for (const auto& entry : fs::directory_iterator(file.parent_path()))
    if (entry.path() != file) names += entry.path().filename().string() + " ";
  return names;
}

/// Every run with a receipt once, the others once at most; whole, ids rising. A journal that had
/// not come into force is nobody's until the next writer takes it away.
void check_all(const fs::path& file, const std::vector<Receipt>& receipts) {
  Recorder(file).append(sample_entry(0));
  CHECK(beside(file) == "");
  CHECK(query(file, "PRAGMA integrity_check") == "ok");
  CHECK(query(file, "PRAGMA foreign_key_check").empty());
  const std::vector<Entry> runs = History(file).runs({});
  CHECK(ids_rise(runs));
  CHECK(std::ranges::all_of(runs, is_whole));
  std::map<std::string, std::int64_t> id_of;
  for (const Entry& run : runs) id_of[run.label] = run.id;
  CHECK(id_of.size() == runs.size());
  CHECK(std::ranges::all_of(receipts, [&](const Receipt& one) {
    const auto found = id_of.find("run " + std::to_string(one.number));
    return found != id_of.end() && found->second == one.id;
  }));
}

TEST_CASE("a history whose writers and readers are killed loses and doubles nothing",
          "[slow][history]") {
  // All of it: ten thousand runs, a thousand kills.
  const int kills = tests::by_effort(150, 1000);
  constexpr int kRunsOfAKill = 10;
  const TemporaryFolder folder(quick_folder());
  const fs::path file = folder.path() / "runs.sqlite";
  Crowd crowd(file);
  for (int n = 1; n <= kills; ++n) {
    crowd.wait_for_receipts(static_cast<std::size_t>(n) * kRunsOfAKill);
    crowd.kill_one();
    if (n % 100 == 0) CHECK(query(file, "PRAGMA integrity_check") == "ok");
  }
  crowd.kill_all();
  CHECK(crowd.receipts().size() >= static_cast<std::size_t>(kills) * kRunsOfAKill);
  check_all(file, crowd.receipts());
}

/// Kills one that adds runs to what `prepare` leaves in a folder, at some moment of its first.
void kill_first_append(const std::function<void(const fs::path&)>& prepare, int kills,
                       const std::function<void(const fs::path&)>& check) {
  std::mt19937 random(23);
  // As many moments before a tenth of a millisecond as after three: however fast or busy the
  // machine is, some children have not begun, some are done and some are in between.
  std::uniform_real_distribution<double> moment(0, std::log(30'000));
  for (int n = 0; n < kills; ++n) {
    const TemporaryFolder folder(quick_folder());
    const fs::path file = folder.path() / "runs.sqlite";
    prepare(file);
    const int child = tests::start_child([&] {
      Recorder(file).append(sample_entry(1));
      pause();
      return 0;
    });
    std::this_thread::sleep_for(
        std::chrono::duration<double, std::micro>(std::exp(moment(random))));
    ::kill(child, SIGKILL);
    REQUIRE(tests::wait_for(child) == -SIGKILL);
    check(file);
    CHECK(query(file, "PRAGMA integrity_check") == "ok");
    CHECK(beside(file) == "");
  }
}

TEST_CASE("one that is killed while it makes a history leaves one or none", "[slow][history]") {
  int made = 0;
  const int kills = tests::by_effort(50, 200);
  kill_first_append([](const fs::path&) {}, kills,
                    [&](const fs::path& file) {
                      const std::size_t before =
                          fs::exists(file) ? History(file).runs({}).size() : 0;
                      CHECK(before <= 1);
                      made += before == 1;
                      Recorder(file).append(sample_entry(2));
                      const std::vector<Entry> runs = History(file).runs({});
                      CHECK(runs.size() == before + 1);
                      CHECK(std::ranges::all_of(runs, is_whole));
                    });
  CHECK(made < kills);
}

TEST_CASE("one that is killed while it migrates a history leaves the old one or the new one",
          "[slow][history]") {
  int migrated = 0;
  const int kills = tests::by_effort(50, 200);
  kill_first_append(
      [](const fs::path& file) { query(file, tests::kVersion1); }, kills,
      [&](const fs::path& file) {
        const std::size_t before = History(file).runs({}).size();
        const std::string version = query(file, "PRAGMA user_version");
        CHECK(version == (before == 1 ? "1" : std::to_string(newest_version())));
        migrated += before == 2;
        Recorder(file).append(sample_entry(2));
        const std::vector<Entry> runs = History(file).runs({});
        CHECK(runs.size() == before + 1);
        CHECK(runs.front().job == "old");
        CHECK(runs.front().values == std::vector<Value>{{"finish", "gouge_mm", 0.125, 0.25}});
        CHECK(std::all_of(runs.begin() + 1, runs.end(), is_whole));
      });
  CHECK(migrated < kills);
}

}  // namespace
}  // namespace limitgauge::history
