#include "app/job/job_parts.h"

#include <algorithm>
#include <cmath>

#include "model/base/number_text.h"

namespace limitgauge::app {
namespace {

/// The table `key` of the job, or an empty one.
const toml::table& table_or_none(const TomlTable& root, const char* key) {
  static const toml::table none;
  return root.has(key) ? root.table(key) : none;
}

void read_acceleration(const TomlTable& machine, Job& job, JobContext& context) {
  if (machine.has("acceleration")) job.acceleration_mm_s2 = machine.positive("acceleration");
  if (machine.has("junction_deviation")) {
    if (!job.acceleration_mm_s2)
      throw model::InputError(
          machine.place("junction_deviation"),
          "\"junction_deviation\" without \"acceleration\" would change nothing",
          "both, or neither");
    job.junction_deviation_mm = machine.positive("junction_deviation");
  } else if (job.acceleration_mm_s2) {
    context.defaulted.push_back("junction deviation " + model::shortest(job.junction_deviation_mm) +
                                " mm (default)");
  }
}

model::Dialect read_dialect(const TomlTable& post) {
  const std::string word = post.one_of("dialect", {"linuxcnc", "fanuc", "grbl"});
  if (word == "fanuc") return model::Dialect::fanuc;
  return word == "grbl" ? model::Dialect::grbl : model::Dialect::linuxcnc;
}

int read_decimals(const TomlTable& post, model::Dialect dialect) {
  const double stated = post.number("decimals");
  const int most = model::rules(dialect).most_decimals;
  if (stated != std::floor(stated) || stated < 0 || stated > most)
    throw model::InputError(post.place("decimals"),
                            "\"decimals\" in [post] is " + model::shortest(stated) +
                                " for dialect " + model::name(dialect),
                            "a whole number from 0 to " + std::to_string(most));
  return static_cast<int>(stated);
}

/// Of keys that add something, leaving them out leaves it out: nothing is chosen.
void say_defaults(const TomlTable& post, const Job& job, JobContext& context) {
  std::string said;
  const auto say = [&](const char* key, const std::string& value) {
    if (post.has(key)) return;
    said += std::string(said.empty() ? " " : ", ") + key + " = " + value;
  };
  say("dialect", model::name(job.post.dialect));
  say("decimals", std::to_string(job.post.decimals));
  if (!said.empty()) context.defaulted.push_back("programs: defaults:" + said);
}

}  // namespace

void read_machine(const TomlTable& root, Job& job, JobContext& context) {
  const TomlTable machine(table_or_none(root, "machine"), "[machine]",
                          {"rapid", "clearance", "acceleration", "junction_deviation", "travel",
                           "work_offsets", "home", "second_home", "start"});
  if (machine.has("rapid")) {
    job.rapid_mm_min = machine.positive("rapid");
  } else {
    context.defaulted.push_back("rapid rate " + model::shortest(job.rapid_mm_min) +
                                " mm/min (default)");
  }
  read_acceleration(machine, job, context);
  if (machine.has("travel")) job.travel_mm = read_travel(machine);
  read_setup(root, machine, job);
  if (machine.has("clearance")) {
    job.clearance_mm = machine.positive("clearance");
  } else {
    context.defaulted.push_back("clearance of rapids above the stock " +
                                model::shortest(job.clearance_mm) + " mm (default)");
  }
}

void read_post(const TomlTable& root, Job& job, JobContext& context) {
  const TomlTable post(table_or_none(root, "post"), "[post]",
                       {"dialect", "decimals", "arcs", "line_numbers", "cl_data"});
  if (post.has("dialect")) job.post.dialect = read_dialect(post);
  job.post.decimals = post.has("decimals") ? read_decimals(post, job.post.dialect)
                                           : model::rules(job.post.dialect).default_decimals;
  if (post.has("arcs")) job.post.arc_tolerance_mm = post.positive("arcs");
  if (post.has("line_numbers")) job.post.line_numbers = post.boolean("line_numbers");
  if (post.has("cl_data")) job.post.cl_data = post.boolean("cl_data");
  const auto planned = [](const JobStage& stage) { return stage.plan.has_value(); };
  if (std::any_of(job.stages.begin(), job.stages.end(), planned)) say_defaults(post, job, context);
}

}  // namespace limitgauge::app
