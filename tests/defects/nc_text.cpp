#include "tests/defects/nc_text.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "model/gcode/program_path.h"

namespace limitgauge::tests::defects {
namespace {

using model::Vec3;

constexpr double kChordError_mm = 1e-5;  // no arcs are written

std::string word(char letter, double value) {
  char text[40];
  std::snprintf(text, sizeof text, " %c%.6f", letter, value);
  return text;
}

/// Writes lines; in modal form without what the controller still holds.
class LineWriter {
 public:
  explicit LineWriter(bool modal) : modal_(modal) {}

  std::string line(const Block& block) {
    std::string text;
    put(text, block.rapid ? "G0" : "G1", motion_);
    for (int axis = 0; axis < 3; ++axis) put(text, word("XYZ"[axis], block.to[axis]), axis_[axis]);
    if (!block.rapid) put(text, " F1000", feed_);
    // A line must say where to, even when that is where the tool stands.
    if (text.find_first_of("XYZ") == std::string::npos) text += axis_[2];
    return text;
  }

 private:
  void put(std::string& text, const std::string& what, std::string& held) const {
    if (modal_ && what == held) return;
    text += what;
    held = what;
  }

  bool modal_;
  std::string motion_, feed_, axis_[3];
};

}  // namespace

std::string NcText::text() const {
  std::string out = "(raster)\nG21 G90 G94 G17 G40 G49\nG54\n";
  LineWriter writer(modal);
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    for (const Insertion& i : insertions)
      if (i.before == k) out += i.line + "\n";
    const std::string line = writer.line(blocks[k]);
    if (!std::count(dropped.begin(), dropped.end(), k)) out += line + "\n";
  }
  return out + "M30\n";
}

NcText program_of(const Rows& rows, double safe_z_mm, bool modal) {
  NcText program;
  program.modal = modal;
  const auto over = [&](const Vec3& p) { return Vec3{p.x, p.y, safe_z_mm}; };
  for (std::size_t r = 0; r < rows.tips.size(); ++r) {
    const auto& tips = rows.tips[r];
    const int row = static_cast<int>(r);
    program.blocks.push_back({true, over(tips.front()), row});
    for (const Vec3& tip : tips) program.blocks.push_back({false, tip, row});
    program.blocks.push_back({true, over(tips.back()), row});
  }
  return program;
}

model::Toolpath read_back(const std::string& text) {
  std::istringstream in(text);
  return model::to_toolpath(model::read_program(in, "program.ngc"), kChordError_mm);
}

}  // namespace limitgauge::tests::defects
