#include "app/study/study_file.h"

#include <algorithm>

#include "app/job/job_parts.h"
#include "app/job/job_reader.h"
#include "app/study/study_figures.h"
#include "app/study/study_variables.h"
#include "app/toml/toml_table.h"
#include "app/toml/toml_text.h"
#include "model/text/message_text.h"
#include "study/plan/settings.h"

namespace limitgauge::app {
namespace {

using Overrides = std::vector<std::string>;

/// The job that a study varies.
struct BaseJob {
  const StudyFile& file;
  const std::string& text;
  Overrides overrides;

  std::string name() const { return file.plan.job.string(); }
  Job read_with(const Overrides& more) const {
    Overrides all = overrides;
    all.insert(all.end(), more.begin(), more.end());
    return read_job_text(text, name(), file.plan.job.parent_path(), all);
  }
};

/// What stands at a dotted key, found as --set finds it.
const toml::node* find(const toml::table& job, const std::string& key) {
  const toml::node* at = &job;
  for (std::size_t from = 0; at != nullptr && from <= key.size();) {
    const std::size_t dot = std::min(key.find('.', from), key.size());
    const std::string name = key.substr(from, dot - from);
    if (const toml::table* table = at->as_table()) {
      at = table->get(name);
    } else {
      const toml::array* entries = at->as_array();
      at = entries == nullptr ? nullptr : entry_named(*entries, name);
    }
    from = dot + 1;
  }
  return at;
}

void take_bases(StudyFile& file, const BaseJob& job) {
  toml::table table = parse_toml(job.text, job.name());
  apply_overrides(table, job.overrides);
  for (std::size_t v = 0; v < file.plan.variables.size(); ++v) {
    study::Variable& variable = file.plan.variables[v];
    if (variable.base) continue;
    if (const toml::node* found = find(table, variable.key))
      variable.base = setting_of(*found, "\"" + variable.key + "\" in the job");
    if (!variable.base && file.plan.method == study::Method::one_at_a_time)
      throw model::InputError(
          file.keys[v],
          "the job does not state \"" + variable.key + "\", so that there is nothing to hold it at",
          "base = ... beside it, or the key in the job");
  }
}

std::string first_override(const study::Variable& variable) {
  const study::Setting first =
      variable.range ? study::number_setting(variable.range->low) : variable.values.front();
  return variable.key + "=" + first.toml;
}

/// The part of an error that says what is wrong, without the place that it names.
std::string without_place(const std::string& what) {
  constexpr std::string_view kMark = "error: ";
  const std::size_t at = what.find(kMark);
  return at == std::string::npos ? what : what.substr(at + kMark.size());
}

/// A key that --set would refuse, or that no job has. What the job says of the setting is for the
/// case that has it.
void require_job_key(const BaseJob& job, std::size_t v) {
  const study::Variable& variable = job.file.plan.variables[v];
  const std::string override = first_override(variable);
  const auto refuse = [&](const model::InputError& error) {
    throw model::InputError(job.file.keys[v],
                            "\"" + variable.key + "\": " + without_place(error.what()));
  };
  try {
    toml::table table = parse_toml(job.text, job.name());
    apply_overrides(table, {&override, 1});
  } catch (const model::InputError& error) {
    refuse(error);
  }
  try {
    job.read_with({override});
  } catch (const UnknownKey& error) {
    refuse(error);
  } catch (const model::InputError&) {
    // Another setting, or another key beside it, may be in order.
  }
}

/// A figure that is to be small, or a margin: of those, a front makes sense.
void require_objective(const std::string& id, const FigureScope& scope,
                       const model::SourcePlace& place) {
  const std::vector<std::string> ids = objective_ids(scope);
  if (std::find(ids.begin(), ids.end(), id) != ids.end()) return;
  const std::vector<std::string_view> known(ids.begin(), ids.end());
  throw model::InputError(
      place, "no figure \"" + id + "\" that is to be small",
      "\"" + model::nearest_word(id, known) + "\" or another figure of the stages");
}

/// A study weighs accuracy against time.
void require_design(const Job& job, const StudyFile& file) {
  if (job.design) return;
  throw model::InputError(
      {file.plan.job.string(), 0, 0},
      "the job has no [surface], and a study tunes what is measured against one",
      "a job with [surface]; without one, `limitgauge run` case by case");
}

void require_figures(const StudyFile& file, const Job& job) {
  std::vector<std::string> keys;
  for (const study::Variable& variable : file.plan.variables) keys.push_back(variable.key);
  const FigureScope scope = figure_scope(job, keys);
  if (!file.plan.search.largest) {
    require_objective(file.plan.cost, scope, file.cost);
    require_objective(file.plan.search.cost, scope, file.search_cost);
  }
  for (const std::string& id : file.plan.accuracy) require_objective(id, scope, file.accuracy);
}

}  // namespace

void relate_to_job(StudyFile& file, const std::string& job_text,
                   std::span<const std::string> overrides) {
  const BaseJob job{file, job_text, {overrides.begin(), overrides.end()}};
  for (std::size_t v = 0; v < file.plan.variables.size(); ++v) require_job_key(job, v);
  const Job read = job.read_with({});
  require_design(read, file);
  take_bases(file, job);
  require_figures(file, read);
}

}  // namespace limitgauge::app
