#include "study/execute/worker_lines.h"

#include <array>

#include "model/text/number_text.h"

namespace limitgauge::study {
namespace {

/// Closes every line: one that was cut short has none.
constexpr const char* kEnd = "end";
constexpr std::array<const char*, 3> kKinds = {"done", "error", "again"};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\\\";
    else if (c == '\t')
      result += "\\t";
    else if (c == '\n')
      result += "\\n";
    else
      result += c;
  }
  return result;
}

std::string plain(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      result += text[i];
      continue;
    }
    ++i;
    result += text[i] == 't' ? '\t' : text[i] == 'n' ? '\n' : text[i];
  }
  return result;
}

std::string line_of(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += escaped(field) + '\t';
  return line + kEnd + '\n';
}

/// Empty for a line that is not whole.
std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::size_t begin = 0;
  for (std::size_t tab = line.find('\t'); tab != std::string::npos; tab = line.find('\t', begin)) {
    fields.push_back(plain(std::string_view(line).substr(begin, tab - begin)));
    begin = tab + 1;
  }
  if (line.substr(begin) != kEnd) fields.clear();
  return fields;
}

}  // namespace

std::string to_line(const WorkerTask& task) {
  std::vector<std::string> fields = {"case", std::to_string(task.index), task.key};
  fields.insert(fields.end(), task.overrides.begin(), task.overrides.end());
  return line_of(fields);
}

std::string to_line(const WorkerAnswer& answer) {
  return line_of({kKinds[static_cast<std::size_t>(answer.kind)], std::to_string(answer.index),
                  model::shortest(answer.seconds), std::to_string(answer.peak_bytes),
                  answer.reason});
}

std::optional<WorkerTask> task_of_line(const std::string& line) {
  const std::vector<std::string> fields = fields_of(line);
  WorkerTask task;
  if (fields.size() < 3 || fields[0] != "case") return std::nullopt;
  const auto index = model::parse_whole<decltype(task.index)>(fields[1]);
  if (!index) return std::nullopt;
  task.index = *index;
  task.key = fields[2];
  task.overrides.assign(fields.begin() + 3, fields.end());
  return task;
}

std::optional<WorkerAnswer> answer_of_line(const std::string& line) {
  const std::vector<std::string> fields = fields_of(line);
  WorkerAnswer answer;
  if (fields.size() != 5) return std::nullopt;
  const auto index = model::parse_whole<decltype(answer.index)>(fields[1]);
  const auto seconds = model::parse_number(fields[2]);
  const auto peak = model::parse_whole<decltype(answer.peak_bytes)>(fields[3]);
  if (!index || !seconds || !peak) return std::nullopt;
  answer.index = *index;
  answer.seconds = *seconds;
  answer.peak_bytes = *peak;
  answer.reason = fields[4];
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    if (fields[0] != kKinds[kind]) continue;
    answer.kind = static_cast<WorkerAnswer::Kind>(kind);
    return answer;
  }
  return std::nullopt;
}

}  // namespace limitgauge::study
