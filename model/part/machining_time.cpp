#include "model/part/machining_time.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace limitgauge::model {
namespace {

constexpr double kSecondsPerMinute = 60;

/// A move that takes time, and how fast it may begin.
struct Leg {
  double length_mm = 0;
  double speed_mm_s = 0;
  double begin_squared = 0;  ///< (mm/s)²
};

double rate_mm_min(const Move& move, const MachineRates& machine) {
  return move.kind == MoveKind::rapid ? machine.rapid_mm_min
                                      : static_cast<double>(move.feed_mm_min);
}

/// The moves with the speeds at which their corners can be passed, each on its own.
std::vector<Leg> legs_of(const Toolpath& path, const MachineRates& machine) {
  std::vector<Leg> legs;
  legs.reserve(path.moves.size());
  Vec3 before;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 along = path.moves[i].to - move_from(path, i);
    Leg leg{length(along), rate_mm_min(path.moves[i], machine) / kSecondsPerMinute, 0};
    if (!(leg.length_mm > 0 && leg.speed_mm_s > 0)) continue;
    const Vec3 direction = along / leg.length_mm;
    if (!legs.empty()) {
      const Leg& last = legs.back();
      const double slower = std::min(last.speed_mm_s, leg.speed_mm_s);
      leg.begin_squared =
          std::min(slower * slower, corner_speed_squared(before, last.length_mm, direction,
                                                         leg.length_mm, *machine.acceleration_mm_s2,
                                                         machine.junction_deviation_mm));
    }
    legs.push_back(leg);
    before = direction;
  }
  return legs;
}

/// Lowers the speeds at corners to what can be slowed down from and sped up to between them.
void look_ahead(std::vector<Leg>& legs, double acceleration_mm_s2) {
  double next = 0;
  for (auto leg = legs.rbegin(); leg != legs.rend(); ++leg) {
    leg->begin_squared =
        std::min(leg->begin_squared, next + 2 * acceleration_mm_s2 * leg->length_mm);
    next = leg->begin_squared;
  }
  for (std::size_t i = 1; i < legs.size(); ++i) {
    legs[i].begin_squared =
        std::min(legs[i].begin_squared,
                 legs[i - 1].begin_squared + 2 * acceleration_mm_s2 * legs[i - 1].length_mm);
  }
}

/// A trapezoid of speed over time, or a triangle where the move is too short for its feed.
double time_s(const Leg& leg, double end_squared, double acceleration_mm_s2) {
  const double highest_squared =
      (leg.begin_squared + end_squared) / 2 + acceleration_mm_s2 * leg.length_mm;
  const double top = std::min(leg.speed_mm_s, std::sqrt(highest_squared));
  const double changing_mm =
      (2 * top * top - leg.begin_squared - end_squared) / (2 * acceleration_mm_s2);
  const double changing_s =
      (2 * top - std::sqrt(leg.begin_squared) - std::sqrt(end_squared)) / acceleration_mm_s2;
  const double even_s = std::max(0.0, leg.length_mm - changing_mm) / leg.speed_mm_s;
  return changing_s + (top < leg.speed_mm_s ? 0 : even_s);
}

}  // namespace

double corner_speed_squared(const Vec3& before, double before_mm, const Vec3& after,
                            double after_mm, double acceleration_mm_s2, double deviation_mm) {
  // Half the turn from one direction to the other; differences keep small turns exact.
  const double sine = std::min(1.0, length(after - before) / 2);
  const double cosine = std::min(1.0, length(after + before) / 2);
  if (sine == 0) return std::numeric_limits<double>::infinity();
  const double by_deviation_mm = deviation_mm * cosine * (1 + cosine) / (sine * sine);
  const double by_length_mm = std::min(before_mm, after_mm) / 2 * cosine / sine;
  return acceleration_mm_s2 * std::min(by_deviation_mm, by_length_mm);
}

double machining_time_s(const Toolpath& path, const MachineRates& machine) {
  if (!machine.acceleration_mm_s2) return lengths(path, machine.rapid_mm_min).time_s;
  const double acceleration_mm_s2 = *machine.acceleration_mm_s2;
  if (!(acceleration_mm_s2 > 0)) throw std::invalid_argument("acceleration must be greater than 0");
  if (!(machine.junction_deviation_mm > 0))
    throw std::invalid_argument("junction deviation must be greater than 0");
  std::vector<Leg> legs = legs_of(path, machine);
  look_ahead(legs, acceleration_mm_s2);
  double sum_s = 0;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const double end = i + 1 < legs.size() ? legs[i + 1].begin_squared : 0;
    sum_s += time_s(legs[i], end, acceleration_mm_s2);
  }
  return sum_s;
}

}  // namespace limitgauge::model
