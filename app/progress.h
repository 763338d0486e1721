#pragma once

#include <chrono>
#include <iosfwd>
#include <mutex>
#include <string>

namespace limitgauge::app {

/// One line on a terminal that says what is going on and how far it is; silent where `shown` is
/// false. May be told from any thread.
class ProgressLine {
 public:
  ProgressLine(std::ostream& out, bool shown) : out_(out), shown_(shown) {}
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void phase(const std::string& what);
  void update(double fraction);
  /// Wipes the line, so that something else can be printed.
  void clear();

 private:
  void draw();

  std::ostream& out_;
  const bool shown_;
  std::mutex mutex_;
  std::string what_;
  double fraction_ = 0;
  std::chrono::steady_clock::time_point drawn_;
};

}  // namespace limitgauge::app
