#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <iosfwd>
#include <mutex>
#include <string>
#include <thread>

#include "app/output/time_left.h"
#include "app/run/run_watch.h"

namespace limitgauge::app {

/// What a line of progress looks at: of this machine, or of a test.
struct ProgressSurroundings {
  std::function<std::size_t()> columns = [] { return std::size_t{80}; };
  std::function<std::chrono::steady_clock::time_point()> now = std::chrono::steady_clock::now;
};

/// One line on a terminal that says what is going on, how far it is, since when and how long it
/// will still take; silent where `shown` is false. May be told from any thread.
class ProgressLine {
 public:
  ProgressLine(std::ostream& out, bool shown, ProgressSurroundings surroundings = {})
      : out_(out), shown_(shown), around_(std::move(surroundings)) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void phase(const Phase& phase);
  /// Other words for the same phase: its clock goes on.
  void rename(const std::string& what);
  void update(double fraction);
  /// Time has passed: draws the line again for its clock.
  void tick();
  /// Wipes the line, so that something else can be printed.
  void clear();
  bool shown() const { return shown_; }

 private:
  double now_s() const;
  void start_part();
  void draw();
  std::string text() const;

  std::ostream& out_;
  const bool shown_;
  const ProgressSurroundings around_;
  std::mutex mutex_;
  Phase phase_;
  std::size_t part_ = 1;  ///< of the phase: it began to count anew
  double fraction_ = 0;
  double part_began_s_ = 0, drawn_s_ = 0;
  TimeLeft left_;
};

/// Ticks a line while it lives, so that its clock goes on where nothing is reported.
class ProgressTicker {
 public:
  explicit ProgressTicker(ProgressLine& line);
  ~ProgressTicker();
  ProgressTicker(const ProgressTicker&) = delete;
  ProgressTicker& operator=(const ProgressTicker&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace limitgauge::app
