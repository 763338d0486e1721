#include "app/output/time_left.h"

#include <cmath>

#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

TEST_CASE("nothing is said of the time left as long as nothing is known", "[unit][time_left]") {
  TimeLeft left;
  CHECK_FALSE(left.seconds(100));
  left.update(101, 0.3);
  left.update(102, 0.5);
  CHECK_FALSE(left.seconds(102));  // too early
  left = {};
  for (double t = 200.1; t < 260; t += 0.1) left.update(t, 0);
  CHECK_FALSE(left.seconds(260));  // no share reported at all
}

TEST_CASE("of steady work the time left is exact", "[unit][time_left]") {
  constexpr double kWhole_s = 60;
  TimeLeft left;
  for (int i = 1; i <= 590; ++i) {
    const double t = 0.1 * i;
    left.update(t, t / kWhole_s);
    if (t < 2.15) continue;
    CAPTURE(t);
    REQUIRE(left.seconds(t));
    CHECK(std::abs(*left.seconds(t) - (kWhole_s - t)) < 0.01);
  }
}

TEST_CASE("what was done before the first share does not count", "[unit][time_left]") {
  TimeLeft left;
  for (int i = 0; i < 300; ++i) left.update(0.1 * i, 0);  // half a minute of something else
  for (int i = 1; i <= 30; ++i) left.update(30 + 0.1 * i, 0.01 * i);
  REQUIRE(left.seconds(33));
  CHECK(std::abs(*left.seconds(33) - 7) < 0.01);
}

TEST_CASE("work that becomes four times slower moves the time left without a jump",
          "[unit][time_left]") {
  TimeLeft left;
  double fraction = 0, before = 0;
  for (int i = 1; i <= 600; ++i) {
    const double t = 0.1 * i;
    fraction += t < 20 ? 0.002 : 0.0005;  // 0.4 done after 20 s, then 120 s more
    left.update(t, fraction);
    if (!left.seconds(t)) continue;
    const double now = *left.seconds(t);
    CAPTURE(t, now);
    // Drawn ten times a second, it never moves by a second and a half at once.
    if (before > 0) CHECK(std::abs(now - before) < 1.5);
    before = now;
  }
  // 60 s have gone, of which the last 40 slow ones; 80 s remain.
  CHECK(before > 55);
  CHECK(before < 90);
}

TEST_CASE("a step that stands still has ever more time left, never less than none",
          "[unit][time_left]") {
  TimeLeft left;
  for (int i = 1; i <= 100; ++i) left.update(0.1 * i, 0.009 * i);
  const double at_90_percent = *left.seconds(10);
  for (int i = 101; i <= 600; ++i) {
    left.update(0.1 * i, 0.9);
    CHECK(*left.seconds(0.1 * i) >= 0);
  }
  CHECK(*left.seconds(60) > at_90_percent);
  CHECK(*left.seconds(1e6) == 0);
}

TEST_CASE("times are said in round words", "[unit][time_left]") {
  CHECK(time_left_words(0) == "a few seconds left");
  CHECK(time_left_words(4.9) == "a few seconds left");
  CHECK(time_left_words(5) == "about 5 s left");
  CHECK(time_left_words(13) == "about 15 s left");
  CHECK(time_left_words(57.4) == "about 55 s left");
  CHECK(time_left_words(58) == "about 1 min left");
  CHECK(time_left_words(125) == "about 2 min left");
  CHECK(time_left_words(3569) == "about 59 min left");
  CHECK(time_left_words(3571) == "about 1 h 00 min left");
  CHECK(time_left_words(4900) == "about 1 h 22 min left");
  CHECK(clock_words(7.9) == "0:07");
  CHECK(clock_words(754) == "12:34");
  CHECK(clock_words(3723) == "1:02:03");
}

}  // namespace
}  // namespace limitgauge::app
