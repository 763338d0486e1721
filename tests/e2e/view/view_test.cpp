#include <signal.h>

#include <algorithm>
#include <cstdlib>
#include <thread>

#include "tests/e2e/view/viewer.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
namespace {

TEST_CASE("view serves the report's bytes on loopback and ends with 0", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  for (const int signal : {SIGINT, SIGTERM}) {
    Viewer viewer(scratch);
    CHECK(viewer.said() == "report: http://" + viewer.host() + "/ (Ctrl-C ends)");
    for (const char* path : {"/", "/report.html"}) {
      const std::string answer = viewer.get(path);
      CHECK(status_of(answer) == 200);
      CHECK(body_of(answer) == read_text(scratch / "out/report.html"));
      for (const char* header :
           {"Content-Type: text/html; charset=utf-8\r\n", "Cache-Control: no-store\r\n",
            "X-Content-Type-Options: nosniff\r\n", "Referrer-Policy: no-referrer\r\n",
            "X-Frame-Options: DENY\r\n", "frame-ancestors 'none'"}) {
        CHECK_THAT(answer, ContainsSubstring(header));
      }
    }
    CHECK(body_of(viewer.get("/rough/stock.vdb")) == read_text(scratch / "out/rough/stock.vdb"));
    CHECK(status_of(viewer.get("/rough/empty.csv")) == 200);
    const std::string head = viewer.ask("HEAD /rough/stock.vdb", viewer.host());
    CHECK_THAT(head, ContainsSubstring("Content-Length: 700000\r\n"));
    CHECK(body_of(head).empty());
    CHECK(viewer.end(signal) == 0);
  }
}

TEST_CASE("view serves nothing but the folder's own files", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  const Viewer viewer(scratch);
  for (const char* path :
       {"/../secret.txt", "/%2e%2e/secret.txt", "/..%2fsecret.txt", "/rough/../../secret.txt",
        "/rough/%2e%2e%2f%2e%2e%2fsecret.txt", "//etc/passwd", "/%2fetc/passwd", "/link.txt",
        "/rough", "/rough/", "/%00", "/..%5csecret.txt", "/missing", "*",
        "http://127.0.0.1/secret.txt"}) {
    CAPTURE(path);
    const std::string answer = viewer.get(path);
    CHECK(status_of(answer) >= 400);
    CHECK_THAT(answer, !ContainsSubstring("root:"));
    CHECK(body_of(answer) != "secret");
  }
  CHECK(status_of(viewer.get("/report.html")) == 200);
}

TEST_CASE("view answers to its own name only, and only shows", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  const Viewer viewer(scratch);
  const std::string port = ":" + std::to_string(viewer.port());
  CHECK(status_of(viewer.ask("GET /", "localhost" + port)) == 200);
  for (const std::string& host :
       {std::string("evil.example"), "evil.example" + port, std::string("127.0.0.1"),
        "127.0.0.1" + port + ".evil.example", std::string("127.0.0.1:1"), std::string()}) {
    CAPTURE(host);
    const std::string answer = viewer.ask("GET /report.html", host);
    CHECK(status_of(answer) >= 400);
    CHECK_THAT(answer, !ContainsSubstring("<title>"));
  }
  CHECK_THAT(answer_of(viewer.port(), "GET / HTTP/1.0\r\n\r\n"), !ContainsSubstring("<title>"));
  CHECK_THAT(answer_of(viewer.port(), "GET / HTTP/1.1\r\nHost: " + viewer.host() +
                                          "\r\nHost: evil.example\r\nConnection: close\r\n\r\n"),
             !ContainsSubstring("<title>"));
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE", "PATCH"}) {
    CAPTURE(method);
    CHECK(status_of(viewer.ask(std::string(method) + " /report.html", viewer.host())) >= 400);
  }
  CHECK(read_text(scratch / "out/report.html") == "<!doctype html><title>page</title>");
}

TEST_CASE("a waiting browser does not hold view back when it shall end", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  Viewer viewer(scratch);
  std::thread half([&] { answer_of(viewer.port(), "GET /report.html HTTP/1.1\r\nHost: "); });
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  const auto began = std::chrono::steady_clock::now();
  CHECK(viewer.end(SIGINT) == 0);
  half.join();
  // The one who asks would be waited for 15 s.
  CHECK(std::chrono::steady_clock::now() - began < std::chrono::seconds(10));
}

TEST_CASE("a port can be chosen and is not shared", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  Viewer first(scratch);
  const std::string port = std::to_string(first.port());
  const Outcome second = limitgauge(scratch, {"view", "out", "--port", port, "--no-browser"});
  CHECK(second.exit_code == 3);
  CHECK(second.out.empty());
  CHECK_THAT(second.errors, ContainsSubstring("127.0.0.1:" + port));
  CHECK(first.end(SIGINT) == 0);
  Viewer again(scratch, {"--port", port, "--no-browser"});
  CHECK(again.port() == first.port());
  CHECK(again.end(SIGINT) == 0);
}

TEST_CASE("view opens the desktop's browser where there is a display", "[e2e][view]") {
  const Scratch scratch;
  write_finished(scratch);
  fs::create_directory(scratch / "bin");
  write_text(scratch / "bin/xdg-open",
             "#!/bin/sh\necho \"$1\" > opened.part\nmv opened.part opened\n");
  fs::permissions(scratch / "bin/xdg-open", fs::perms::owner_all);
  const std::string path = std::getenv("PATH");
  setenv("PATH", ((scratch / "bin").string() + ":" + path).c_str(), 1);
  unsetenv("WAYLAND_DISPLAY");
  const auto opened = [&](const char* display, std::vector<std::string> more) {
    fs::remove(scratch / "opened");
    display == nullptr ? unsetenv("DISPLAY") : setenv("DISPLAY", display, 1);
    Viewer viewer(scratch, std::move(more));
    for (int i = 0; i < 30 && !fs::exists(scratch / "opened"); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    CHECK(viewer.end(SIGINT) == 0);
    return read_text(scratch / "opened").starts_with("http://127.0.0.1:");
  };
  CHECK(opened(":7", {}));
  CHECK_FALSE(opened(":7", {"--no-browser"}));
  CHECK_FALSE(opened(nullptr, {}));
  setenv("PATH", path.c_str(), 1);
}

TEST_CASE("what has no finished report is refused in one line", "[e2e][view]") {
  const Scratch scratch;
  fs::create_directories(scratch / "empty");
  fs::create_directories(scratch / "half");
  write_text(scratch / "half/report.html", "page");
  fs::create_directories(scratch / "out.incomplete");
  write_text(scratch / "out.incomplete/INCOMPLETE.txt", "disk full");
  for (const auto& [folder, what] : std::vector<std::pair<std::string, std::string>>{
           {"missing", "does not exist"},
           {"empty", "no report.html"},
           {"half", "no result.json"},
           {"half/report.html", "no result.json"},
           {"out.incomplete", "did not come to its end"}}) {
    CAPTURE(folder);
    const Outcome outcome = limitgauge(scratch, {"view", folder});
    CHECK(outcome.exit_code == 3);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.errors, ContainsSubstring(folder + ": error: ") && ContainsSubstring(what));
    CHECK(std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1);
  }
}

}  // namespace
}  // namespace limitgauge::e2e
