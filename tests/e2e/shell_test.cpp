#include <algorithm>
#include <sstream>

#include "tests/e2e/program.h"
#include "tests/e2e/shell.h"
#include "tests/support/catch.h"

namespace limitgauge::e2e {
namespace fs = std::filesystem;
namespace {

const std::string kShare = std::string(LIMITGAUGE_BUILD) + "/share/";
const std::string kBash = kShare + "bash-completion/completions/limitgauge";

/// What bash offers behind `words`, sorted; the last word is the one that is begun. The words are
/// split as readline splits them: at = and : too.
std::vector<std::string> offered(const fs::path& folder, const std::vector<std::string>& words) {
  std::string array;
  for (const std::string& word : words) array += " '" + word + "'";
  const ShellOutcome outcome =
      bash("cd '" + folder.string() + "'; . '" + kBash + "'; COMP_WORDS=(limitgauge" + array +
           "); COMP_CWORD=" + std::to_string(words.size()) +
           "; _limitgauge; for reply in \"${COMPREPLY[@]}\"; do echo \"$reply\"; done");
  INFO(outcome.out);
  REQUIRE(outcome.exit_code == 0);
  std::istringstream in(outcome.out);
  std::vector<std::string> replies;
  for (std::string line; std::getline(in, line);) replies.push_back(line);
  std::sort(replies.begin(), replies.end());
  return replies;
}

using Words = std::vector<std::string>;

TEST_CASE("bash completes commands and options", "[e2e][shell]") {
  const Scratch scratch;
  CHECK(offered(scratch.path(), {""}) ==
        Words{"compare", "cut", "history", "inspect", "plan", "probe", "run", "study", "verify", "view"});
  CHECK(offered(scratch.path(), {"v"}) == Words{"verify", "view"});
  CHECK(offered(scratch.path(), {"--v"}) == Words{"--version"});
  CHECK(offered(scratch.path(), {"run", "--no"}) == Words{"--no-pictures"});
  CHECK(offered(scratch.path(), {"view", "out", "--no"}) == Words{"--no-browser"});
  CHECK(offered(scratch.path(), {"verify", "--pro"}) ==
        Words{"--program", "--program-offset", "--program-rotation"});
  CHECK(offered(scratch.path(), {"run", "--threads", ""}).empty());
}

TEST_CASE("bash completes files, folders and words as values", "[e2e][shell]") {
  const Scratch scratch;
  for (const char* file : {"job.toml", "part.obj", "part.ngc", "a b.toml"})
    write_text(scratch / file, "");
  fs::create_directory(scratch / "jobs");
  CHECK(offered(scratch.path(), {"run", ""}) == Words{"a b.toml", "job.toml", "jobs"});
  CHECK(offered(scratch.path(), {"run", "--force", "jo"}) == Words{"job.toml", "jobs"});
  CHECK(offered(scratch.path(), {"run", "job.toml", "-o", ""}) == Words{"jobs"});
  CHECK(offered(scratch.path(), {"view", ""}) == Words{"jobs"});
  CHECK(offered(scratch.path(), {"verify", "--cage", "p"}) == Words{"part.obj"});
  CHECK(offered(scratch.path(), {"verify", "--cage", "=", "p"}) == Words{"part.obj"});
  CHECK(offered(scratch.path(), {"verify", "--cage", "="}) == Words{"jobs", "part.obj"});
  CHECK(offered(scratch.path(), {"verify", "--program", "p"}) == Words{"part.ngc", "part.obj"});
  CHECK(offered(scratch.path(), {"verify", "--tool", "b"}) == Words{"ball:D=", "bull:D="});
  CHECK(offered(scratch.path(), {"verify", "--stock", ""}) == Words{"box:", "mesh:", "vdb:"});
  CHECK(offered(scratch.path(), {"verify", "--stock", "mesh", ":", "part.o"}) == Words{"part.obj"});
  CHECK(offered(scratch.path(), {"verify", "--stock", "box", ":"}).empty());
  CHECK(offered(scratch.path(), {"inspect", "part"}) == Words{"part.ngc", "part.obj"});
}

TEST_CASE("the completions are well formed for their shells", "[e2e][shell]") {
  const std::vector<std::pair<std::string, std::string>> all = {
      {"bash", kBash},
      {"zsh", kShare + "zsh/site-functions/_limitgauge"},
      {"fish", kShare + "fish/vendor_completions.d/limitgauge.fish"}};
  for (const auto& [shell, file] : all) {
    CAPTURE(shell, file);
    CHECK(fs::file_size(file) > 1000);
    if (!is_installed(shell)) {
      WARN(shell + " is not installed: its completion is not read by it here");
      continue;
    }
    const ShellOutcome outcome = bash(shell + " -n '" + file + "'");
    CHECK(outcome.out.empty());
    CHECK(outcome.exit_code == 0);
  }
}

TEST_CASE("the manual page is read without a complaint", "[e2e][shell]") {
  const std::string page = kShare + "man/man1/limitgauge.1";
  REQUIRE(fs::file_size(page) > 1000);
  REQUIRE(is_installed("mandoc"));
  const ShellOutcome lint = bash("mandoc -T lint -W style '" + page + "'");
  CHECK(lint.out.empty());
  const ShellOutcome text = bash("mandoc -T utf8 '" + page + "' | sed 's/.\\x08//g'");
  CHECK_THAT(text.out, ContainsSubstring("go or no-go for toolpaths") &&
                           ContainsSubstring("-o, --output DIR") && ContainsSubstring("NO_COLOR"));
}

}  // namespace
}  // namespace limitgauge::e2e
