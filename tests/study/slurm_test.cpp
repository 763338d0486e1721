#include "study/execute/slurm_commands.h"

#include <fstream>

#include "study/execute/slurm_folder.h"
#include "study/execute/spawn.h"
#include "tests/support/catch.h"
#include "tests/support/temporary_folder.h"

namespace limitgauge::study {
namespace {

TEST_CASE("what squeue and scontrol print", "[unit][study]") {
  const auto tasks =
      tasks_of_queue("12 0 RUNNING\n12 7 PENDING\n\n13 N/A RUNNING\n14 3 COMPLETING\n");
  REQUIRE(tasks.size() == 3);
  CHECK(tasks[0].job == "12");
  CHECK(tasks[0].started);
  CHECK(tasks[1].number == 7);
  CHECK_FALSE(tasks[1].started);
  CHECK(tasks[2].started);
  CHECK(value_of("Configuration data\nMaxArraySize            = 1001\nX = 2\n", "MaxArraySize") ==
        "1001");
  CHECK(value_of("JobId=3 JobState=NODE_FAIL Reason=None\n   ExitCode=0:9\n", "ExitCode") == "0:9");
  CHECK(value_of("JobId=3\n", "ExitCode").empty());
}

TEST_CASE("a word of a shell is the word", "[unit][study]") {
  for (const std::string& word : {std::string("plain"), std::string("it's $HOME; `x` \"y\" \\ %a"),
                                  std::string("two\nlines"), std::string()}) {
    const Printed printed =
        run_program({"/bin/sh", "-c", "printf '%s' " + shell_word(word) + " >&2; exit 3"});
    CHECK(printed.exit_code == 3);
    CHECK(printed.errors == word);
    CHECK(printed.out.empty());
  }
}

TEST_CASE("an array's folder: tasks, script and answers as they come", "[unit][study]") {
  const tests::TemporaryFolder root;
  const std::filesystem::path folder = root.path() / "a b'c";
  std::vector<CaseRequest> requests(3);
  for (std::size_t i = 0; i < 3; ++i) requests[i] = {i, std::string(64, 'a'), {}, {"k=1"}};
  ArrayFolder array(folder, requests, {{2, 0}, {1}}, {"/bin/echo", "it's"});
  std::ifstream tasks(folder / "0.tasks");
  std::string line;
  std::vector<std::size_t> indices;
  while (std::getline(tasks, line)) indices.push_back(task_of_line(line).value().index);
  CHECK(indices == std::vector<std::size_t>{2, 0});
  const Printed printed =
      run_program({"/usr/bin/env", "-u", "SLURM_CPUS_PER_TASK", "SLURM_ARRAY_TASK_ID=1", "/bin/sh",
                   array.script().string()});
  CHECK(printed.out == "it's --threads 1 --worker " + folder.string() + "/1.tasks\n");
  CHECK(array.new_answers(0).empty());
  std::ofstream out(folder / "0.out");
  const std::string first = to_line(WorkerAnswer{2, WorkerAnswer::Kind::done, 1, 2, ""});
  const std::string second = to_line(WorkerAnswer{0, WorkerAnswer::Kind::again, 1, 2, "full"});
  out << '\n' << first << second.substr(0, 9) << std::flush;
  REQUIRE(array.new_answers(0).size() == 1);
  CHECK(array.new_answers(0).empty());
  out << second.substr(9) << std::flush;
  const auto rest = array.new_answers(0);
  REQUIRE(rest.size() == 1);
  CHECK(rest[0].reason == "full");
}

}  // namespace
}  // namespace limitgauge::study
