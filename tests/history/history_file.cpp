#include "tests/history/history_file.h"

#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace limitgauge::tests {

history::Entry sample_entry(int number, int figures) {
  history::Entry entry;
  const std::string text = std::to_string(number);
  entry.created = "2026-11-" + std::to_string(10 + number % 20) + "T10:00:00Z";
  entry.job = number % 2 == 0 ? "even" : "odd";
  entry.version = "0.1.0";
  entry.commit = "c" + text;
  entry.label = "run " + text;
  entry.verdict = "pass";
  entry.stages = {{"rough", "pass"}, {"finish", "pass"}};
  for (const char* stage : {"rough", "finish"})
    for (int i = 0; i < figures; ++i)
      entry.values.push_back({stage, "m" + std::to_string(i), number + 0.25 * i, number + 0.5 * i});
  entry.values.push_back({"", "machining_time_s", 100.0 + number, 100.0 + number});
  return entry;
}

namespace {

using Row = int (*)(void* out, int columns, char** texts, char** names);

std::string answer(const std::filesystem::path& file, const std::string& sql, Row row) {
  sqlite3* handle = nullptr;
  if (sqlite3_open(file.c_str(), &handle) != SQLITE_OK) throw std::runtime_error("sqlite3_open");
  // Others write meanwhile.
  constexpr int kWait_ms = 60'000;
  sqlite3_busy_timeout(handle, kWait_ms);
  std::string out;
  const int code = sqlite3_exec(handle, sql.c_str(), row, &out, nullptr);
  const std::string words = sqlite3_errmsg(handle);
  sqlite3_close(handle);
  if (code != SQLITE_OK) throw std::runtime_error(words);
  return out;
}

}  // namespace

std::string query(const std::filesystem::path& file, const std::string& sql) {
  return answer(file, sql, [](void* out, int, char** texts, char**) {
    *static_cast<std::string*>(out) = texts[0] == nullptr ? "NULL" : texts[0];
    return 0;
  });
}

std::string plan(const std::filesystem::path& file, const std::string& sql) {
  return answer(file, "EXPLAIN QUERY PLAN " + sql,
                [](void* out, int columns, char** texts, char**) {
                  *static_cast<std::string*>(out) += std::string(texts[columns - 1]) + "\n";
                  return 0;
                });
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return std::move(text).str();
}

int start_child(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork failed");
  if (child > 0) return child;
  int code = 99;
  try {
    code = work();
  } catch (...) {
  }
  _exit(code);
}

int wait_for(int child) {
  int status = 0;
  if (waitpid(child, &status, 0) != child) throw std::runtime_error("waitpid failed");
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

}  // namespace limitgauge::tests
