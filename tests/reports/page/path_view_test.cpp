#include "reports/page/path_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/catch.h"

using namespace limitgauge;
using model::MoveKind;
using model::Vec3;
using reports::page::path_view;
using reports::page::PathView;

namespace {

void go(model::Toolpath& path, const Vec3& to, float feed, MoveKind kind = MoveKind::feed) {
  path.moves.push_back({to, feed, std::uint32_t(path.moves.size() + 10), kind});
}

/// Rows of a wave with rapids between them.
model::Toolpath wave(int rows, int steps) {
  model::Toolpath path;
  path.start = {0, 0, 20};
  for (int row = 0; row < rows; ++row) {
    go(path, {0, double(row), 20}, 0, MoveKind::rapid);
    for (int i = 0; i <= steps; ++i) {
      const double x = 50.0 * i / steps;
      go(path, {x, double(row), 3 * std::sin(x / 4)}, i < steps / 10 ? 300 : 1200);
    }
    go(path, {50, double(row), 20}, 0, MoveKind::rapid);
  }
  return path;
}

double to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  // By search: the distance along a segment has one minimum.
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double s = low + (high - low) / 3, t = high - (high - low) / 3;
    (distance(p, lerp(a, b, s)) < distance(p, lerp(a, b, t)) ? high : low) =
        distance(p, lerp(a, b, s)) < distance(p, lerp(a, b, t)) ? t : s;
  }
  return distance(p, lerp(a, b, low));
}

/// What holds for every view of a path.
void require_sound(const model::Toolpath& path, const PathView& view) {
  REQUIRE(view.moves == path.moves.size());
  REQUIRE(view.segments.back().move + 1 == path.moves.size());
  Vec3 from = view.start;
  std::size_t move = 0;
  double before_s = 0, farthest = 0;
  for (const PathView::Segment& s : view.segments) {
    REQUIRE(s.to == path.moves[s.move].to);
    REQUIRE(s.line == path.moves[s.move].line);
    REQUIRE(s.move >= move);
    REQUIRE(s.end_s >= before_s);
    for (; move <= s.move; ++move)
      farthest = std::max(farthest, to_segment(path.moves[move].to, from, s.to));
    from = s.to, before_s = s.end_s;
  }
  CHECK(farthest == Approx(view.within_mm).margin(1e-6));
}

}  // namespace

TEST_CASE("a path that fits is drawn move by move", "[unit][page]") {
  const model::Toolpath path = wave(3, 40);
  const PathView view = path_view(path, {}, {5000, 0, path.moves.size()});
  REQUIRE(view.segments.size() == path.moves.size());
  CHECK(view.within_mm == 0);
  CHECK_FALSE(view.has_rates);
  require_sound(path, view);
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    CHECK(view.segments[i].kind == path.moves[i].kind);
    CHECK(view.segments[i].feed_mm_min == path.moves[i].feed_mm_min);
  }
  CHECK(view.segments.back().end_s == Approx(model::lengths(path, 5000).time_s));
}

TEST_CASE("a path that does not fit is joined within the stated distance", "[unit][page]") {
  const model::Toolpath path = wave(12, 2000);
  for (const std::size_t most : {8000, 2000, 300}) {
    const PathView view = path_view(path, {}, {5000, 777, most});
    INFO(most);
    CHECK(view.segments.size() <= most);
    CHECK(view.segments.size() > most / 5);
    CHECK(view.segments.back().end_s == Approx(777));
    require_sound(path, view);
    // Chords of a curve of radius 16/3 (its sharpest) that is flat elsewhere.
    CHECK(view.within_mm < (most == 300 ? 1.0 : most == 2000 ? 0.02 : 1e-3));
  }
}

TEST_CASE("rapids, and feeds of another rate, stay apart", "[unit][page]") {
  const model::Toolpath path = wave(30, 2000);
  const PathView view = path_view(path, {}, {5000, 0, 3000});
  std::size_t move = 0;
  for (const PathView::Segment& s : view.segments)
    for (; move <= s.move; ++move) {
      REQUIRE(path.moves[move].kind == s.kind);
      if (s.kind == MoveKind::feed) REQUIRE(path.moves[move].feed_mm_min == s.feed_mm_min);
    }
}

TEST_CASE("moves on a line are joined at no distance, there and back are not", "[unit][page]") {
  model::Toolpath path;
  for (int i = 1; i <= 100; ++i) go(path, {double(i), 0, 0}, 600);
  for (int i = 99; i >= 0; --i) go(path, {double(i), 0, 0}, 600);
  const PathView view = path_view(path, {}, {5000, 0, 2});
  REQUIRE(view.segments.size() == 2);
  CHECK(view.segments[0].to == Vec3{100, 0, 0});
  CHECK(view.segments[0].end_s == Approx(10));
  CHECK(view.segments[1].end_s == Approx(20));
  CHECK(view.within_mm == Approx(0).margin(1e-12));
}

TEST_CASE("a joined segment has the mean rate of removal of its moves", "[unit][page]") {
  model::Toolpath path;
  for (int i = 1; i <= 4; ++i) go(path, {10.0 * i, 0, 0}, 600);
  const std::vector<simulator::MoveRemoval> removal = {{1}, {2}, {3}, {6}};
  const PathView whole = path_view(path, removal, {5000, 0, 1});
  REQUIRE(whole.segments.size() == 1);
  CHECK(whole.has_rates);
  CHECK(whole.segments[0].rate_mm3_min == Approx(12 / (40.0 / 600)));
  // Half as fast a machine removes half as much in a minute.
  CHECK(path_view(path, removal, {5000, 8, 1}).segments[0].rate_mm3_min ==
        Approx(6 / (40.0 / 600)));
  const PathView each = path_view(path, removal, {});
  REQUIRE(each.segments.size() == 4);
  CHECK(each.segments[3].rate_mm3_min == Approx(360));
}

TEST_CASE("feeds that change with every move are joined where they must be", "[unit][page]") {
  model::Toolpath path = wave(10, 1000);
  std::mt19937 random(5);
  for (model::Move& move : path.moves)
    if (move.kind == MoveKind::feed) move.feed_mm_min = 100 + float(random() % 1000);
  const PathView view = path_view(path, {}, {5000, 0, 400});
  CHECK(view.segments.size() <= 400);
  require_sound(path, view);
  CHECK(view.segments.back().end_s == Approx(model::lengths(path, 5000).time_s));
  double feed_s = 0;
  Vec3 from = view.start;
  for (const PathView::Segment& s : view.segments) {
    if (s.kind == MoveKind::feed) {
      CHECK(s.feed_mm_min >= 100);
      CHECK(s.feed_mm_min <= 1100);
      feed_s += 60 * distance(from, s.to) / s.feed_mm_min;
    }
    from = s.to;
  }
  CHECK(feed_s > 0);
}

TEST_CASE("moves whose tool turns are joined where the axes lie near the arc", "[unit][page]") {
  // Straight on, while the tool leans over by half a degree a move, and back from move 100 on.
  model::Toolpath path;
  model::ToolAxes axes;
  for (int i = 1; i <= 200; ++i) {
    go(path, {double(i), 0, 0}, 600);
    const double lean = (100 - std::abs(100 - i)) * 0.5 * std::numbers::pi / 180;
    axes.to.push_back({std::sin(lean), 0, std::cos(lean)});
  }
  reports::page::PathViewOptions options{5000, 0, 2};
  options.axes = &axes;
  const PathView two = path_view(path, {}, options);
  REQUIRE(two.segments.size() == 2);
  CHECK(two.segments[0].move == 99);
  CHECK(two.start_axis == Vec3{0, 0, 1});
  CHECK(two.axes[0] == axes.to[99]);
  CHECK(two.axis_within_deg < 1e-6);
  // As one segment it would not lean at all: 50 degrees off at its middle.
  options.most_segments = 1;
  const PathView one = path_view(path, {}, options);
  REQUIRE(one.segments.size() == 1);
  CHECK(one.axis_within_deg == Approx(50));
  CHECK(one.within_mm == Approx(0).margin(1e-12));
}

TEST_CASE("no path is too odd to be reduced", "[unit][page]") {
  model::Toolpath pecks, still;
  for (int i = 0; i < 300; ++i) {
    go(pecks, {double(i), 0, -5}, 100), go(pecks, {double(i), 0, 5}, 0, MoveKind::rapid);
    go(still, {}, float(i)), go(still, {}, 0, MoveKind::rapid);
  }
  for (const model::Toolpath& path : {pecks, still}) {
    const PathView view = path_view(path, {}, {5000, 0, 50});
    CHECK(view.segments.size() <= 50);
    require_sound(path, view);
  }
  const PathView none = path_view({}, {}, {});
  CHECK(none.segments.empty());
  CHECK(none.within_mm == 0);
}

TEST_CASE("five million moves are reduced in seconds", "[slow][page]") {
  const model::Toolpath path = wave(2500, 2000);
  const PathView view = path_view(path, {}, {5000});
  CHECK(view.segments.size() <= reports::page::kMostSegments);
  CHECK(view.within_mm < 0.5);
}
