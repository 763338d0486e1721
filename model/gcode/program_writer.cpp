#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "model/base/tolerance.h"
#include "model/gcode/arc_fit.h"
#include "model/gcode/program.h"
#include "model/gcode/program_words.h"
#include "model/text/fixed_number.h"

namespace limitgauge::model {
namespace {

constexpr std::array<char, 3> kAxes = {'X', 'Y', 'Z'};
constexpr std::array<char, 3> kCentres = {'I', 'J', 'K'};

/// What the controller holds from earlier lines.
struct ModalState {
  Vec3 at;
  int motion = 0;
  ArcPlane plane = ArcPlane::xy;
  float feed_mm_min = 0;
};

class Writer {
 public:
  Writer(Toolpath& path, const WriterOptions& options, std::ostream& out)
      : path_(path),
        options_(options),
        rule_(rules(options.dialect)),
        text_(out, options.line_numbers) {}

  void write();

 private:
  FixedNumber number(double value) const {
    return fixed(value, options_.decimals, rule_.point_always);
  }
  void write_start();
  void write_moves_and_arcs();
  void write_move(Move& move);
  void write_arc(const FittedArc& arc, std::size_t first);
  void write_axes(const std::array<FixedNumber, 3>& to);
  void write_motion(int motion);
  void write_feed(float feed_mm_min);
  float rounded_feed(float feed_mm_min) const;
  void round_path();

  Toolpath& path_;
  const WriterOptions& options_;
  const DialectRules& rule_;
  ProgramWords text_;
  ModalState state_;
};

void Writer::write() {
  text_.write_head(options_);
  write_start();
  if (options_.arc_tolerance_mm) {
    write_moves_and_arcs();
  } else {
    for (Move& move : path_.moves) write_move(move);
  }
  text_.write_end(rule_);
}

/// The tool goes to its height first, then over the place.
void Writer::write_start() {
  path_.start = rounded(path_.start, options_.decimals);
  text_.word('G', "0");
  text_.word('Z', number(path_.start.z).text());
  text_.end_line();
  text_.word('X', number(path_.start.x).text());
  text_.word('Y', number(path_.start.y).text());
  text_.end_line();
  state_.at = path_.start;
}

/// Arcs go through the points as they are written.
void Writer::round_path() {
  for (Move& move : path_.moves) {
    move.to = rounded(move.to, options_.decimals);
    if (move.kind == MoveKind::feed) move.feed_mm_min = rounded_feed(move.feed_mm_min);
  }
}

void Writer::write_moves_and_arcs() {
  round_path();
  ArcFitter fitter(path_, *options_.arc_tolerance_mm, options_.decimals);
  for (std::size_t i = 0; i < path_.moves.size();) {
    if (const std::optional<FittedArc> arc = fitter.from(i)) {
      write_arc(*arc, i);
      i += arc->moves;
    } else {
      write_move(path_.moves[i++]);
    }
  }
}

void Writer::write_move(Move& move) {
  const std::array<FixedNumber, 3> to = {number(move.to.x), number(move.to.y), number(move.to.z)};
  const bool rapid = move.kind == MoveKind::rapid;
  write_motion(rapid ? 0 : 1);
  write_axes(to);
  move.feed_mm_min = rapid ? 0 : rounded_feed(move.feed_mm_min);
  if (!rapid) write_feed(move.feed_mm_min);
  move.to = state_.at = {to[0].value, to[1].value, to[2].value};
  move.set_line(text_.line_number());
  text_.end_line();
}

void Writer::write_arc(const FittedArc& arc, std::size_t first) {
  const auto [one, two, normal] = axes_of(arc.plane);
  const Move& last = path_.moves[first + arc.moves - 1];
  if (arc.plane != state_.plane) text_.word('G', std::to_string(static_cast<int>(arc.plane)));
  state_.plane = arc.plane;
  write_motion(arc.counter_clockwise ? 3 : 2);
  text_.word(kAxes[one], number(last.to[one]).text());
  text_.word(kAxes[two], number(last.to[two]).text());
  text_.word(kCentres[one], number(arc.offset.x).text());
  text_.word(kCentres[two], number(arc.offset.y).text());
  write_feed(last.feed_mm_min);
  state_.at = last.to;
  for (std::size_t i = first; i < first + arc.moves; ++i)
    path_.moves[i].set_line(text_.line_number());
  text_.end_line();
}

void Writer::write_motion(int motion) {
  if (motion != state_.motion) text_.word('G', std::to_string(motion));
  state_.motion = motion;
}

void Writer::write_axes(const std::array<FixedNumber, 3>& to) {
  bool written = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (to[axis].value == state_.at[axis]) continue;
    text_.word(kAxes[axis], to[axis].text());
    written = true;
  }
  // A move of no length must still be a line with a motion on it.
  if (!written) text_.word(kAxes[0], to[0].text());
}

float Writer::rounded_feed(float feed_mm_min) const {
  if (!rule_.feed_decimals) return feed_mm_min;
  return static_cast<float>(fixed(feed_mm_min, *rule_.feed_decimals).value);
}

void Writer::write_feed(float feed_mm_min) {
  if (feed_mm_min == state_.feed_mm_min) return;
  state_.feed_mm_min = feed_mm_min;
  text_.feed(feed_mm_min, rule_);
}

}  // namespace

void write_program(Toolpath& path, const WriterOptions& options, std::ostream& out) {
  require_writable(path, options);
  Writer(path, options, out).write();
}

}  // namespace limitgauge::model
