#include "app/output/time_left.h"

#include <algorithm>
#include <cmath>

namespace limitgauge::app {
namespace {

constexpr double kLeastElapsed_s = 2;
constexpr double kLeastFraction = 0.01;
/// How far back the recent rate looks.
constexpr double kRecent_s = 8;
/// How much the recent rate counts against the mean of the whole way.
constexpr double kTrust = 0.75;
/// In this time, two thirds of a change of the estimate are taken over.
constexpr double kSettle_s = 4;

std::string two_digits(long value) {
  return (value < 10 ? "0" : "") + std::to_string(value);
}

}  // namespace

void TimeLeft::update(double now_s, double fraction) {
  if (!counting_) {
    // What was done before the first share is not what the shares are of.
    counting_ = fraction > 0;
    start_s_ = last_s_ = now_s;
    start_fraction_ = last_fraction_ = fraction;
    return;
  }
  const double passed = now_s - last_s_, elapsed = now_s - start_s_;
  if (passed <= 0) return;
  const double rate = (fraction - last_fraction_) / passed;
  const bool is_first = last_s_ == start_s_;
  recent_rate_ += (is_first ? 1 : 1 - std::exp(-passed / kRecent_s)) * (rate - recent_rate_);
  last_s_ = now_s;
  last_fraction_ = fraction;
  if (elapsed < kLeastElapsed_s || fraction - start_fraction_ < kLeastFraction) return;
  const double mean_rate = (fraction - start_fraction_) / elapsed;
  const double end_s = now_s + (1 - fraction) / (kTrust * recent_rate_ + (1 - kTrust) * mean_rate);
  if (!end_s_) end_s_ = end_s;
  *end_s_ += (1 - std::exp(-passed / kSettle_s)) * (end_s - *end_s_);
}

std::optional<double> TimeLeft::seconds(double now_s) const {
  if (!end_s_) return std::nullopt;
  return std::max(0.0, *end_s_ - now_s);
}

std::string time_left_words(double seconds) {
  constexpr double kFew = 5, kStep = 5, kMinute = 60, kHour = 3600;
  if (seconds < kFew) return "a few seconds left";
  if (seconds < kMinute - kStep / 2)
    return "about " + std::to_string(std::lround(seconds / kStep) * std::lround(kStep)) + " s left";
  const long minutes = std::max(1L, std::lround(seconds / kMinute));
  if (seconds < kHour - kMinute / 2) return "about " + std::to_string(minutes) + " min left";
  return "about " + std::to_string(minutes / 60) + " h " + two_digits(minutes % 60) + " min left";
}

std::string clock_words(double seconds) {
  const long whole = std::lround(std::floor(seconds));
  const long hours = whole / 3600, minutes = whole / 60 % 60;
  if (hours == 0) return std::to_string(minutes) + ":" + two_digits(whole % 60);
  return std::to_string(hours) + ":" + two_digits(minutes) + ":" + two_digits(whole % 60);
}

}  // namespace limitgauge::app
