#include "app/serve/http_request.h"

#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

int status_of_head(const std::string& head) {
  const auto read = request_of(head);
  const auto* refused = std::get_if<RefusedHead>(&read);
  return refused != nullptr ? refused->status : 200;
}

TEST_CASE("the head of a request is taken apart", "[unit][view]") {
  const auto read = request_of(
      "\r\nGET /a%20b.txt?x=1 HTTP/1.1\r\nHost:  127.0.0.1:8 \r\nRANGE: "
      "bytes=0-1\r\nEmpty:\r\n\r\n");
  const auto& request = std::get<HttpRequest>(read);
  CHECK(request.method == "GET");
  CHECK(request.target == "/a%20b.txt?x=1");
  CHECK(request.only("host") == "127.0.0.1:8");
  CHECK(request.only("range") == "bytes=0-1");
  CHECK(request.only("empty") == "");
  CHECK_FALSE(request.only("missing"));
  CHECK(request.stays);
  CHECK_FALSE(request.has_content);
}

TEST_CASE("what the head says of the connection", "[unit][view]") {
  const auto read = [](const std::string& first, const std::string& fields) {
    return std::get<HttpRequest>(request_of(first + "\r\n" + fields + "\r\n"));
  };
  CHECK_FALSE(read("GET / HTTP/1.0", "").stays);
  CHECK_FALSE(read("GET / HTTP/1.1", "Connection: Close\r\n").stays);
  CHECK(read("GET / HTTP/1.1", "Content-Length: 0\r\n").stays);
  // What follows is not to be taken for a request.
  for (const char* field : {"Content-Length: 5\r\n", "Transfer-Encoding: chunked\r\n"}) {
    CHECK(read("GET / HTTP/1.1", field).has_content);
    CHECK_FALSE(read("GET / HTTP/1.1", field).stays);
  }
  CHECK_FALSE(read("GET / HTTP/1.1", "Host: a\r\nHost: b\r\n").only("host"));
}

TEST_CASE("what is no request is refused", "[unit][view]") {
  CHECK(status_of_head("GET / HTTP/1.1\r\n\r\n") == 200);
  for (const std::string& head :
       {std::string("\r\n\r\n"), std::string("GET /\r\n\r\n"), std::string("GET\r\n\r\n"),
        std::string("GET  HTTP/1.1\r\n\r\n"), std::string("GET / a HTTP/1.1\r\n\r\n"),
        std::string("GET / HTTP/1.1\n\n"), std::string("GET / HTTP/1.1\r\nno field\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\nHost : a\r\n\r\n"),
        std::string("GET / HTTP/1.1\r\nA: b\r\n folded\r\n\r\n"),
        std::string("G@T / HTTP/1.1\r\n\r\n"), std::string("GET / FTP/1.1\r\n\r\n"),
        std::string("GET /\0 HTTP/1.1\r\n\r\n", 19), std::string("\x16\x03\x01\r\n\r\n")}) {
    CAPTURE(head);
    CHECK(status_of_head(head) == 400);
  }
  CHECK(status_of_head("GET / HTTP/2.0\r\n\r\n") == 505);
}

TEST_CASE("where a head ends", "[unit][view]") {
  CHECK_FALSE(head_length(""));
  CHECK_FALSE(head_length("\r\n\r\n"));
  CHECK_FALSE(head_length("GET / HTTP/1.1\r\nHost: a\r\n"));
  CHECK(head_length("GET / HTTP/1.1\r\n\r\nrest") == 18);
  CHECK(head_length("\r\nA\r\n\r\n") == 7);
  CHECK(head_length("A\n\nrest") == 3);
}

TEST_CASE("the path of a target", "[unit][view]") {
  CHECK(path_of("/a/b.txt?c=/d#e") == "/a/b.txt");
  CHECK(path_of("/%41%2e%2F%7e") == "/A./~");
  CHECK(path_of("/100%") == "/100%");
  CHECK(path_of("/%4") == "/%4");
  CHECK(path_of("/%zz+") == "/%zz+");
  CHECK(path_of("/%00") == std::string("/\0", 2));
}

}  // namespace
}  // namespace limitgauge::app
