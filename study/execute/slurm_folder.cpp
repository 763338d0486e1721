#include "study/execute/slurm_folder.h"

#include <fstream>
#include <iterator>

#include "model/base/output_file.h"

namespace limitgauge::study {
namespace fs = std::filesystem;
namespace {

std::string script_text(const fs::path& folder, const std::vector<std::string>& worker) {
  std::string text = "#!/bin/sh\nexec";
  for (const std::string& word : worker) text += " " + shell_word(word);
  // As many threads as the task was given processors: --slurm-option=--cpus-per-task=4.
  return text + " --threads \"${SLURM_CPUS_PER_TASK:-1}\" --worker " +
         shell_word(folder.string() + "/") + "\"$SLURM_ARRAY_TASK_ID.tasks\"\n";
}

std::string tasks_text(const std::vector<CaseRequest>& requests,
                       const std::vector<std::size_t>& batch) {
  std::string text;
  for (const std::size_t position : batch) {
    const CaseRequest& request = requests[position];
    text += to_line(WorkerTask{request.index, request.key, request.overrides});
  }
  return text;
}

}  // namespace

std::string shell_word(const std::string& text) {
  std::string word = "'";
  for (const char c : text) {
    if (c == '\'')
      word += "'\\''";
    else
      word += c;
  }
  return word + "'";
}

ArrayFolder::ArrayFolder(fs::path folder, const std::vector<CaseRequest>& requests,
                         const std::vector<std::vector<std::size_t>>& batches,
                         const std::vector<std::string>& worker)
    : folder_(std::move(folder)), read_bytes_(batches.size(), 0) {
  for (std::size_t task = 0; task < batches.size(); ++task) {
    model::write_whole_file(folder_ / (std::to_string(task) + ".tasks"),
                            tasks_text(requests, batches[task]));
  }
  model::write_whole_file(script(), script_text(folder_, worker));
}

fs::path ArrayFolder::log(std::size_t task) const {
  return folder_ / (std::to_string(task) + ".log");
}

std::vector<WorkerAnswer> ArrayFolder::new_answers(std::size_t task) {
  std::ifstream in(folder_ / (std::to_string(task) + ".out"), std::ios::binary);
  std::vector<WorkerAnswer> answers;
  if (!in.seekg(static_cast<std::streamoff>(read_bytes_[task]))) return answers;
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::size_t begin = 0;
  for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    if (const auto answer = answer_of_line(text.substr(begin, end - begin)))
      answers.push_back(*answer);
    begin = end + 1;
  }
  read_bytes_[task] += begin;
  return answers;
}

}  // namespace limitgauge::study
