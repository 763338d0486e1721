#include "model/gcode/dialect.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "model/gcode/program_path.h"
#include "model/gcode/read/arc.h"
#include "tests/support/catch.h"

using namespace limitgauge::model;

namespace {

constexpr std::array kDialects = {Dialect::linuxcnc, Dialect::fanuc, Dialect::grbl};
/// Of the chords that arcs are read back as.
constexpr double kDialectChordMm = 1e-4;

std::string written(Toolpath& path, const WriterOptions& options) {
  std::ostringstream out;
  write_program(path, options, out);
  return out.str();
}

Program program_of(const std::string& text) {
  std::istringstream in(text);
  return read_program(in, "written.ngc");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// A rapid, a plunge, a row, a quarter circle of 2 mm in each plane, a retract. The arcs pass
/// between the points of the chords and their middles, which lie 0.0004 mm further in: that moves
/// their centres away by 0.0009 mm along both axes.
Toolpath sample_path() {
  Toolpath path;
  path.start = {0, 0, 10};
  path.moves = {{{1, 2, 10}, 0, 0, MoveKind::rapid},
                {{1, 2, 0}, 1000.0F / 3, 0, MoveKind::feed},
                {{3, 2, 0}, 600, 0, MoveKind::feed}};
  for (const ArcPlane plane : {ArcPlane::xy, ArcPlane::zx, ArcPlane::yz}) {
    const auto [one, two, normal] = axes_of(plane);
    const Vec3 from = path.moves.back().to;
    for (int i = 1; i <= 40; ++i) {
      const double angle = std::numbers::pi / 80 * i;
      Vec3 to = from;
      to[one] += 2 * std::sin(angle);
      to[two] += 2 * (1 - std::cos(angle));
      path.moves.emplace_back(to, 600.0F, 0, MoveKind::feed);
    }
    path.moves.emplace_back(path.moves.back().to + Vec3{1, 1, 1}, 600.0F, 0, MoveKind::feed);
  }
  path.moves.emplace_back(Vec3{1, 2, 10}, 0.0F, 0, MoveKind::rapid);
  return path;
}

/// Rows, curves in every plane, jumps, repeated points and changing feeds.
Toolpath random_path(std::mt19937& random) {
  std::uniform_real_distribution<double> number(-1, 1);
  Toolpath path;
  path.start = Vec3{number(random), number(random), number(random)} * 100.0;
  Vec3 at = path.start;
  float feed = 100;
  while (path.moves.size() < 150) {
    if (random() % 3 == 0) feed = static_cast<float>(std::pow(10, 2 + 1.5 * number(random)));
    const auto kind = random() % 4 == 0 ? MoveKind::rapid : MoveKind::feed;
    if (random() % 2 == 0) {
      at = Vec3{number(random), number(random), number(random)} * 100.0;
      path.moves.emplace_back(at, feed, 0, kind);
      continue;
    }
    const auto [one, two, normal] =
        axes_of(std::array{ArcPlane::xy, ArcPlane::zx, ArcPlane::yz}[random() % 3]);
    const double radius = 1 + 10 * std::abs(number(random)), step = 0.02 * number(random);
    const Vec3 from = at;
    for (int i = 1; i <= 20; ++i) {
      at[one] = from[one] + radius * std::sin(step * i);
      at[two] = from[two] + radius * (1 - std::cos(step * i));
      path.moves.emplace_back(at, feed, 0, kind);
    }
  }
  return path;
}

void check_same(const Toolpath& a, const Toolpath& b) {
  CHECK(a.start == b.start);
  REQUIRE(a.moves.size() == b.moves.size());
  for (std::size_t i = 0; i < a.moves.size(); ++i) {
    const bool same = a.moves[i].to == b.moves[i].to && a.moves[i].kind == b.moves[i].kind &&
                      a.moves[i].feed_mm_min == b.moves[i].feed_mm_min &&
                      a.moves[i].line == b.moves[i].line;
    if (!same) FAIL_CHECK("move " << i << " differs");
  }
}

/// The path that arcs stand for, and the path read back: the ends of each line's moves are the
/// same, and the lengths agree as far as curves within the tolerance of each other must.
void check_same_but_for_arcs(const Toolpath& path, const Program& program) {
  const Toolpath back = to_toolpath(program, kDialectChordMm);
  CHECK(path.start == back.start);
  std::size_t at = 0;
  for (const Motion& motion : program.motions) {
    std::size_t count = 0;
    while (at + count < path.moves.size() && path.moves[at + count].line == motion.line) ++count;
    if (count == 0) continue;  // over the start
    const Move& last = path.moves[at + count - 1];
    CHECK(last.to == motion.to);
    CHECK((last.kind == MoveKind::rapid) == (motion.kind == MotionKind::rapid));
    CHECK(last.feed_mm_min == (last.kind == MoveKind::rapid ? 0 : motion.feed_mm_min));
    CHECK((count >= 3) == (motion.kind == MotionKind::arc));
    at += count;
  }
  CHECK(at == path.moves.size());
}

}  // namespace

TEST_CASE("LinuxCNC programs with arcs and line numbers", "[unit][program]") {
  Toolpath path = sample_path();
  const std::string text =
      written(path, {.program_name = "part", .arc_tolerance_mm = 0.002, .line_numbers = true});
  CHECK(text ==
        "(part)\nN1 G21 G90 G94 G17 G40 G49\nN2 G91.1\nN3 T1 M6\nN4 G0 Z10\nN5 X0 Y0\nN6 X1 Y2\n"
        "N7 G1 Z0 F333.33334\nN8 X3 F600\nN9 G3 X5 Y4 I-0.0009 J2.0009\nN10 G1 X6 Y5 Z1\n"
        "N11 G18 G3 Z3 X8 K-0.0009 I2.0009\nN12 G1 X9 Y6 Z4\nN13 G19 G3 Y8 Z6 J-0.0009 "
        "K2.0009\nN14 G1 X10 Y9 Z7\n"
        "N15 G0 X1 Y2 Z10\nN16 M5\nN17 M30\n");
}

TEST_CASE("Fanuc programs have points, capitals and a number", "[unit][program]") {
  Toolpath path = sample_path();
  const std::string text = written(path, {.program_name = "Part (1)",
                                          .comment = "ball:D=6; 100%\nna\xC3\xAFve",
                                          .decimals = 3,
                                          .spindle_rpm = 12000.4,
                                          .tool_number = 12,
                                          .dialect = Dialect::fanuc,
                                          .arc_tolerance_mm = 0.002});
  CHECK(text ==
        "%\nO0012\n(PART  1 )\n(BALL D=6  100 )\n(NA  VE)\nG21\nG17 G40 G49 G54 G80 G90 G94\n"
        "T12 M6\nM3 S12000\nG0 Z10.\nX0. Y0.\nX1. Y2.\nG1 Z0. F333.333\nX3. F600.\n"
        "G3 X5. Y4. I0. J2.\nG1 X6. Y5. Z1.\nG18 G3 Z3. X8. K0. I2.\nG1 X9. Y6. Z4.\n"
        "G19 G3 Y8. Z6. J0. K2.\nG1 X10. Y9. Z7.\nG0 X1. Y2. Z10.\nM5\nM30\n%\n");
}

TEST_CASE("Grbl programs have no tool change and no percent sign", "[unit][program]") {
  Toolpath path = sample_path();
  const std::string text = written(
      path,
      {.program_name = "part", .spindle_rpm = 9000, .tool_number = 3, .dialect = Dialect::grbl});
  const std::string head =
      "(part)\nG21 G90 G94 G17\nM3 S9000\nG0 Z10\nX0 Y0\nX1 Y2\nG1 Z0 F333.333\nX3 F600\nX3.0785 "
      "Y2.0015\n";
  CHECK(text.substr(0, head.size()) == head);
  CHECK(text.substr(text.size() - 7) == "M5\nM30\n");
}

TEST_CASE("comments are as long as a controller reads", "[unit][program]") {
  const std::string text(100, 'x');
  CHECK(comment_lines(Dialect::linuxcnc, text) == std::vector{"(" + text + ")"});
  CHECK(comment_lines(Dialect::grbl, text) ==
        std::vector{"(" + std::string(70, 'x') + ")", "(" + std::string(30, 'x') + ")"});
  CHECK(comment_lines(Dialect::grbl, "").empty());
  CHECK(comment_lines(Dialect::fanuc, "a\n\nb\n") == std::vector<std::string>{"(A)", "()", "(B)"});
}

TEST_CASE("every number of a Fanuc program that may have a point has one", "[property][program]") {
  std::mt19937 random(51);
  for (int round = 0; round < 20; ++round) {
    Toolpath path = random_path(random);
    const int decimals = static_cast<int>(random() % 5);
    const std::string text = written(path, {.decimals = decimals,
                                            .dialect = Dialect::fanuc,
                                            .arc_tolerance_mm = 0.01,
                                            .line_numbers = round % 2 == 0});
    for (const std::string& line : lines_of(text)) {
      std::istringstream words(line);
      for (std::string word; words >> word;) {
        const bool takes_point = std::string_view("XYZIJKF").find(word[0]) != std::string::npos;
        if (takes_point != (word.find('.') != std::string::npos)) FAIL_CHECK(line);
        const auto digits =
            std::count_if(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
        if (digits > 8) FAIL_CHECK(line);
      }
    }
  }
}

TEST_CASE("no line of a Grbl program is longer than its buffer", "[unit][program]") {
  Toolpath path;
  path.start = {-9999, -9999, -9999};
  for (int i = 0; i <= 600; ++i) {
    const double angle = std::numbers::pi / 600 * i;
    path.moves.emplace_back(
        Vec3{-9990.1234, -8998.1234 + 800 * std::sin(angle), -8990.5678 - 800 * std::cos(angle)},
        12345.678F + static_cast<float>(i / 300), 0, MoveKind::feed);
  }
  const std::string text = written(path, {.program_name = std::string(90, 'p'),
                                          .comment = std::string(500, 'c'),
                                          .dialect = Dialect::grbl,
                                          .arc_tolerance_mm = 5,
                                          .line_numbers = true});
  CHECK_THAT(text, ContainsSubstring("G19 G"));
  for (const std::string& line : lines_of(text)) CHECK(line.size() < 80);
}

TEST_CASE("every dialect is read back as the path that was written", "[property][program]") {
  std::mt19937 random(52);
  for (int round = 0; round < 150; ++round) {
    const Dialect dialect = kDialects[random() % kDialects.size()];
    const int most = rules(dialect).most_decimals;
    WriterOptions options{.program_name = "part",
                          .comment = "cutter",
                          .decimals = static_cast<int>(random() % static_cast<unsigned>(most + 1)),
                          .spindle_rpm = random() % 2 == 0 ? 0.0 : 8000,
                          .dialect = dialect,
                          .line_numbers = random() % 2 == 0};
    CAPTURE(name(dialect), options.decimals, options.line_numbers);
    Toolpath path = random_path(random);
    const Toolpath before = path;
    const std::string text = written(path, options);
    check_same(path, to_toolpath(program_of(text), kDialectChordMm));
    CHECK(written(path, options) == text);
    const double half_mm = 0.5 * std::pow(10, -options.decimals) + 3e-14;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const Vec3 moved = path.moves[i].to - before.moves[i].to;
      CHECK(std::max({std::abs(moved.x), std::abs(moved.y), std::abs(moved.z)}) <= half_mm);
      const float feed = path.moves[i].feed_mm_min;
      if (feed > 0) CHECK(std::abs(feed - before.moves[i].feed_mm_min) <= 0.00051F);
    }
  }
}

TEST_CASE("with arcs, what is read back has the same ends of lines and arcs that are allowed",
          "[property][program]") {
  std::mt19937 random(53);
  std::size_t arcs = 0;
  for (int round = 0; round < 150; ++round) {
    const Dialect dialect = kDialects[random() % kDialects.size()];
    WriterOptions options{.decimals = 2 + static_cast<int>(random() % 3),
                          .dialect = dialect,
                          .arc_tolerance_mm = 0.02,
                          .line_numbers = random() % 2 == 0};
    CAPTURE(name(dialect), options.decimals);
    Toolpath path = random_path(random);
    const std::string text = written(path, options);
    const Program program = program_of(text);
    check_same_but_for_arcs(path, program);
    for (std::size_t i = 1; i < program.motions.size(); ++i) {
      const Motion& arc = program.motions[i];
      if (arc.kind != MotionKind::arc) continue;
      ++arcs;
      const auto [one, two, normal] = axes_of(arc.plane);
      const Vec3& from = program.motions[i - 1].to;
      const double r0 = std::hypot(from[one] - arc.centre1, from[two] - arc.centre2);
      const double r1 = std::hypot(arc.to[one] - arc.centre1, arc.to[two] - arc.centre2);
      // LinuxCNC's rule was applied by the reader; this is Grbl's, with room for one rounding.
      CHECK(std::abs(r0 - r1) <= 0.005 + 1e-12);
      CHECK(from[normal] == arc.to[normal]);
    }
  }
  CHECK(arcs > 300);
}
