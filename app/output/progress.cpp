#include "app/output/progress.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "reports/text/text.h"

namespace limitgauge::app {
namespace {

constexpr double kRedraw_s = 0.1;
constexpr std::chrono::milliseconds kTick{500};
constexpr const char* kWipe = "\r\x1b[K";
/// A share that falls by more than this is no block that ended out of turn.
constexpr double kAnew = 0.3;
/// Before the name of what is going on is cut shorter, times are left out.
constexpr std::size_t kLeastName = 24;

std::string head(const Phase& phase, std::size_t part) {
  std::string text = reports::clean_text(phase.what);
  if (phase.stage > 0 && phase.stages > 1)
    text = "stage " + std::to_string(phase.stage) + " of " + std::to_string(phase.stages) + ", " +
           text;
  return part > 1 ? text + ", part " + std::to_string(part) : text;
}

}  // namespace

double ProgressLine::now_s() const {
  return std::chrono::duration<double>(around_.now().time_since_epoch()).count();
}

void ProgressLine::start_part() {
  fraction_ = 0;
  part_began_s_ = now_s();
  left_ = {};
}

void ProgressLine::phase(const Phase& phase) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  phase_ = phase;
  part_ = 1;
  start_part();
  draw();
}

void ProgressLine::rename(const std::string& what) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  phase_.what = what;
}

void ProgressLine::update(double fraction) {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  // Some steps are several passes over the work, each with a share of its own.
  if (fraction < fraction_ - kAnew) {
    ++part_;
    start_part();
  }
  // Blocks end in any order: the line must not run backwards.
  fraction_ = std::max(fraction_, std::clamp(fraction, 0.0, 1.0));
  if (now_s() - drawn_s_ >= kRedraw_s) draw();
}

void ProgressLine::tick() {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  if (!phase_.what.empty() && now_s() - drawn_s_ >= kRedraw_s) draw();
}

void ProgressLine::clear() {
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  out_ << kWipe << std::flush;
}

std::string ProgressLine::text() const {
  const std::string name = head(phase_, part_);
  const double now = now_s();
  // The last column stays free: some terminals wrap as soon as it is taken.
  const std::size_t columns = std::max<std::size_t>(around_.columns(), 2) - 1;
  std::string tail;
  const auto add = [&](const std::string& piece) {
    const std::size_t least = std::min(reports::code_points(name), kLeastName);
    if (least + tail.size() + piece.size() <= columns) tail += piece;
  };
  if (fraction_ > 0) add("  " + std::to_string(std::lround(std::floor(100 * fraction_))) + " %");
  if (now - part_began_s_ >= 1) add("  " + clock_words(now - part_began_s_));
  if (const std::optional<double> left = left_.seconds(now)) add("  " + time_left_words(*left));
  return reports::shortened(name, columns - tail.size()) + tail;
}

void ProgressLine::draw() {
  drawn_s_ = now_s();
  left_.update(drawn_s_, fraction_);
  out_ << kWipe << text() << std::flush;
}

ProgressTicker::ProgressTicker(ProgressLine& line) {
  if (!line.shown()) return;
  thread_ = std::thread([this, &line] {
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, kTick, [this] { return ended_; })) line.tick();
  });
}

ProgressTicker::~ProgressTicker() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable()) thread_.join();
}

}  // namespace limitgauge::app
