#include "reports/text/text.h"

#include <random>

#include "model/text/number_text.h"
#include "reports/text/interval_text.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

TEST_CASE("markup is escaped and made well-formed", "[unit][text]") {
  CHECK(escape_markup("<script>alert('a & \"b\"')</script>") ==
        "&lt;script&gt;alert(&#39;a &amp; &quot;b&quot;&#39;)&lt;/script&gt;");
  CHECK(clean_text("a\x01"
                   "b\x7F") == "a\uFFFDb\uFFFD");
  CHECK(clean_text("\xC0\xAF\xED\xA0\x80ok") == "\uFFFD\uFFFD\uFFFD\uFFFD\uFFFDok");
  CHECK(clean_text("gr\u00fc\u00df \U0001F6E0\tx\n") == "gr\u00fc\u00df \U0001F6E0\tx\n");
  CHECK(clean_text("cut \xE2\x82") == "cut \uFFFD\uFFFD");
}

TEST_CASE("text is cut by code points, not by bytes", "[unit][text]") {
  CHECK(code_points("µm≤") == 3);
  CHECK(shortened("µµµµ", 4) == "µµµµ");
  CHECK(shortened("µµµµµ", 4) == "µµµ…");
  CHECK(shortened("two\nlines", 20) == "two lines");
}

TEST_CASE("numbers keep what they are", "[unit][text]") {
  CHECK(model::shortest(0.1) == "0.1");
  CHECK(fixed(-0.0004, 3) == "0.000");
  CHECK(three_digits(0.4451) == "0.445");
  CHECK(three_digits(1234.6) == "1235");
  CHECK(three_digits(8.1e-11) == "8.10e-11");
  CHECK(three_digits(0) == "0");
  CHECK(grouped(999) == "999");
  CHECK(grouped(98325) == "98\u202F325");
  CHECK(grouped(1204377) == "1\u202F204\u202F377");
}

TEST_CASE("lengths come with the unit that suits them", "[unit][text]") {
  CHECK(measured_length(0.000445) == "0.445 µm");
  CHECK(measured_length(-1.2504) == "-1.25 mm");
  CHECK(stated_length(0.01) == "10 µm");
  CHECK(stated_length(0.2) == "0.2 mm");
  CHECK(stated_length(0.007) == "7 µm");
  CHECK(stated_length(0) == "0 mm");
}

TEST_CASE("an interval is rounded outwards", "[unit][text]") {
  const LengthUnit um{1000, "µm"};
  CHECK(interval_numbers({0.0004451, 0.0005101}, um) == "[0.44, 0.52]");
  CHECK(interval_numbers({0.0094, 0.0126}, um) == "[9.4, 12.6]");
  // A limit of 10 µm exceeded by a nanometre's hundredth must not be shown as 10.
  CHECK(interval_numbers({0.009, 0.01000001}, um) == "[9.0, 10.1]");
  CHECK(interval_numbers({0, 0}, um) == "[0, 0]");
  CHECK(interval_numbers({0.05, 0.05}, um) == "[50.0, 50.0]");
}

TEST_CASE("no end of an interval is printed across its limit", "[unit][text]") {
  const LengthUnit um{1000, "µm"};
  // One decimal would show a figure that passes as touching its limit of 5 µm ...
  CHECK(interval_numbers({0.004, 0.0049996}, um, 0.005) == "[4.0, 4.9996]");
  // ... one that fails as undecided, and one that is not decided as passed.
  CHECK(interval_numbers({0.00501, 0.006}, um, 0.005) == "[5.01, 6.0]");
  CHECK(interval_numbers({0.0050003, 0.0056}, um, 0.005) == "[5.0003, 5.6]");
  CHECK(interval_numbers({0.004, 0.0050000001}, um, 0.005) == "[4.0, 5.01]");
  // What lies on the limit is printed as the limit, with the digits that it takes.
  CHECK(interval_numbers({0.004, 0.005}, um, 0.005) == "[4.0, 5.0]");
  CHECK(interval_numbers({0.004, 0.00525}, um, 0.00525) == "[4.0, 5.25]");
  CHECK(interval_numbers({0.006, 0.007}, um, 0.007) == "[6.0, 7.0]");
  // Far from the limit nothing changes.
  CHECK(interval_numbers({0.0094, 0.0126}, um, 0.05) == "[9.4, 12.6]");
  CHECK(measured_beside(0.0050004, 0.005) == "5.0004 µm");
  CHECK(measured_beside(0.0063, 0.005) == "6.30 µm");
  CHECK(percent_beside(0.99003, 0.99005) == "99.00 %");
  CHECK(percent_beside(0.990049, 0.99005) == "99.00 %");
  CHECK(percent_beside(0.99006, 0.99005) == "99.006 %");
  CHECK(percent_beside(0.99, 0.99) == "99.00 %");
  CHECK(stated_percent(0.99005) == "99.005 %");
  CHECK(stated_percent(0.99) == "99.00 %");
  CHECK(stated_number(0.0005, {}) == "0.0005");
}

TEST_CASE("whatever the figure and its limit, what is printed stands as the figure does",
          "[property][text]") {
  std::mt19937_64 random(20260);
  std::uniform_real_distribution<double> exponent(-4, 1), share(0, 1), nearness(-12, 0);
  const auto side = [](double value, double limit) { return (value > limit) - (value < limit); };
  for (int k = 0; k < 20'000; ++k) {
    // A limit as people state it, and an interval whose ends lie as near to it as may be.
    const double limit_mm =
        std::stod(fixed(std::pow(10, exponent(random)), 5 + int(3 * share(random))));
    if (limit_mm <= 0) continue;
    const auto end = [&] {
      const double off = limit_mm * std::pow(10, nearness(random));
      return share(random) < 0.05 ? limit_mm : limit_mm + (share(random) < 0.5 ? off : -off);
    };
    double low_mm = std::max(0.0, end()), high_mm = std::max(0.0, end());
    if (low_mm > high_mm) std::swap(low_mm, high_mm);
    const LengthUnit unit = unit_for(std::max(high_mm, limit_mm));
    const std::string text = interval_numbers({low_mm, high_mm}, unit, limit_mm);
    if (text == "[0, 0]") continue;
    const std::size_t comma = text.find(", ");
    const double low = std::stod(text.substr(1)), high = std::stod(text.substr(comma + 2)),
                 limit = std::stod(stated_number(limit_mm, unit));
    INFO(text << " of [" << low_mm << ", " << high_mm << "], limit " << limit_mm);
    REQUIRE(side(low, limit) == side(low_mm, limit_mm));
    REQUIRE(side(high, limit) == side(high_mm, limit_mm));
    // Outwards, but for the binary form of the figures.
    REQUIRE(low <= low_mm * unit.per_mm * (1 + 1e-6));
    REQUIRE(high >= high_mm * unit.per_mm * (1 - 1e-6));
    REQUIRE(text.size() < 40);
  }
}

TEST_CASE("times, sizes and shares", "[unit][text]") {
  CHECK(duration_text(0.42) == "0.4 s");
  CHECK(duration_text(0.042) == "0.04 s");
  CHECK(duration_text(185) == "3 min 05 s");
  CHECK(duration_text(3725) == "1 h 02 min");
  CHECK(clock_text(5609.4) == "1:33:29");
  CHECK(clock_text(9) == "0:00:09");
  CHECK(bytes_text(512) == "512 bytes");
  CHECK(bytes_text(21'818'000) == "21.8 MB");
  CHECK(percent_text(0.99999) == "99.99 %");
  CHECK(percent_text(1) == "100.00 %");
}
