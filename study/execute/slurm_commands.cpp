#include "study/execute/slurm_commands.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "model/base/error.h"

namespace limitgauge::study {
namespace fs = std::filesystem;
namespace {

/// What Slurm has where nothing is configured.
constexpr std::size_t kUsualMostTasks = 1001;
constexpr std::chrono::milliseconds kBetweenLooks{150};
/// With what follows it, less than whoever stops a study waits for.
constexpr std::chrono::milliseconds kLongestCancel{700};

bool in_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

/// The last line that says something.
std::string words_of(const Printed& printed) {
  std::istringstream lines(printed.errors.empty() ? printed.out : printed.errors);
  std::string last;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) last = line;
  return last.empty() ? "exit code " + std::to_string(printed.exit_code) : last;
}

/// sbatch fills in what follows a '%'.
std::string pattern_word(const fs::path& path) {
  std::string text;
  for (const char c : path.string()) text += c == '%' ? std::string("%%") : std::string(1, c);
  return text;
}

/// A line in so many parts, between bars; the last one has what is left, missing ones are empty.
std::vector<std::string> parts_of_line(const std::string& line, std::size_t count) {
  std::vector<std::string> parts(count);
  std::size_t at = 0;
  for (std::size_t i = 0; i < count && at <= line.size(); ++i) {
    const std::size_t bar = i + 1 < count ? line.find('|', at) : std::string::npos;
    parts[i] = line.substr(at, bar == std::string::npos ? bar : bar - at);
    at = bar == std::string::npos ? line.size() + 1 : bar + 1;
  }
  return parts;
}

void require_slurm() {
  for (const char* program : {"sbatch", "squeue", "scancel", "scontrol"}) {
    if (in_path(program)) continue;
    throw model::InputError({"--engine slurm", 0, 0},
                            std::string("there is no ") + program + " on this machine",
                            "a machine that submits to Slurm, or --engine local");
  }
}

std::size_t most_tasks_of_cluster(const ProgramPatience& patience) {
  const Printed printed = run_program({"scontrol", "show", "config"}, patience);
  if (patience.stop != nullptr && *patience.stop) throw model::Interrupted();
  if (printed.exit_code != 0)
    throw model::ResourceError("limitgauge: error: Slurm does not answer: " + words_of(printed));
  const std::string stated = value_of(printed.out, "MaxArraySize");
  const std::size_t most =
      stated.empty() ? kUsualMostTasks : std::strtoul(stated.c_str(), nullptr, 10);
  if (most < 2)
    throw model::ResourceError("limitgauge: error: this Slurm takes no job arrays (MaxArraySize " +
                               stated + ")");
  // One above the largest number that a task may have.
  return most;
}

}  // namespace

SlurmCommands::SlurmCommands(std::string name, std::vector<std::string> options,
                             fs::path working_directory, const std::atomic<bool>* stop)
    : name_(std::move(name)),
      options_(std::move(options)),
      working_directory_(std::move(working_directory)) {
  patience_.stop = stop;
  require_slurm();
  most_tasks_ = most_tasks_of_cluster(patience_);
}

std::string SlurmCommands::submit(const fs::path& script, std::size_t tasks,
                                  std::size_t running) const {
  std::vector<std::string> command = {
      "sbatch",
      "--parsable",
      "--job-name=" + name_,
      "--chdir=" + working_directory_.string(),
      "--output=" + pattern_word(script.parent_path()) + "/%a.log",
      "--array=0-" + std::to_string(tasks - 1) + "%" + std::to_string(running)};
  command.insert(command.end(), options_.begin(), options_.end());
  command.push_back(script.string());
  const Printed printed = run_program(command, patience_);
  // "NUMBER", or "NUMBER;CLUSTER".
  const std::string job = printed.out.substr(0, printed.out.find_first_not_of("0123456789"));
  if (printed.exit_code == 0 && !job.empty()) return job;
  throw model::ResourceError("limitgauge: error: Slurm refuses the job: " + words_of(printed));
}

std::vector<QueuedTask> tasks_of_queue(const std::string& printed) {
  std::vector<QueuedTask> tasks;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> parts = parts_of_line(line, 4);
    std::istringstream fields(parts[0]);
    QueuedTask task;
    if (!(fields >> task.job >> task.number >> task.state)) continue;
    task.started = task.state != "PENDING";
    // "n/a" is nobody's.
    if (task.started && parts[1].find('/') == std::string::npos) task.node = parts[1];
    task.partition = parts[2];
    task.reason = parts[3];
    tasks.push_back(std::move(task));
  }
  return tasks;
}

std::vector<NodeState> nodes_of_list(const std::string& printed) {
  std::vector<NodeState> nodes;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> parts = parts_of_line(line, 4);
    if (parts[3].empty()) continue;
    nodes.push_back(
        {std::move(parts[0]), std::move(parts[1]), std::move(parts[2]), std::move(parts[3])});
  }
  return nodes;
}

std::optional<std::vector<QueuedTask>> SlurmCommands::queue(const std::string& name,
                                                            std::string& why,
                                                            const ProgramPatience& patience) const {
  const Printed printed = run_program(
      {"squeue", "--noheader", "--array", "--name=" + name, "--format=%F %K %T|%B|%P|%r"},
      patience);
  if (printed.exit_code == 0) return tasks_of_queue(printed.out);
  why = words_of(printed);
  return std::nullopt;
}

bool SlurmCommands::wait_for_cancelled(const std::string& name,
                                       std::chrono::milliseconds longest) const {
  const auto end = std::chrono::steady_clock::now() + longest;
  std::string why;
  for (auto left = longest; left.count() > 0;
       left = std::chrono::duration_cast<std::chrono::milliseconds>(
           end - std::chrono::steady_clock::now())) {
    const auto there = queue(name, why, {left, nullptr, false});
    if (there && there->empty()) return true;
    std::this_thread::sleep_for(kBetweenLooks);
  }
  return false;
}

std::vector<NodeState> SlurmCommands::nodes(const std::vector<std::string>& partitions) const {
  if (partitions.empty() || !in_path("sinfo")) return {};
  std::string list;
  for (const std::string& one : partitions) list += (list.empty() ? "" : ",") + one;
  const Printed printed = run_program(
      {"sinfo", "--noheader", "--Node", "--partition=" + list, "--format=%R|%a|%N|%T"}, patience_);
  return printed.exit_code == 0 ? nodes_of_list(printed.out) : std::vector<NodeState>{};
}

void SlurmCommands::let_run(const std::string& job, std::size_t running) const {
  run_program(
      {"scontrol", "update", "JobId=" + job, "ArrayTaskThrottle=" + std::to_string(running)},
      patience_);
}

bool SlurmCommands::cancel(const std::string& name) const {
  // A controller that is busy hears of it later: scancel goes on asking.
  return run_program({"scancel", "--name=" + name}, {kLongestCancel, nullptr, true}).exit_code == 0;
}

void SlurmCommands::cancel_tasks(const std::vector<std::string>& tasks) const {
  // A command line has an end.
  constexpr std::size_t kMostWords = 200;
  for (std::size_t at = 0; at < tasks.size(); at += kMostWords) {
    std::vector<std::string> command = {"scancel"};
    for (std::size_t i = at; i < std::min(tasks.size(), at + kMostWords); ++i)
      command.push_back(tasks[i]);
    run_program(command, patience_);
  }
}

std::string SlurmCommands::ending(const std::string& job, std::size_t number) const {
  const Printed printed =
      run_program({"scontrol", "show", "job", job + "_" + std::to_string(number)}, patience_);
  std::string state = value_of(printed.out, "JobState");
  if (printed.exit_code != 0 || state.empty()) return {};
  // CODE:SIGNAL
  const std::string exit = value_of(printed.out, "ExitCode");
  const std::size_t colon = exit.find(':');
  if (colon == std::string::npos || exit == "0:0") return state;
  const std::string signal = exit.substr(colon + 1);
  return state + (signal == "0" ? ", exit code " + exit.substr(0, colon) : ", signal " + signal);
}

std::string value_of(const std::string& printed, const std::string& key) {
  std::istringstream words(printed);
  for (std::string word; words >> word;) {
    if (word.compare(0, key.size() + 1, key + "=") == 0) return word.substr(key.size() + 1);
    std::string equals, value;
    if (word == key && words >> equals >> value && equals == "=") return value;
  }
  return {};
}

}  // namespace limitgauge::study
