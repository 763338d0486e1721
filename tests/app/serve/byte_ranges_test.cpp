#include "app/serve/byte_ranges.h"

#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

using Ranges = std::vector<ByteRange>;

TEST_CASE("ranges of a file: from, to, open, of the end, several", "[unit][view]") {
  CHECK(ranges_of("bytes=0-0", 10) == Ranges{{0, 0}});
  CHECK(ranges_of("bytes=2-4", 10) == Ranges{{2, 4}});
  CHECK(ranges_of("bytes=7-", 10) == Ranges{{7, 9}});
  CHECK(ranges_of("bytes=-5", 10) == Ranges{{5, 9}});
  CHECK(ranges_of("BYTES=9-9", 10) == Ranges{{9, 9}});
  CHECK(ranges_of("bytes=0-1, 4-5,\t-1", 10) == Ranges{{0, 1}, {4, 5}, {9, 9}});
  CHECK(ranges_of("bytes=8-9,0-1", 10) == Ranges{{8, 9}, {0, 1}});
  CHECK(ranges_of("bytes=,0-1,,", 10) == Ranges{{0, 1}});
}

TEST_CASE("ranges beyond the end are cut off there, whatever the number", "[unit][view]") {
  CHECK(ranges_of("bytes=5-99", 10) == Ranges{{5, 9}});
  CHECK(ranges_of("bytes=-99", 10) == Ranges{{0, 9}});
  CHECK(ranges_of("bytes=0-99999999999999999999999999999", 10) == Ranges{{0, 9}});
  CHECK(ranges_of("bytes=-18446744073709551616", 10) == Ranges{{0, 9}});
  CHECK(ranges_of("bytes=3-18446744073709551615", 10) == Ranges{{3, 9}});
}

TEST_CASE("ranges of which nothing is there cannot be had, and those beside them can",
          "[unit][view]") {
  for (const char* field : {"bytes=10-", "bytes=10-20", "bytes=-0", "bytes=11-12,-0",
                            "bytes=99999999999999999999999-", "bytes=18446744073709551615-"}) {
    CAPTURE(field);
    CHECK(ranges_of(field, 10) == Ranges{});
  }
  CHECK(ranges_of("bytes=20-30,1-2", 10) == Ranges{{1, 2}});
  CHECK(ranges_of("bytes=0-", 0) == Ranges{});
  CHECK(ranges_of("bytes=0-0", 0) == Ranges{});
}

TEST_CASE("what is no range of bytes is not heeded", "[unit][view]") {
  for (const char* field :
       {"", "bytes", "bytes=", "bytes=,", "bytes=-", "bytes=5-2", "bytes=a-b", "bytes=1", "0-1",
        "lines=0-1", "bytes =0-1", "bytes=0-1-2", "bytes=+0-1", "bytes=0-1;2-3", "bytes=0x0-1",
        "bytes=--5", "bytes=0 - 1", "bytes=0-1,x"}) {
    CAPTURE(field);
    CHECK_FALSE(ranges_of(field, 10));
  }
  // The last bytes of a file that has none are all of it.
  CHECK_FALSE(ranges_of("bytes=-5", 0));
}

TEST_CASE("many ranges ask for no byte twice", "[unit][view]") {
  CHECK(ranges_of("bytes=0-,0-,0-,0-,0-", 10) == Ranges{{0, 9}});
  CHECK(ranges_of("bytes=5-7,0-2,6-9", 10) == Ranges{{0, 2}, {5, 9}});
  CHECK(ranges_of("bytes=0-4,5-9", 10) == Ranges{{0, 9}});
  std::string field = "bytes=0-0";
  for (int i = 1; i < static_cast<int>(kMostRanges); ++i)
    field += "," + std::to_string(2 * i) + "-" + std::to_string(2 * i);
  CHECK(ranges_of(field, 100).value().size() == kMostRanges);
  CHECK_FALSE(ranges_of(field + ",99-99", 100));
}

}  // namespace
}  // namespace limitgauge::app
