#include "reports/text/text.h"

#include "model/text/number_text.h"
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

TEST_CASE("times, sizes and shares", "[unit][text]") {
  CHECK(duration_text(0.42) == "0.4 s");
  CHECK(duration_text(0.042) == "0.04 s");
  CHECK(duration_text(185) == "3 min 05 s");
  CHECK(duration_text(3725) == "1 h 02 min");
  CHECK(bytes_text(512) == "512 bytes");
  CHECK(bytes_text(21'818'000) == "21.8 MB");
  CHECK(percent_text(0.99999) == "99.99 %");
  CHECK(percent_text(1) == "100.00 %");
}
