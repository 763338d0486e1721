#include "engine/strategy/linking/link_choice.h"

#include <algorithm>

namespace limitgauge::engine::strategy {
namespace {

using model::Vec3;

constexpr double kSecondsAMinute = 60;

}  // namespace

double LinkChooser::link_seconds(double length_mm) const {
  const CutOptions& cut = rule_.request.cut;
  const double feed = cut.link_feed_mm_min > 0 ? cut.link_feed_mm_min : cut.feed_mm_min;
  return kSecondsAMinute * length_mm / feed;
}

double LinkChooser::plunge_from_mm(const Vec3& to, std::optional<double> stands_to_mm) const {
  return std::max(to.z, stands_to_mm.value_or(to.z)) + rule_.air_mm;
}

double LinkChooser::rapid_to_mm(double tip_z_mm) const {
  const double top = model::bounding_box(rule_.request.stock).high.z;
  return std::min(clear_z_mm_, std::max(tip_z_mm, top + rule_.air_mm));
}

double LinkChooser::down_seconds(double from_z_mm, const Vec3& to,
                                 std::optional<double> stands_to_mm) const {
  const double plunge_from = std::min(from_z_mm, plunge_from_mm(to, stands_to_mm));
  return link_seconds(from_z_mm - plunge_from) +
         kSecondsAMinute * (plunge_from - to.z) / rule_.request.cut.plunge_feed_mm_min;
}

double LinkChooser::retract_seconds(const Vec3& from, const Vec3& to,
                                    std::optional<double> stands_to_mm) const {
  const double rapid_to = rapid_to_mm(plunge_from_mm(to, stands_to_mm));
  const double rapid = clear_z_mm_ - from.z + level_distance(from, to) + clear_z_mm_ - rapid_to;
  return kSecondsAMinute * rapid / rule_.request.rapid_mm_min +
         down_seconds(rapid_to, to, stands_to_mm);
}

double LinkChooser::least_seconds(const Vec3& from, const Vec3& to) const {
  return std::min(link_seconds(distance(from, to)), retract_seconds(from, to, std::nullopt));
}

std::optional<double> LinkChooser::height_over(const Vec3& from, const Vec3& to,
                                               std::optional<double> stands_to_mm) const {
  const double base = std::max({from.z, to.z, stands_to_mm.value_or(to.z)});
  const auto lift = rule_.locations.lift({from.x, from.y, base}, {to.x, to.y, base});
  const double over = base + std::max(0.0, lift.value_or(0)) + rule_.air_mm;
  return over < clear_z_mm_ ? std::optional(over) : std::nullopt;
}

std::optional<double> LinkChooser::raise(const Vec3& from, const Vec3& to) const {
  const double slack = std::max(rule_.slack_at(from), rule_.slack_at(to));
  if (rule_.locations.clears(from, to, slack)) return 0;
  const double lift = rule_.locations.lift(from, to).value_or(0);
  return lift <= rule_.air_mm ? std::optional(std::max(0.0, lift)) : std::nullopt;
}

Link LinkChooser::choose_from_above(const Vec3& from, const Vec3& to,
                                    std::optional<double> stands_to_mm) const {
  const Link retract{LinkKind::retract, retract_seconds(from, to, stands_to_mm), 0, clear_z_mm_};
  // What stands between is asked for the ball alone: a leaning tool goes above everything.
  if (rule_.request.cut.lean || link_seconds(level_distance(from, to)) >= retract.seconds)
    return retract;
  const auto over = height_over(from, to, stands_to_mm);
  if (!over) return retract;
  const double seconds = link_seconds(*over - from.z + level_distance(from, to)) +
                         down_seconds(*over, to, stands_to_mm);
  return seconds < retract.seconds ? Link{LinkKind::over, seconds, 0, *over} : retract;
}

Link LinkChooser::choose(const Vec3& from, const Vec3& to,
                         std::optional<double> stands_to_mm) const {
  const bool stands = stands_to_mm && *stands_to_mm > to.z;
  const double straight = link_seconds(distance(from, to));
  if (!stands && straight < retract_seconds(from, to, stands_to_mm))
    if (const auto raised = raise(from, to))
      return {LinkKind::straight, straight + link_seconds(2 * *raised), *raised, 0};
  return choose_from_above(from, to, stands_to_mm);
}

}  // namespace limitgauge::engine::strategy
