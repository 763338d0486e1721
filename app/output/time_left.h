#pragma once

#include <optional>
#include <string>

namespace limitgauge::app {

/// How long a step will still take, from the fractions that it reports. Looks at its whole way and
/// at the last seconds, and moves from one estimate to the next so slowly that what is shown never
/// jumps. All times in seconds of one clock.
class TimeLeft {
 public:
  /// `fraction` of the step is done; also to be told where nothing has moved.
  void update(double now_s, double fraction);
  /// Nothing as long as too little is known.
  std::optional<double> seconds(double now_s) const;

 private:
  bool counting_ = false;  ///< a share was reported
  double start_s_ = 0, start_fraction_ = 0, last_s_ = 0, last_fraction_ = 0;
  double recent_rate_ = 0;  ///< share a second, over the last seconds
  std::optional<double> end_s_;
};

/// "about 2 min left", "a few seconds left".
std::string time_left_words(double seconds);
/// "0:07", "12:34", "1:02:03".
std::string clock_words(double seconds);

}  // namespace limitgauge::app
