#include "model/gcode/turning/turning_program.h"

#include <array>
#include <stdexcept>
#include <string>

#include "model/gcode/program_words.h"
#include "model/text/fixed_number.h"

namespace limitgauge::model {
namespace {

constexpr std::array<char, 3> kPlaceWords = {'X', 'Y', 'Z'};

/// The words of a control around what is named with the tip under control.
struct TipWords {
  bool numbered = true;  ///< the length's number, H, goes with them
  std::string_view on, off;
};

TipWords tip_words(Control control) {
  if (control == Control::linuxcnc) return {false, "M428", "M429"};
  return {true, control == Control::haas ? "G234" : "G43.4", "G49"};
}

class TurningProgramWriter {
 public:
  TurningProgramWriter(const RotaryPath& path, const TurningWriter& writer, std::ostream& out)
      : path_(path),
        writer_(writer),
        rule_(rules(writer.text.dialect)),
        text_(out, writer.text.line_numbers) {}

  /// The line of the first place.
  std::uint32_t write();

 private:
  FixedNumber number(double value) const {
    return fixed(value, writer_.text.decimals, rule_.point_always);
  }
  void write_start();
  void write_length(std::string_view words);
  void write_place(const RotaryPlace& place);
  bool write_tip(const Vec3& tip_mm);
  bool write_angles(const RotaryAngles& angles_deg);
  void write_feed(float feed_mm_min);

  const RotaryPath& path_;
  const TurningWriter& writer_;
  const DialectRules& rule_;
  ProgramWords text_;
  Vec3 at_mm_;
  RotaryAngles angles_deg_{};
  int motion_ = 0;
  float feed_mm_min_ = 0;
};

std::uint32_t TurningProgramWriter::write() {
  const TipWords words = tip_words(writer_.control);
  text_.write_head(writer_.text);
  write_start();
  if (words.numbered) {
    write_length(words.on);
  } else {
    text_.line(words.on);
  }
  const std::uint32_t first = text_.line_number();
  for (const RotaryPlace& place : path_.to) write_place(place);
  text_.line(words.off);
  text_.write_end(rule_);
  return first;
}

/// The axes first, then the tool to its height, then over the place.
void TurningProgramWriter::write_start() {
  text_.words("G0");
  for (const RotaryAxis& axis : writer_.machine.axes) text_.word(axis.word, number(0).text());
  text_.end_line();
  if (tip_words(writer_.control).numbered) {
    write_length("G43");
  } else {
    text_.line("G43");
  }
  at_mm_ = path_.start_mm;
  text_.word('Z', number(at_mm_.z).text());
  text_.end_line();
  text_.word('X', number(at_mm_.x).text());
  text_.word('Y', number(at_mm_.y).text());
  text_.end_line();
}

void TurningProgramWriter::write_length(std::string_view words) {
  text_.words(words);
  text_.word('H', std::to_string(writer_.text.tool_number));
  text_.end_line();
}

void TurningProgramWriter::write_place(const RotaryPlace& place) {
  const int motion = place.kind == MoveKind::rapid ? 0 : 1;
  if (motion != motion_) text_.word('G', std::to_string(motion));
  motion_ = motion;
  const bool moved = write_tip(place.tip_mm);
  // A move of no length must still be a line with a motion on it.
  if (!write_angles(place.angles_deg) && !moved) text_.word('X', number(at_mm_.x).text());
  if (motion == 1) write_feed(place.feed_mm_min);
  text_.end_line();
}

bool TurningProgramWriter::write_tip(const Vec3& tip_mm) {
  const Vec3 from_mm = at_mm_;
  at_mm_ = tip_mm;
  for (int axis = 0; axis < 3; ++axis)
    if (tip_mm[axis] != from_mm[axis])
      text_.word(kPlaceWords[static_cast<std::size_t>(axis)], number(tip_mm[axis]).text());
  return !(tip_mm == from_mm);
}

bool TurningProgramWriter::write_angles(const RotaryAngles& angles_deg) {
  bool turned = false;
  for (const RotaryAxis& axis : writer_.machine.axes) {
    const double angle_deg = angles_deg[axis.index()];
    if (angle_deg == angles_deg_[axis.index()]) continue;
    text_.word(axis.word, number(angle_deg).text());
    turned = true;
  }
  angles_deg_ = angles_deg;
  return turned;
}

void TurningProgramWriter::write_feed(float feed_mm_min) {
  if (feed_mm_min == feed_mm_min_) return;
  feed_mm_min_ = feed_mm_min;
  text_.feed(feed_mm_min, rule_);
}

Toolpath tip_path_of(const RotaryPath& path) {
  Toolpath tips;
  tips.start = path.start_mm;
  for (const RotaryPlace& place : path.to)
    tips.moves.emplace_back(place.tip_mm, place.feed_mm_min, 0U, place.kind);
  return tips;
}

}  // namespace

bool has_tip_control(Control control) {
  return control == Control::fanuc || control == Control::haas || control == Control::linuxcnc;
}

Dialect dialect_for(Control control) {
  return control == Control::linuxcnc ? Dialect::linuxcnc : Dialect::fanuc;
}

std::uint32_t write_turning_program(const RotaryPath& path, const TurningWriter& writer,
                                    std::ostream& out) {
  if (!has_tip_control(writer.control) || writer.text.dialect != dialect_for(writer.control))
    throw std::invalid_argument("the control's dialect has no words for a tip under control");
  require_writable(tip_path_of(path), writer.text);
  return TurningProgramWriter(path, writer, out).write();
}

}  // namespace limitgauge::model
