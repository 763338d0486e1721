#include "tests/e2e/view/viewer.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace {

TEST_CASE("view answers a range of a file", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  const Viewer viewer(scratch);
  const std::string whole = read_text(scratch / "out/rough/stock.vdb");
  struct Case {
    const char *asked, *told;
    std::size_t first, bytes;
  };
  for (const Case& one : {Case{"bytes=10-19", "bytes 10-19/700000", 10, 10},
                          Case{"bytes=0-0", "bytes 0-0/700000", 0, 1},
                          Case{"bytes=-5", "bytes 699995-699999/700000", 699995, 5},
                          Case{"bytes=300000-", "bytes 300000-699999/700000", 300000, 400000},
                          Case{"bytes=699990-999999", "bytes 699990-699999/700000", 699990, 10},
                          Case{"bytes=-999999999999999999999", "bytes 0-699999/700000", 0, 700000},
                          Case{"bytes=0-,0-,1-", "bytes 0-699999/700000", 0, 700000}}) {
    CAPTURE(one.asked);
    const std::string answer =
        viewer.get("/rough/stock.vdb", "Range: " + std::string(one.asked) + "\r\n");
    CHECK(status_of(answer) == 206);
    CHECK_THAT(answer, ContainsSubstring("Content-Range: " + std::string(one.told) + "\r\n"));
    CHECK_THAT(answer, ContainsSubstring("Content-Length: " + std::to_string(one.bytes) + "\r\n"));
    CHECK((body_of(answer) == whole.substr(one.first, one.bytes)));
  }
}

TEST_CASE("view says which ranges cannot be had", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  const Viewer viewer(scratch);
  for (const char* asked : {"bytes=700000-", "bytes=-0", "bytes=99999999999999999999999-"}) {
    CAPTURE(asked);
    const std::string answer =
        viewer.get("/rough/stock.vdb", "Range: " + std::string(asked) + "\r\n");
    CHECK(status_of(answer) == 416);
    CHECK_THAT(answer, ContainsSubstring("Content-Range: bytes */700000\r\n"));
    CHECK(answer.size() < 1000);
  }
  const std::string none = viewer.get("/rough/empty.csv", "Range: bytes=0-\r\n");
  CHECK(status_of(none) == 416);
  CHECK_THAT(none, ContainsSubstring("Content-Range: bytes */0\r\n"));
  CHECK(status_of(viewer.get("/rough/empty.csv", "Range: bytes=-1\r\n")) == 200);
}

TEST_CASE("view does not heed what is no range, nor ranges of anything but GET", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  const Viewer viewer(scratch);
  std::string many = "bytes=0-";
  for (int i = 0; i < 1000; ++i) many += ",0-";
  for (const std::string& asked :
       {std::string("bytes=5-2"), std::string("bytes=x"), std::string("lines=0-1"),
        std::string("bytes="), many, std::string("bytes=0-1\r\nRange: bytes=0-1"),
        std::string("bytes=0-1\r\nIf-Range: \"mark\"")}) {
    CAPTURE(asked);
    const std::string answer = viewer.get("/rough/stock.vdb", "Range: " + asked + "\r\n");
    CHECK(status_of(answer) == 200);
    CHECK(body_of(answer).size() == 700000);
  }
  const std::string head =
      viewer.ask("HEAD /rough/stock.vdb", viewer.host(), "Range: bytes=0-1\r\n");
  CHECK(status_of(head) == 200);
  CHECK_THAT(head, ContainsSubstring("Content-Length: 700000\r\n") &&
                       ContainsSubstring("Accept-Ranges: bytes\r\n"));
  CHECK(body_of(head).empty());
}

TEST_CASE("view answers several ranges in parts", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  const Viewer viewer(scratch);
  const std::string whole = read_text(scratch / "out/rough/stock.vdb");
  const std::string answer = viewer.get("/rough/stock.vdb", "Range: bytes=0-9, 500-503,-2\r\n");
  CHECK(status_of(answer) == 206);
  const std::string mark = "Content-Type: multipart/byteranges; boundary=";
  const std::size_t at = answer.find(mark);
  REQUIRE(at != std::string::npos);
  const std::string boundary =
      answer.substr(at + mark.size(), answer.find("\r\n", at) - at - mark.size());
  const auto part = [&](const std::string& range, std::size_t first, std::size_t bytes) {
    return "\r\n--" + boundary +
           "\r\nContent-Type: application/octet-stream\r\nContent-Range: bytes " + range +
           "/700000\r\n\r\n" + whole.substr(first, bytes);
  };
  CHECK((body_of(answer) == part("0-9", 0, 10) + part("500-503", 500, 4) +
                                part("699998-699999", 699998, 2) + "\r\n--" + boundary + "--\r\n"));
  CHECK_THAT(answer, ContainsSubstring("Content-Length: " + std::to_string(body_of(answer).size()) +
                                       "\r\n"));
}

}  // namespace
}  // namespace limitgauge::e2e
