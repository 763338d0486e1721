#include "model/gcode/turning/rotary_path.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "model/gcode/turning/turn_bend.h"
#include "model/text/fixed_number.h"
#include "model/text/number_text.h"

namespace limitgauge::model {
namespace {

/// A move is halved so often at most: 5 degrees are then 2e-5 degrees.
constexpr int kRotaryHalvings = 18;
constexpr double kSameAxis = 1e-12;

/// Axis and centre of a tool.
struct CentrePlace {
  Vec3 centre_mm, axis;
};

CentrePlace middle(const CentrePlace& a, const CentrePlace& b) {
  return {(a.centre_mm + b.centre_mm) / 2, normalized(a.axis + b.axis)};
}

double longest_way_deg(const RotaryAngles& a, const RotaryAngles& b) {
  double longest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) longest = std::max(longest, std::abs(a[i] - b[i]));
  return longest;
}

class RotaryPoster {
 public:
  RotaryPoster(const Toolpath& path, const ToolAxes& axes, const RotaryRequest& request)
      : path_(path), axes_(axes), request_(request) {
    require_axes(path, axes);
    if (!(request.bend_mm > 0)) throw std::invalid_argument("a bend is greater than 0");
  }

  RotaryPath post();

 private:
  struct Stand {
    RotaryAngles angles_deg{};
    CentrePlace at;
  };

  CentrePlace place(std::size_t move) const {
    return {path_.moves[move].to + axes_.to[move] * request_.centre_mm, axes_.to[move]};
  }
  bool turns_in_air(std::size_t move) const {
    return path_.moves[move].kind == MoveKind::rapid &&
           distance(axis_from(axes_, move), axes_.to[move]) > kSameAxis;
  }
  std::size_t end_of_chain(std::size_t first) const;
  std::vector<RotaryAngles> solutions(const Vec3& axis, const RotaryAngles& from_deg) const;
  std::optional<RotaryAngles> angles(const Vec3& axis, const RotaryAngles& from_deg) const;
  RotaryPlace named(const CentrePlace& at, const RotaryAngles& angles_deg, const Move& like) const;
  bool bends(const Stand& from, const RotaryAngles& to_deg, const CentrePlace& to) const;
  bool go(Stand& stand, const CentrePlace& to, const Move& like, int halvings,
          std::vector<RotaryPlace>& out);
  bool go_along(std::size_t first, std::size_t last, Stand stand, std::vector<RotaryPlace>& out);
  void chain(std::size_t first, std::size_t last);
  [[noreturn]] void refuse() const;

  const Toolpath& path_;
  const ToolAxes& axes_;
  const RotaryRequest& request_;
  Stand stand_;
  RotaryPath made_;
  CentrePlace stuck_;  ///< the last place that no angles were found for
};

/// Behind the moves that follow `first` without turning in the air.
std::size_t RotaryPoster::end_of_chain(std::size_t first) const {
  std::size_t end = first + 1;
  while (end < path_.moves.size() && !turns_in_air(end)) ++end;
  return end;
}

std::optional<RotaryAngles> RotaryPoster::angles(const Vec3& axis,
                                                 const RotaryAngles& from_deg) const {
  const Vec3 wanted = normalized(request_.machine_from_part.direction(axis));
  auto found = request_.machine.angles_for(wanted, from_deg);
  if (!found) return found;
  for (const RotaryAxis& rotary : request_.machine.axes) {
    double& angle = (*found)[rotary.index()];
    const double exact = angle, step = std::pow(10.0, -request_.decimals);
    angle = fixed(exact, request_.decimals).value;
    if (angle > rotary.high_deg) angle = fixed(angle - step, request_.decimals).value;
    if (angle < rotary.low_deg) angle = fixed(angle + step, request_.decimals).value;
  }
  return found;
}

/// All ways to put the tool along `axis` that are found from whole and half turns about where the
/// axes are, the nearest first.
std::vector<RotaryAngles> RotaryPoster::solutions(const Vec3& axis,
                                                  const RotaryAngles& from_deg) const {
  constexpr double kTurns_deg[] = {0, 180, -180, 360, -360};
  std::vector<RotaryAngles> found;
  const auto& rotary = request_.machine.axes;
  for (const double first : kTurns_deg) {
    for (const double second : kTurns_deg) {
      RotaryAngles from = from_deg;
      from[rotary.front().index()] += first;
      if (rotary.size() > 1) from[rotary.back().index()] += second;
      const auto angles_deg = angles(axis, from);
      const auto same = [&](const RotaryAngles& other) {
        return longest_way_deg(other, *angles_deg) < 1e-6;
      };
      if (angles_deg && std::none_of(found.begin(), found.end(), same))
        found.push_back(*angles_deg);
      if (rotary.size() < 2) break;
    }
  }
  std::stable_sort(found.begin(), found.end(), [&](const RotaryAngles& a, const RotaryAngles& b) {
    return longest_way_deg(a, from_deg) < longest_way_deg(b, from_deg);
  });
  return found;
}

/// The tip is where the axis, with the angles as they are written, leaves the centre in its place.
RotaryPlace RotaryPoster::named(const CentrePlace& at, const RotaryAngles& angles_deg,
                                const Move& like) const {
  const Vec3 axis = normalized(
      request_.machine_from_part.direction_back(request_.machine.stand({}, angles_deg, 0).axis));
  const Vec3 tip = at.centre_mm - axis * request_.centre_mm;
  return {rounded(request_.work_from_part.point(tip), request_.decimals), angles_deg, like.kind,
          like.feed_mm_min};
}

/// Whether the axes' even turn leaves the great circle by too much.
bool RotaryPoster::bends(const Stand& from, const RotaryAngles& to_deg,
                         const CentrePlace& to) const {
  if (longest_way_deg(from.angles_deg, to_deg) == 0) return false;
  TurningMotion motion;
  motion.frame.control = TipControl::tool_centre;
  motion.from_mm = from.at.centre_mm, motion.to_mm = to.centre_mm;
  motion.from_deg = from.angles_deg, motion.to_deg = to_deg;
  return TurnBend(request_.machine, motion).axis(1) * request_.centre_mm > request_.bend_mm;
}

bool RotaryPoster::go(Stand& stand, const CentrePlace& to, const Move& like, int halvings,
                      std::vector<RotaryPlace>& out) {
  const auto next = angles(to.axis, stand.angles_deg);
  if (next && !bends(stand, *next, to)) {
    out.push_back(named(to, *next, like));
    stand = {*next, to};
    return true;
  }
  stuck_ = to;
  if (!next || halvings == 0) return false;
  return go(stand, middle(stand.at, to), like, halvings - 1, out) &&
         go(stand, to, like, halvings - 1, out);
}

/// Moves [first, last) from where the tool stands; false where its axes cannot follow.
bool RotaryPoster::go_along(std::size_t first, std::size_t last, Stand stand,
                            std::vector<RotaryPlace>& out) {
  for (std::size_t i = first; i < last; ++i)
    if (!go(stand, place(i), path_.moves[i], kRotaryHalvings, out)) return false;
  stand_ = stand;
  return true;
}

/// A turn in the air to any of the ways to stand, and what follows it.
void RotaryPoster::chain(std::size_t first, std::size_t last) {
  const CentrePlace turned = place(first);
  stuck_ = turned;
  for (const RotaryAngles& angles_deg : solutions(turned.axis, stand_.angles_deg)) {
    std::vector<RotaryPlace> out{named(turned, angles_deg, path_.moves[first])};
    if (!go_along(first + 1, last, {angles_deg, turned}, out)) continue;
    made_.to.insert(made_.to.end(), out.begin(), out.end());
    return;
  }
  refuse();
}

void RotaryPoster::refuse() const {
  const auto words = [](const Vec3& v) {
    return "(" + six_digits(v.x) + ", " + six_digits(v.y) + ", " + six_digits(v.z) + ")";
  };
  throw std::invalid_argument("at " + words(stuck_.centre_mm) + " the tool is to stand along " +
                              words(stuck_.axis) +
                              ", where the machine's axes do not bring it within their limits "
                              "without a jump on the way");
}

RotaryPath RotaryPoster::post() {
  const Vec3 centre = path_.start + axes_.start * request_.centre_mm;
  stand_ = {{}, {centre, axes_.start}};
  const Vec3 upright = request_.machine_from_part.direction_back({0, 0, 1});
  if (distance(axes_.start, upright) > kSameAxis)
    throw std::invalid_argument("a path begins with its tool along the machine's Z");
  made_.start_mm = rounded(request_.work_from_part.point(path_.start), request_.decimals);
  for (std::size_t i = 0; i < path_.moves.size();) {
    const std::size_t end = end_of_chain(i);
    if (turns_in_air(i)) {
      chain(i, end);
    } else if (!go_along(i, end, stand_, made_.to)) {
      refuse();
    }
    i = end;
  }
  return std::move(made_);
}

}  // namespace

RotaryPath rotary_path(const Toolpath& path, const ToolAxes& axes, const RotaryRequest& request) {
  return RotaryPoster(path, axes, request).post();
}

}  // namespace limitgauge::model
