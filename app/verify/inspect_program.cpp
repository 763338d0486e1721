#include "app/verify/inspect_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "model/base/number_text.h"
#include "model/gcode/program.h"

namespace limitgauge::app {
namespace {

using model::Motion;
using model::MotionKind;

/// Six decimals: a nanometre, finer than any program states. No "-0.000000".
std::string fixed(double value) {
  constexpr double kHalfUnit = 0.5e-6;
  std::array<char, 64> text{};
  const int length =
      std::snprintf(text.data(), text.size(), "%.6f", std::abs(value) < kHalfUnit ? 0.0 : value);
  return {text.data(), static_cast<std::size_t>(std::max(0, length))};
}

void print_motion(std::ostream& out, const Motion& motion) {
  out << motion.line << ' ';
  if (motion.kind == MotionKind::rapid) out << "rapid";
  if (motion.kind == MotionKind::feed) out << "feed";
  if (motion.kind == MotionKind::arc) out << "arc " << static_cast<int>(motion.plane);
  out << ' ' << fixed(motion.to.x) << ' ' << fixed(motion.to.y) << ' ' << fixed(motion.to.z);
  if (motion.kind == MotionKind::arc) {
    out << ' ' << fixed(motion.centre1) << ' ' << fixed(motion.centre2) << ' '
        << model::shortest(motion.turns);
  }
  out << '\n';
}

/// Where the program starts nobody stated: axes that it has not named stand at 0.
void print_start(std::ostream& out, const model::Program& program) {
  const auto leaning = std::find_if(program.motions.begin(), program.motions.end(),
                                    [](const Motion& motion) { return !motion.position_known; });
  if (leaning == program.motions.end()) return;
  out << "assumed: line " << leaning->line
      << ", moves before X, Y and Z have all been named; the others stand at 0 (--start)\n";
}

void print_summary(std::ostream& out, const model::Program& program) {
  const auto count = [&](MotionKind kind) {
    return std::count_if(program.motions.begin(), program.motions.end(),
                         [&](const Motion& motion) { return motion.kind == kind; });
  };
  model::Box3 box;
  for (const Motion& motion : program.motions) {
    box.add(motion.to);
  }
  out << "rapids        " << count(MotionKind::rapid) << '\n'
      << "feeds         " << count(MotionKind::feed) << '\n'
      << "arcs          " << count(MotionKind::arc) << '\n';
  if (!box.empty()) {
    out << "end points    " << fixed(box.low.x) << ' ' << fixed(box.low.y) << ' '
        << fixed(box.low.z) << " to " << fixed(box.high.x) << ' ' << fixed(box.high.y) << ' '
        << fixed(box.high.z) << " mm\n";
  }
  out << "tools         " << program.tool_changes.size() << " changes\n";
  for (const std::string& said : program.assumed) out << "assumed: " << said << '\n';
  print_start(out, program);
  out << "words set aside " << program.ignored.size() << '\n';
  for (const model::IgnoredWord& word : program.ignored) {
    out << "  line " << word.line << ": " << word.word << '\n';
  }
}

}  // namespace

void inspect_program(const InspectCommand& command, const CommonOptions& common,
                     const Console& console) {
  model::MachineSetup machine = machine_of(command.machine);
  machine.assume_fresh_machine = true;
  const model::Program program = model::read_program(command.file, machine);
  if (command.moves) {
    for (const Motion& motion : program.motions) print_motion(console.out, motion);
    console.out << std::flush;
  } else if (!common.quiet) {
    print_summary(console.out, program);
    console.out << std::flush;
  }
}

}  // namespace limitgauge::app
