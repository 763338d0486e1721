#include "app/output/progress.h"

#include <sstream>

#include "reports/text/text.h"
#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

/// A line with a clock and a width of the test's own.
struct Watched {
  explicit Watched(bool shown = true)
      : line(out, shown, {[this] { return columns; }, [this] { return now; }}) {}

  void pass(double seconds) { now += std::chrono::milliseconds(static_cast<long>(1000 * seconds)); }
  /// What stands on the terminal: all behind the last wipe.
  std::string seen() const {
    const std::string text = out.str();
    const std::string wipe = "\r\x1b[K";
    const std::size_t at = text.rfind(wipe);
    return at == std::string::npos ? text : text.substr(at + wipe.size());
  }

  std::ostringstream out;
  std::size_t columns = 80;
  std::chrono::steady_clock::time_point now{std::chrono::hours(1)};
  ProgressLine line;
};

TEST_CASE("progress says what, which stage, how far, since when and how long still",
          "[unit][progress]") {
  Watched watched;
  watched.line.phase({"finish: cutting", 2, 3});
  CHECK(watched.seen() == "stage 2 of 3, finish: cutting");
  for (int i = 1; i <= 30; ++i) {
    watched.pass(1);
    watched.line.update(0.01 * i);
  }
  CHECK(watched.seen() == "stage 2 of 3, finish: cutting  30 %  0:30  about 1 min left");
  watched.line.phase({"writing the report"});
  CHECK(watched.seen() == "writing the report");
  watched.line.clear();
  CHECK(watched.seen().empty());
}

TEST_CASE("a phase that reports nothing has a clock and no share", "[unit][progress]") {
  Watched watched;
  watched.line.phase({"raw stock", 0, 3});
  watched.pass(75);
  watched.line.tick();
  CHECK(watched.seen() == "raw stock  1:15");
}

TEST_CASE("a job of one stage is not counted", "[unit][progress]") {
  Watched watched;
  watched.line.phase({"mill: cutting", 1, 1});
  CHECK(watched.seen() == "mill: cutting");
}

TEST_CASE("blocks that end out of turn do not turn the share back; a new pass begins anew",
          "[unit][progress]") {
  Watched watched;
  watched.line.phase({"rough: planning", 1, 2});
  const auto report = [&](double fraction) {
    watched.pass(0.5);
    watched.line.update(fraction);
  };
  report(0.50);
  report(0.45);
  CHECK_THAT(watched.seen(), ContainsSubstring("  50 %"));
  report(0.999);
  CHECK_THAT(watched.seen(), ContainsSubstring("  99 %"));  // never done before it is
  report(0.05);
  CHECK_THAT(watched.seen(), ContainsSubstring("planning, part 2  5 %"));
}

TEST_CASE("the line never wraps, whatever the width and the name", "[unit][progress]") {
  Watched watched;
  for (const std::size_t columns : {10, 20, 40, 60, 80, 200}) {
    watched.columns = columns;
    watched.line.phase(
        {"ein länglicher Name einer Stufe ohne Ende und mit Zeichen\x1b[31m", 12, 30});
    for (int i = 1; i <= 20; ++i) {
      watched.pass(1);
      watched.line.update(0.02 * i);
    }
    CAPTURE(columns, watched.seen());
    CHECK(reports::code_points(watched.seen()) < columns);
    CHECK_THAT(watched.seen(), !ContainsSubstring("\x1b"));
    if (columns >= 40) CHECK_THAT(watched.seen(), ContainsSubstring("  40 %"));
    if (columns >= 60) CHECK_THAT(watched.seen(), ContainsSubstring("about 30 s left"));
  }
}

TEST_CASE("it is drawn ten times a second at most and not at all where it is not shown",
          "[unit][progress]") {
  Watched watched;
  watched.line.phase({"cutting"});
  const std::size_t before = watched.out.str().size();
  for (int i = 0; i < 50; ++i) watched.line.update(0.01 * i);
  CHECK(watched.out.str().size() == before);
  Watched silent(false);
  silent.line.phase({"cutting"});
  silent.pass(10);
  silent.line.update(0.5);
  silent.line.tick();
  silent.line.clear();
  CHECK(silent.out.str().empty());
}

TEST_CASE("a ticker keeps the clock going and ends with its scope", "[unit][progress]") {
  std::ostringstream out;
  {
    ProgressLine line(out, true);
    const ProgressTicker ticker(line);
    line.phase({"raw stock"});
    std::this_thread::sleep_for(std::chrono::milliseconds(1700));
  }
  CHECK_THAT(out.str(), ContainsSubstring("raw stock  0:01"));
}

}  // namespace
}  // namespace limitgauge::app
