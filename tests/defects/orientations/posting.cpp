#include "tests/defects/orientations/posting.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/printed.h"

namespace limitgauge::tests::defects {
namespace {

using model::Pose;
using model::Vec3;

constexpr double kBegin_mm = 200;   ///< Z over the work's zero at which a program begins
constexpr double kParked_mm = 300;  ///< stands for wherever G28 takes Z

/// What six decimals leave of a place.
Vec3 as_written(const Vec3& p) {
  const auto rounded = [](double v) { return std::round(v * 1e6) / 1e6; };
  return {rounded(p.x), rounded(p.y), rounded(p.z)};
}
std::string axis_words(const Vec3& p) {
  return printed(" X%.6f Y%.6f Z%.6f", p.x, p.y, p.z);
}

/// Angles about Z, X and Z again that make a rotation, in degrees.
std::array<double, 3> euler_of(const Pose& m) {
  constexpr double kDegree = 180 / std::numbers::pi;
  const double j = std::acos(std::clamp(m.rows[2].z, -1.0, 1.0));
  if (std::abs(std::sin(j)) < 1e-12)
    return {std::atan2(m.rows[1].x, m.rows[0].x) * kDegree, m.rows[2].z > 0 ? 0.0 : 180.0, 0};
  return {std::atan2(m.rows[0].z, -m.rows[1].z) * kDegree, j * kDegree,
          std::atan2(m.rows[2].x, m.rows[2].y) * kDegree};
}
Pose euler_turn(const std::array<double, 3>& angles_deg) {
  return turned_about({0, 0, 1}, angles_deg[0]) * turned_about({1, 0, 0}, angles_deg[1]) *
         turned_about({0, 0, 1}, angles_deg[2]);
}

template <std::size_t n>
void slip_in(std::array<double, n>& stated, const std::array<double, n>& before,
             const WordSlip& slip) {
  double& word = stated[slip.word];
  if (slip.kind == WordSlip::Kind::added) word += slip.by_deg;
  if (slip.kind == WordSlip::Kind::negated) word = -word;
  if (slip.kind == WordSlip::Kind::lost) word = before[slip.word];
}

/// Where the tool changes its way to stand: at a rapid that follows a rapid.
std::vector<std::size_t> changes(const NcText& program, std::size_t ways) {
  std::vector<std::size_t> clear, out;
  for (std::size_t k = 1; k < program.blocks.size(); ++k)
    if (program.blocks[k].rapid && program.blocks[k - 1].rapid) clear.push_back(k);
  for (std::size_t w = 1; w < ways; ++w) out.push_back(clear[clear.size() * w / ways]);
  return out;
}

class Post {
 public:
  Post(const NcText& program, const Posting& believed, const Machine& real, const Pose& truly)
      : program_(program), believed_(believed), real_(real), truly_(truly) {}

  Posted run() {
    const std::vector<std::size_t> at = changes(program_, believed_.ways.size());
    begin();
    enter(0);
    for (std::size_t k = 0, way = 0; k < program_.blocks.size(); ++k) {
      if (way < at.size() && k == at[way]) {
        leave();
        enter(++way);
        go_back_to(k - 1);
      }
      move(program_.blocks[k], k, way);
    }
    leave();
    line(rotary_words({0, 0}));
    line("M5");
    line("M30");
    return std::move(out_);
  }

 private:
  void line(const std::string& text) { out_.text += text + "\n", ++lines_; }

  void begin() {
    line("G21 G90 G94 G17 G40 G49");
    line("G54");
    line("T1 M6");
    line("S8000 M3");
    line(believed_.control == "linuxcnc" ? "G43" : "G43 H1");
    line(printed("G0 Z%.0f", kBegin_mm));
  }

  std::string rotary_words(const Angles& angles) const {
    std::string text = "G0";
    for (std::size_t i = 0; i < angles.size(); ++i)
      if (lost_ != i) text += printed(" %c%.9g", believed_.machine.axes[i].word, angles[i]);
    return text;
  }

  /// Turns to a way to stand. `stood_` is where the axes truly stand afterwards.
  void enter(std::size_t way) {
    way_ = way;
    const bool slips = believed_.slip && way + 1 == believed_.ways.size();
    out_.stretches.emplace_back();
    if (believed_.places == Places::plane) return enter_plane(slips);
    const Angles before = stood_;
    stood_ = believed_.ways[way];
    if (slips) slip_in(stood_, before, *believed_.slip);
    if (slips && believed_.slip->kind == WordSlip::Kind::lost) lost_ = believed_.slip->word;
    line(rotary_words(stood_));
    lost_.reset();
    if (believed_.places == Places::tip)
      line(believed_.control == "linuxcnc" ? "M428" : "G43.4 H1");
    if (believed_.places == Places::offset) line("G254");
    upright_ = real_.upright(stood_);
    out_.stretches.back().lying = upright_ * truly_;
    out_.stretches.back().start = upright_.point(real_.tip_mm({0, 0, kBegin_mm}, stood_));
  }

  /// A plane's zero is the part's, its axes lie as the tool sees them.
  void enter_plane(bool slips) {
    const Pose turn = believed_.machine.upright(believed_.ways[way_]).inverse();
    std::array<double, 3> stated = euler_of(turn);
    if (slips) slip_in(stated, {}, *believed_.slip);
    Pose plane = euler_turn(stated);
    plane.shift_mm = as_written(believed_.lying.shift_mm);
    line("G68.2" + axis_words(plane.shift_mm) +
         printed(" I%.12g J%.12g K%.12g", stated[0], stated[1], stated[2]));
    line("G53.1");
    // From far above: by which angles the axes get there is the control's choice.
    out_.stretches.back().lying = plane.inverse() * truly_;
    out_.stretches.back().start = {0, 0, kParked_mm};
  }

  void leave() {
    if (believed_.places == Places::plane) line("G69");
    if (believed_.places == Places::offset) line("G255");
    if (believed_.places == Places::tip && believed_.control == "linuxcnc") line("M429");
    if (believed_.places == Places::tip && believed_.control != "linuxcnc")
      line("G49"), line("G43 H1");
    line("G91 G28 Z0");
    line("G90");
    // There it is out of effect on the other controls.
    if (believed_.control != "linuxcnc") line("G43 H1");
  }

  /// What the program says of the part's place p, and where that truly is in the stretch's frame.
  Vec3 said(const Vec3& p) const {
    const Machine& m = believed_.machine;
    const Angles& angles = believed_.ways[way_];
    const Vec3 work = believed_.lying.point(p);
    if (believed_.places == Places::tip) return work;
    if (believed_.places == Places::plane)
      return m.upright(angles).direction(work - believed_.lying.shift_mm);
    if (believed_.places == Places::joints) return m.joints_mm(work, angles);
    return m.table(angles).direction(work);
  }
  Vec3 done(const Vec3& said) const {
    if (believed_.places == Places::plane) return said;
    if (believed_.places == Places::tip) return upright_.direction(said);
    if (believed_.places == Places::joints) return upright_.direction(real_.tip_mm(said, stood_));
    return upright_.direction(real_.table(stood_).direction_back(said));
  }

  /// After a turn, with Z parked: over the place where the tool was, then down.
  void go_back_to(std::size_t block) {
    const Vec3 p = as_written(said(program_.blocks[block].to));
    line(printed("G0 X%.6f Y%.6f", p.x, p.y));
    line(printed("G0 Z%.6f", p.z));
    Stretch& stretch = out_.stretches.back();
    stretch.start = done(p) + Vec3{0, 0, kParked_mm};
    stretch.moves.push_back({true, done(p), lines_, block});
  }

  void move(const Block& block, std::size_t k, std::size_t) {
    const Vec3 p = as_written(said(block.to));
    line((block.rapid ? "G0" : "G1") + axis_words(p) + (block.rapid ? "" : " F1000"));
    out_.stretches.back().moves.push_back({block.rapid, done(p), lines_, k});
  }

  const NcText& program_;
  const Posting& believed_;
  const Machine& real_;
  Pose truly_;
  Posted out_;
  std::size_t lines_ = 0, way_ = 0;
  std::optional<std::size_t> lost_;
  Angles stood_{};
  Pose upright_;
};

}  // namespace

const char* name(Places places) {
  switch (places) {
    case Places::joints:
      return "joints";
    case Places::tip:
      return "tip";
    case Places::plane:
      return "tilted plane";
    case Places::offset:
      return "dynamic offset";
  }
  return "";
}

Posted post(const NcText& program, const Posting& believed, const Machine& real,
            const Pose& truly) {
  return Post(program, believed, real, truly).run();
}

Posted post_still(const NcText& program, const Pose& believed, const Pose& truly) {
  Posted out;
  out.text = "G21 G90 G94 G17 G40 G49\nG54\n";
  out.stretches.push_back({truly, {0, 0, kParked_mm}, {}});
  for (std::size_t k = 0; k < program.blocks.size(); ++k) {
    const Block& block = program.blocks[k];
    const Vec3 p = as_written(believed.point(block.to));
    out.text += (block.rapid ? "G0" : "G1") + axis_words(p) + (block.rapid ? "\n" : " F1000\n");
    out.stretches.back().moves.push_back({block.rapid, p, k + 3, k});
  }
  out.text += "M30\n";
  return out;
}

}  // namespace limitgauge::tests::defects
