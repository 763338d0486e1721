#include "study/store/store.h"

#include <sys/resource.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>
#include <thread>
#include <vector>

#include "model/base/error.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::study {
namespace {

namespace fs = std::filesystem;
constexpr std::uint64_t kNoLimit = std::uint64_t{1} << 40;

/// 64 digits that begin with `number`.
std::string key_of(unsigned number) {
  std::string key(64, '0');
  for (std::size_t i = 0; i < 8; ++i) key[i] = "0123456789abcdef"[(number >> (4 * i)) & 15U];
  return key;
}

/// Does not compress to next to nothing.
std::string content_of(unsigned number, std::size_t bytes) {
  std::string text;
  std::uint32_t state = number + 1;
  while (text.size() < bytes) {
    state = state * 1664525U + 1013904223U;
    text.push_back(static_cast<char>(state >> 24U));
  }
  return text;
}

fs::path file_of(const Store& store, const std::string& key) {
  return store.folder() / "result" / key.substr(0, 2) / key.substr(2, 2) / key.substr(4);
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> found;
  if (!fs::exists(folder)) return found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) found.push_back(entry.path());
  return found;
}

/// Runs `work` in a process of its own.
pid_t in_child(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child != 0) return child;
  int code = 0;
  try {
    work();
  } catch (...) {
    code = 1;
  }
  _exit(code);
}

int status_of(pid_t child) {
  int status = -1;
  waitpid(child, &status, 0);
  return status;
}

TEST_CASE("what was put is found, of its kind and key only", "[unit][study]") {
  const tests::TemporaryFolder folder;
  const Store store(folder.path() / "not" / "there" / "yet", kNoLimit);
  CHECK_FALSE(store.get("result", key_of(1)));
  CHECK_FALSE(fs::exists(store.folder()));
  for (const std::string& content :
       {std::string(), std::string("{}"), std::string("\0\n\xff", 3), content_of(1, 300000)}) {
    store.put("result", key_of(1), content);
    CHECK(store.get("result", key_of(1)) == content);
  }
  CHECK(store.has("result", key_of(1)));
  CHECK_FALSE(store.has("stages", key_of(1)));
  CHECK_FALSE(store.get("result", key_of(2)));
  CHECK(files_below(store.folder()) == std::vector<fs::path>{file_of(store, key_of(1))});
}

TEST_CASE("a key or kind that is none is refused", "[unit][study]") {
  const tests::TemporaryFolder folder;
  const Store store(folder.path(), kNoLimit);
  CHECK_THROWS_AS(store.get("result", "../../etc/passwd"), std::invalid_argument);
  CHECK_THROWS_AS(store.has("result", std::string(63, 'a')), std::invalid_argument);
  CHECK_THROWS_AS(store.put("result", std::string(64, 'A'), ""), std::invalid_argument);
  CHECK_THROWS_AS(store.put("..", key_of(1), ""), std::invalid_argument);
}

TEST_CASE("a damaged entry counts as not there and is replaced", "[unit][study]") {
  const tests::TemporaryFolder folder;
  const Store store(folder.path(), kNoLimit);
  const std::string key = key_of(7), content = content_of(7, 60);
  store.put("result", key, content);
  std::ifstream in(file_of(store, key), std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(in), {}};
  const auto damaged = [&](const std::string& bytes) {
    std::ofstream(file_of(store, key), std::ios::binary) << bytes;
    return !store.get("result", key);
  };
  for (std::size_t length = 0; length < whole.size(); length += 7)
    CHECK(damaged(whole.substr(0, length)));
  CHECK(damaged(whole + "x"));
  // Every byte counts, those of the header as well as those of the content.
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 4);
    REQUIRE(damaged(bytes));
  }
  // The whole entry of another key is another result.
  store.put("result", key_of(8), content);
  fs::copy_file(file_of(store, key_of(8)), file_of(store, key),
                fs::copy_options::overwrite_existing);
  CHECK_FALSE(store.get("result", key));
  store.put("result", key, content);
  CHECK(store.get("result", key) == content);
}

TEST_CASE("trim() lets go of what was not used for longest", "[unit][study]") {
  const tests::TemporaryFolder folder;
  const Store writer(folder.path(), kNoLimit);
  const auto now = fs::file_time_type::clock::now();
  constexpr unsigned kEntries = 20;
  for (unsigned i = 0; i < kEntries; ++i) {
    writer.put("result", key_of(i), content_of(i, 1000));
    fs::last_write_time(file_of(writer, key_of(i)), now - std::chrono::hours(kEntries - i));
  }
  const std::uint64_t each = fs::file_size(file_of(writer, key_of(0)));
  // The oldest is used again: it stays.
  CHECK(writer.get("result", key_of(0)));
  const Store store(folder.path(), 5 * each + each / 2);
  const Store::Trimmed done = store.trim(now + std::chrono::hours(1));
  CHECK(done.entries == kEntries - 5);
  CHECK(done.kept_entries == 5);
  CHECK(done.kept_bytes <= 5 * each + each / 2);
  CHECK(done.bytes + done.kept_bytes >= kEntries * (each - 4));
  for (unsigned i = 0; i < kEntries; ++i)
    CHECK(store.has("result", key_of(i)) == (i == 0 || i > kEntries - 5));
  CHECK(store.trim(now + std::chrono::hours(1)).entries == 0);
}

TEST_CASE("trim() keeps what was used since, and touches nothing but entries", "[unit][study]") {
  const tests::TemporaryFolder folder;
  const Store store(folder.path(), 0);
  const auto before = fs::file_time_type::clock::now() - std::chrono::seconds(1);
  store.put("result", key_of(1), "a");
  store.put("result", key_of(2), "b");
  fs::last_write_time(file_of(store, key_of(2)), before - std::chrono::hours(1));
  const fs::path beside = file_of(store, key_of(1)).parent_path();
  std::ofstream(folder.path() / "notes.txt") << "mine";
  std::ofstream(beside / "notes.txt") << "mine";
  std::ofstream(beside / ".part-1-2-3") << "being written";
  std::ofstream(beside / ".part-4-5-6") << "its writer was killed";
  fs::last_write_time(beside / ".part-4-5-6", before - std::chrono::hours(2));
  const Store::Trimmed done = store.trim(before);
  CHECK(done.entries == 1);
  CHECK(store.get("result", key_of(1)) == "a");
  CHECK_FALSE(store.has("result", key_of(2)));
  CHECK(fs::exists(folder.path() / "notes.txt"));
  CHECK(fs::exists(beside / "notes.txt"));
  CHECK(fs::exists(beside / ".part-1-2-3"));
  CHECK_FALSE(fs::exists(beside / ".part-4-5-6"));
  CHECK(Store(folder.path() / "none", 0).trim(before).kept_entries == 0);
}

TEST_CASE("a full disk is an error and leaves no half entry", "[unit][study]") {
  const tests::TemporaryFolder folder;
  const Store store(folder.path(), kNoLimit);
  store.put("result", key_of(1), "old");
  const int status = status_of(in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{4096, 4096};
    setrlimit(RLIMIT_FSIZE, &small);
    try {
      store.put("result", key_of(1), content_of(1, 100000));
    } catch (const model::ResourceError&) {
      return;
    }
    throw std::runtime_error("written");
  }));
  CHECK(status == 0);
  CHECK(store.get("result", key_of(1)) == "old");
  CHECK(files_below(folder.path()).size() == 1);
}

TEST_CASE("many writers, readers and trimmers of one folder", "[unit][study]") {
  const tests::TemporaryFolder folder;
  constexpr unsigned kKeys = 40, kRounds = 5;
  std::vector<pid_t> children;
  for (unsigned process = 0; process < 4; ++process) {
    children.push_back(in_child([&] {
      const Store store(folder.path(), process == 3 ? 30000 : kNoLimit);
      for (unsigned i = 0; i < kKeys * kRounds; ++i) {
        const unsigned number = (i * (process + 3)) % kKeys;
        store.put("result", key_of(number), content_of(number, 3000));
        const auto found = store.get("result", key_of((number + 7) % kKeys));
        if (found && *found != content_of((number + 7) % kKeys, 3000))
          throw std::runtime_error("not what was put");
        if (process == 3 && i % 50 == 0) store.trim(fs::file_time_type::max());
      }
    }));
  }
  for (const pid_t child : children) CHECK(status_of(child) == 0);
  for (const fs::path& file : files_below(folder.path()))
    CHECK(file.filename().string().front() != '.');
}

TEST_CASE("a writer that is killed leaves whole entries or none", "[unit][study]") {
  const tests::TemporaryFolder folder;
  const Store store(folder.path(), kNoLimit);
  unsigned whole = 0;
  for (unsigned round = 0; round < 8; ++round) {
    const pid_t child = in_child([&] {
      for (unsigned i = 0;; i = (i + 1) % 50) store.put("result", key_of(i), content_of(i, 200000));
    });
    std::this_thread::sleep_for(std::chrono::milliseconds(20 + 40 * round));
    kill(child, SIGKILL);
    CHECK(WIFSIGNALED(status_of(child)));
    for (unsigned i = 0; i < 50; ++i) {
      const auto found = store.get("result", key_of(i));
      CHECK(found.has_value() == store.has("result", key_of(i)));
      if (found) CHECK(*found == content_of(i, 200000));
      whole += found.has_value();
    }
  }
  CHECK(whole > 0);
}

}  // namespace
}  // namespace limitgauge::study
