#include "app/progress.h"

#include <algorithm>
#include <cmath>
#include <ostream>

namespace limitgauge::app {
namespace {

constexpr std::chrono::milliseconds kRedraw{100};
constexpr const char* kWipe = "\r\x1b[K";

}  // namespace

void ProgressLine::phase(const std::string& what) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  what_ = what;
  fraction_ = 0;
  draw();
}

void ProgressLine::update(double fraction) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  // Blocks end in any order: the line must not run backwards.
  fraction_ = std::max(fraction_, std::clamp(fraction, 0.0, 1.0));
  if (std::chrono::steady_clock::now() - drawn_ >= kRedraw) draw();
}

void ProgressLine::clear() {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  out_ << kWipe << std::flush;
}

void ProgressLine::draw() {
  out_ << kWipe << what_;
  if (fraction_ > 0) out_ << ' ' << std::lround(100 * fraction_) << " %";
  out_ << std::flush;
  drawn_ = std::chrono::steady_clock::now();
}

}  // namespace limitgauge::app
