#include "app/study/study_file.h"

#include <algorithm>
#include <limits>

#include "app/job/job_reader.h"
#include "app/study/study_variables.h"
#include "app/toml/toml_text.h"
#include "model/base/text_file.h"
#include "study/plan/design.h"
#include "study/plan/sampling.h"

namespace limitgauge::app {
namespace {

using study::Method;

constexpr std::pair<const char*, Method> kMethods[] = {{"grid", Method::grid},
                                                       {"list", Method::list},
                                                       {"random", Method::random},
                                                       {"latin_hypercube", Method::latin_hypercube},
                                                       {"one_at_a_time", Method::one_at_a_time},
                                                       {"search", Method::search}};

Method read_method(const TomlTable& root) {
  if (!root.has("method")) return Method::grid;
  const std::string stated = root.one_of(
      "method", {"grid", "list", "random", "latin_hypercube", "one_at_a_time", "search"});
  for (const auto& [word, method] : kMethods)
    if (stated == word) return method;
  return Method::grid;
}

bool is_drawn(Method method) {
  return method == Method::random || method == Method::latin_hypercube;
}

/// Keys that another method reads.
void refuse_idle_keys(const TomlTable& root, Method method) {
  const auto refuse_beside = [&](const char* key, bool used) {
    if (root.has(key) && !used)
      refuse(root.place(key),
             "\"" + std::string(key) + "\" beside the method \"" + study::name(method) +
                 "\" would change nothing",
             "it only beside a method that reads it");
  };
  refuse_beside("samples", is_drawn(method));
  refuse_beside("seed", is_drawn(method));
  refuse_beside("case", method == Method::list);
  refuse_beside("vary", method != Method::list);
  refuse_beside("search", method == Method::search);
}

std::string read_name(const TomlTable& root) {
  const std::string name = root.text("name");
  if (!is_plain_name(name))
    refuse(root.place("name"), "\"" + name + "\" cannot name a folder",
           "letters, digits, '.', '_', '-'");
  return name;
}

void read_job_path(const TomlTable& root, const std::filesystem::path& folder, study::Plan& plan) {
  plan.job_as_stated = root.text("job");
  plan.job = folder / plan.job_as_stated;
  if (!model::is_file(plan.job))
    refuse(root.place("job"), "no file \"" + plan.job_as_stated + "\"", "a job file");
}

void read_variables(const TomlTable& root, StudyFile& file) {
  const Method method = file.plan.method;
  std::vector<VariedKey> keys;
  if (method == Method::list) {
    ListedCases listed = read_cases(root);
    keys = std::move(listed.keys);
    file.plan.listed = std::move(listed.cases);
  } else {
    keys = read_varied(root, method == Method::grid || method == Method::one_at_a_time);
  }
  for (VariedKey& key : keys) {
    file.plan.variables.push_back(std::move(key.variable));
    file.keys.push_back(std::move(key.place));
  }
}

std::size_t whole_from(const TomlTable& table, const char* key, int least, std::size_t most) {
  const int value = table.whole(key);
  if (value < least || static_cast<std::size_t>(value) > most)
    refuse(table.place(key),
           "\"" + std::string(key) + "\" in " + table.where() + " is " + std::to_string(value),
           "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return static_cast<std::size_t>(value);
}

void read_drawing(const TomlTable& root, study::Plan& plan) {
  if (!is_drawn(plan.method)) return;
  plan.samples = static_cast<std::size_t>(root.whole("samples"));
  if (root.has("seed")) plan.seed = static_cast<std::uint64_t>(root.whole("seed"));
  const std::optional<std::size_t> room = study::combinations(plan);
  if (plan.samples == 0 || (room && *room < plan.samples))
    refuse(root.place("samples"),
           "\"samples\" is " + std::to_string(plan.samples) +
               (room ? " of " + std::to_string(*room) + " combinations" : std::string()),
           "one or more, and no more than there are combinations");
}

std::vector<std::string> read_texts(const TomlTable& table, const toml::table& raw,
                                    const char* key) {
  const toml::array* list = raw.get(key)->as_array();
  if (list == nullptr || list->empty())
    refuse(table.place(key), "\"" + std::string(key) + "\" is no list with anything in it",
           "a list of figures, as [\"finish.uncut_mm.high\"]");
  std::vector<std::string> texts;
  for (const toml::node& entry : *list) {
    const std::string text = entry.value_exact<std::string>().value_or("");
    if (text.empty())
      refuse(place_of(entry.source()), "an entry that is no text", "the id of a figure");
    if (std::find(texts.begin(), texts.end(), text) != texts.end())
      refuse(place_of(entry.source()), "\"" + text + "\" a second time", "each figure once");
    texts.push_back(text);
  }
  return texts;
}

void read_objectives(const TomlTable& root, StudyFile& file) {
  file.cost = file.accuracy = root.place();
  if (!root.has("objectives")) return;
  const toml::table& raw = root.table("objectives");
  const TomlTable objectives(raw, "[objectives]", {"cost", "accuracy"});
  if (objectives.has("cost")) file.plan.cost = objectives.text("cost");
  if (objectives.has("accuracy")) file.plan.accuracy = read_texts(objectives, raw, "accuracy");
  file.cost = objectives.place("cost");
  file.accuracy = objectives.place("accuracy");
  const std::vector<std::string>& bought = file.plan.accuracy;
  if (std::find(bought.begin(), bought.end(), file.plan.cost) != bought.end())
    refuse(file.accuracy, "\"" + file.plan.cost + "\" is the cost", "other figures");
}

bool is_number(const study::Setting& setting) {
  return setting.number.has_value();
}

/// The setting takes the place of whatever would be least.
void read_largest(const TomlTable& root, const TomlTable& table, StudyFile& file) {
  const std::string key = table.text("largest");
  const auto refuse_it = [&](const std::string& wrong, const std::string& expected) {
    refuse(table.place("largest"), wrong, expected);
  };
  const std::vector<study::Variable>& varied = file.plan.variables;
  if (varied.size() != 1 || varied[0].key != key)
    refuse_it("\"" + key + "\" is not the one key that is varied",
              "\"" + varied[0].key + "\" alone");
  if (!std::all_of(varied[0].values.begin(), varied[0].values.end(), is_number))
    refuse_it("settings of \"" + key + "\" are no numbers",
              "a key of which all settings are numbers");
  const bool has_cost = root.has("objectives") && root.table("objectives").contains("cost");
  if (table.has("cost") || has_cost)
    refuse_it("a cost is stated beside \"largest\"", "one of the two");
  file.plan.search.largest = key;
  file.plan.cost = file.plan.search.cost = study::kSearchedSetting;
}

void read_search(const TomlTable& root, StudyFile& file) {
  study::Search& search = file.plan.search;
  search.cost = file.plan.cost;
  file.search_cost = file.cost;
  if (!root.has("search")) return;
  const TomlTable table(root.table("search"), "[search]",
                        {"cost", "largest", "most_cases", "accuracy", "batch"});
  constexpr std::size_t kMostBatch = 64, kMostSearched = 10'000;
  if (table.has("cost")) search.cost = table.text("cost"), file.search_cost = table.place("cost");
  if (table.has("most_cases"))
    search.most_cases = whole_from(table, "most_cases", 2, kMostSearched);
  if (table.has("accuracy")) search.accuracy = table.between("accuracy", 1e-6, 0.5);
  if (table.has("largest")) read_largest(root, table, file);
  if (table.has("batch")) search.batch = whole_from(table, "batch", 1, kMostBatch);
}

void require_countable(const StudyFile& file) {
  const std::size_t count = study::case_count(file.plan);
  if (count <= study::kMostCases) return;
  const bool known = count < std::numeric_limits<std::size_t>::max();
  refuse(file.method,
         "the study has " + (known ? std::to_string(count) : "more than 10^19") + " cases",
         std::to_string(study::kMostCases) + " at most");
}

}  // namespace

StudyFile read_study_text(const std::string& text, const std::string& name_in_errors,
                          const std::filesystem::path& folder) {
  const toml::table table = parse_toml(text, name_in_errors);
  const TomlTable root(
      table, "the study",
      {"name", "job", "method", "samples", "seed", "vary", "case", "search", "objectives"});
  StudyFile file;
  file.plan.name = read_name(root);
  read_job_path(root, folder, file.plan);
  file.plan.method = read_method(root);
  file.method = root.place(root.has("samples") ? "samples" : "method");
  refuse_idle_keys(root, file.plan.method);
  read_variables(root, file);
  read_drawing(root, file.plan);
  read_objectives(root, file);
  read_search(root, file);
  require_countable(file);
  return file;
}

study::Plan read_study(const std::filesystem::path& file, std::span<const std::string> overrides) {
  StudyFile read = read_study_text(model::read_text_file(file), file.string(), file.parent_path());
  relate_to_job(read, model::read_text_file(read.plan.job), overrides);
  return std::move(read.plan);
}

}  // namespace limitgauge::app
