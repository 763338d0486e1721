#include "tests/e2e/view/viewer.h"

#include <cstdlib>
#include <utility>

#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> view_words(std::vector<std::string> more) {
  more.insert(more.begin(), {"view", "out"});
  return more;
}

}  // namespace

void write_finished(const Scratch& scratch) {
  fs::create_directories(scratch / "out/rough");
  write_text(scratch / "out/report.html", "<!doctype html><title>page</title>");
  write_text(scratch / "out/result.json", "{}");
  std::string bytes(700000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i % 251);
  write_text(scratch / "out/rough/stock.vdb", bytes);
  write_text(scratch / "out/rough/empty.csv", "");
  write_text(scratch / "secret.txt", "secret");
  fs::create_symlink(scratch / "secret.txt", scratch / "out/link.txt");
}

Viewer::Viewer(const Scratch& scratch, std::vector<std::string> more,
               const std::function<void()>& in_child)
    : program_(scratch, view_words(std::move(more)), in_child), said_(program_.line()) {
  const std::size_t colon = said_.rfind(':');
  port_ = std::atoi(said_.c_str() + colon + 1);
  REQUIRE(port_ > 0);
}

std::string Viewer::ask(const std::string& first, const std::string& host,
                        const std::string& fields) const {
  return answer_of(
      port_, first + " HTTP/1.1\r\nHost: " + host + "\r\n" + fields + "Connection: close\r\n\r\n");
}

std::string body_of(const std::string& answer) {
  const std::size_t at = answer.find("\r\n\r\n");
  return at == std::string::npos ? "" : answer.substr(at + 4);
}

int status_of(const std::string& answer) {
  return answer.size() < 12 ? 0 : std::atoi(answer.c_str() + 9);
}

}  // namespace limitgauge::e2e
