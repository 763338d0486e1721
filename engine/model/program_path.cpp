#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/model/error.h"
#include "engine/model/program.h"
#include "engine/model/words.h"

namespace limitgauge::model {
namespace {

/// LinuxCNC's fuzz: an arc whose end lies less than this beyond its start, in radians, is a full
/// turn.
constexpr double kFullTurnFuzz = 1e-6;
/// Wider chords would not follow an arc's direction, however wide the tolerance.
constexpr double kWidestChord = std::numbers::pi / 2;
/// A toolpath this long takes 16 GB; it comes from a tolerance out of proportion.
constexpr double kMostChords = 4e8;

/// An arc from `start` in cylinder coordinates about its centre; the radius may drift a little
/// along it, as the reader's tolerance allows.
struct Sweep {
  std::array<int, 3> axes{};
  double angle = 0, swept = 0;  ///< radians, signed: positive is counter-clockwise
  double radius_mm = 0, radius_growth_mm = 0;
  double height_mm = 0, rise_mm = 0;
};

Sweep sweep_of(const Motion& arc, const Vec3& start) {
  Sweep sweep;
  sweep.axes = axes_of(arc.plane);
  const auto [first, second, normal] = sweep.axes;
  const double x1 = start[first] - arc.centre1, y1 = start[second] - arc.centre2;
  const double x2 = arc.to[first] - arc.centre1, y2 = arc.to[second] - arc.centre2;
  const double direction = arc.turns < 0 ? -1 : 1;
  sweep.angle = std::atan2(y1, x1);
  double forward = direction * (std::atan2(y2, x2) - sweep.angle);
  while (forward < kFullTurnFuzz) forward += 2 * std::numbers::pi;
  forward += 2 * std::numbers::pi * (std::max(1.0, std::abs(arc.turns)) - 1);
  sweep.swept = direction * forward;
  sweep.radius_mm = std::hypot(x1, y1);
  sweep.radius_growth_mm = std::hypot(x2, y2) - sweep.radius_mm;
  sweep.height_mm = start[normal];
  sweep.rise_mm = arc.to[normal] - start[normal];
  return sweep;
}

/// Largest distance between the arc and `chords` equal chords. Exact for a circle and a helix
/// (r - r cos(h/2)); for a spiral the bound h²/8 · |p''| of linear interpolation.
double chord_error_mm(const Sweep& sweep, double chords) {
  const double h = std::abs(sweep.swept) / chords;
  if (sweep.radius_growth_mm == 0) {
    const double s = std::sin(h / 4);
    return 2 * sweep.radius_mm * s * s;
  }
  const double widest_mm = sweep.radius_mm + std::max(0.0, sweep.radius_growth_mm);
  return h * h / 8 * std::hypot(widest_mm, 2 * sweep.radius_growth_mm / sweep.swept);
}

/// The widest chord, in radians, that keeps the error within the limit.
double widest_chord(const Sweep& sweep, double limit_mm) {
  if (sweep.radius_growth_mm == 0)
    return 4 * std::asin(std::sqrt(std::min(1.0, limit_mm / (2 * sweep.radius_mm))));
  const double at_one_radian_mm = chord_error_mm(sweep, std::abs(sweep.swept));
  return std::sqrt(limit_mm / at_one_radian_mm);
}

double chords_within(const Sweep& sweep, double limit_mm) {
  const double widest = std::min(kWidestChord, widest_chord(sweep, limit_mm));
  double chords = std::ceil(std::abs(sweep.swept) / widest);
  if (!(chords < kMostChords))
    throw ResourceError("an arc of the program needs more than 400 million chords at this error");
  while (chord_error_mm(sweep, chords) > limit_mm) ++chords;
  return chords;
}

Vec3 point_at(const Sweep& sweep, const Motion& arc, double fraction) {
  const double angle = sweep.angle + fraction * sweep.swept;
  const double radius_mm = sweep.radius_mm + fraction * sweep.radius_growth_mm;
  Vec3 point;
  point[sweep.axes[0]] = arc.centre1 + radius_mm * std::cos(angle);
  point[sweep.axes[1]] = arc.centre2 + radius_mm * std::sin(angle);
  point[sweep.axes[2]] = sweep.height_mm + fraction * sweep.rise_mm;
  return point;
}

void add_move(const Motion& motion, const Vec3& to, Toolpath& path) {
  const bool rapid = motion.kind == MotionKind::rapid;
  path.moves.emplace_back(to, rapid ? 0.0F : motion.feed_mm_min, motion.line,
                          rapid ? MoveKind::rapid : MoveKind::feed);
  path.moves.back().spindle_stopped = motion.spindle_stopped;
}

void add_arc(const Motion& arc, const Vec3& start, double limit_mm, Toolpath& path) {
  const Sweep sweep = sweep_of(arc, start);
  const double chords = chords_within(sweep, limit_mm);
  const auto count = static_cast<std::size_t>(chords);
  if (static_cast<double>(path.moves.size()) + chords > kMostChords)
    throw ResourceError("the program needs more than 400 million moves at this chord error");
  path.chord_error_mm = std::max(path.chord_error_mm, chord_error_mm(sweep, chords));
  for (std::size_t i = 1; i < count; ++i)
    add_move(arc, point_at(sweep, arc, static_cast<double>(i) / chords), path);
  add_move(arc, arc.to, path);
}

}  // namespace

Toolpath to_toolpath(const Program& program, double chord_error_mm) {
  if (!(std::isfinite(chord_error_mm) && chord_error_mm > 0))
    throw std::invalid_argument("chord error must be greater than 0");
  Toolpath path;
  path.moves.reserve(program.motions.size());
  bool started = false;
  Vec3 at;
  for (const Motion& motion : program.motions) {
    if (started && motion.kind == MotionKind::arc) add_arc(motion, at, chord_error_mm, path);
    if (started && motion.kind != MotionKind::arc) add_move(motion, motion.to, path);
    at = motion.to;
    if (!started && motion.position_known) path.start = at, started = true;
  }
  return path;
}

std::string to_text(const Motion& motion) {
  std::string text = std::to_string(motion.line);
  const auto add = [&text](double value) { text.append(" ").append(shortest(value)); };
  const bool arc = motion.kind == MotionKind::arc;
  text += arc ? " arc " : motion.kind == MotionKind::rapid ? " rapid" : " feed";
  if (arc) text += std::to_string(static_cast<int>(motion.plane));
  for (const int axis : {0, 1, 2}) add(motion.to[axis]);
  if (!arc) return text;
  for (const double value : {motion.centre1, motion.centre2, motion.turns}) add(value);
  return text;
}

}  // namespace limitgauge::model
