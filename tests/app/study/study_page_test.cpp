#include <set>

#include "app/study/study_file.h"
#include "app/toml/toml_table.h"
#include "model/base/text_file.h"
#include "model/text/number_text.h"
#include "tests/app/job_text.h"
#include "tests/app/toml/job_page.h"
#include "tests/support/catch.h"
#include "tests/support/folders.h"

namespace limitgauge::app {
namespace {

using study::Method;

/// Studies that are in order and have every documented key between them, a line each.
const std::string kDrawn = R"(name = "a"
job = "jobs/quick-dome.toml"
method = "random"
samples = 2
seed = 1
[[vary]]
key = "stage.finish.step"
range = [0.1, 1]
scale = "log"
[objectives]
cost = "machining_time_s"
accuracy = ["gate_excess"]
)";
const std::string kCounted = R"(name = "a"
job = "jobs/quick-dome.toml"
method = "one_at_a_time"
[[vary]]
key = "stage.finish.scallop"
range = [0.1, 1]
steps = 3
base = 0.1
[[vary]]
key = "stage.finish.step"
values = [0.1]
)";
const std::string kSearched = R"(name = "a"
job = "jobs/quick-dome.toml"
method = "search"
[[vary]]
key = "stage.finish.step"
values = [0.1, 0.2]
[search]
cost = "machining_time_s"
most_cases = 30
accuracy = 0.1
batch = 2
)";

const std::string kLargest = R"(name = "a"
job = "jobs/quick-dome.toml"
method = "search"
[[vary]]
key = "stage.finish.step"
values = [0.1, 0.2]
[search]
largest = "stage.finish.step"
)";

StudyFile read_related(const std::string& text) {
  StudyFile file = read_study_text(text, "study.toml", tests::fixtures());
  relate_to_job(file, model::read_text_file(file.plan.job), {});
  return file;
}

bool accepted(const std::string& text) {
  try {
    read_related(text);
    return true;
  } catch (const model::InputError&) {
    return false;
  }
}

/// The keys that the reader knows in the table that `header` begins, as it says itself.
std::vector<std::string> known_keys(const std::string& text, const std::string& header) {
  const std::string line = header.empty() ? "name = \"a\"\n" : header + "\n";
  try {
    read_related(with(text, line, line + "no_such_key = 1\n"));
  } catch (const UnknownKey& unknown) {
    return unknown.known();
  }
  return {};
}

std::string last_name(const std::string& dotted) {
  return dotted.substr(dotted.rfind('.') + 1);
}

/// `text` without the line that states a key, and without what is beside it.
std::string without(std::string text, const std::string& key) {
  const std::size_t at = text.find("\n" + key + " = ") + 1;
  return text.erase(at, text.find('\n', at) - at + 1);
}

}  // namespace

TEST_CASE("docs/study.md has the keys that the reader knows, no others", "[unit][study]") {
  std::set<std::string> known;
  const auto add = [&](const std::string& prefix, const std::vector<std::string>& keys) {
    REQUIRE_FALSE(keys.empty());
    for (const std::string& key : keys) known.insert(prefix + key);
  };
  add("", known_keys(kDrawn, ""));
  add("vary.", known_keys(kDrawn, "[[vary]]"));
  add("objectives.", known_keys(kDrawn, "[objectives]"));
  add("search.", known_keys(kSearched, "[search]"));
  // Tables; what is in them has rows of its own, and a case has whatever the job has.
  for (const char* table : {"vary", "case", "objectives", "search"}) CHECK(known.erase(table) == 1);
  std::set<std::string> documented;
  for (const auto& [key, row] : documented_keys("study.md")) documented.insert(key);
  CHECK(documented == known);
}

TEST_CASE("keys of studies without a default must be stated, others need not", "[unit][study]") {
  for (const auto& [key, row] : documented_keys("study.md")) {
    INFO(key << ", default " << row.fallback);
    bool stated = false, missed = false;
    for (const std::string& text : {kDrawn, kCounted, kSearched, kLargest}) {
      REQUIRE(accepted(text));
      if (text.find("\n" + last_name(key) + " = ") == std::string::npos && key != "name") continue;
      stated = true;
      const std::string less =
          key == "name" ? with(text, "name = \"a\"\n", "") : without(text, last_name(key));
      missed = missed || !accepted(less);
    }
    CHECK(stated);
    if (row.fallback == "–") CHECK(missed);
  }
  CHECK(accepted(without(without(kDrawn, "seed"), "scale")));
  CHECK(accepted(without(without(kSearched, "most_cases"), "batch")));
}

TEST_CASE("defaults in docs/study.md are those of the reader", "[unit][study]") {
  const study::Plan plain = read_related(
                                "name = \"a\"\njob = \"jobs/quick-dome.toml\"\n[[vary]]\nkey = "
                                "\"stage.finish.step\"\nrange = [0.1, 1]\nsteps = 3\n")
                                .plan;
  const study::Plan job = read_related(kCounted).plan;
  const std::map<std::string, DocumentedKey> page = documented_keys("study.md");
  const std::map<std::string, std::string> defaults = {
      {"method", study::name(plain.method)},
      {"seed", std::to_string(plain.seed)},
      {"vary.scale", plain.variables[0].range->logarithmic ? "log" : "linear"},
      {"vary.base", job.variables[1].base->toml == "0.3" ? "the job's own" : "other"},
      {"objectives.cost", plain.cost},
      {"search.cost", plain.search.cost == plain.cost ? "the cost of the objectives" : "other"},
      {"search.largest", plain.search.largest.value_or("none")},
      {"search.most_cases", std::to_string(plain.search.most_cases)},
      {"search.accuracy", model::shortest(plain.search.accuracy)},
      {"search.batch", std::to_string(plain.search.batch)}};
  for (const auto& [key, value] : defaults) {
    INFO(key);
    REQUIRE(page.count(key) == 1);
    CHECK(page.at(key).fallback == value);
  }
  std::string methods;
  for (const Method method : {Method::grid, Method::list, Method::random, Method::latin_hypercube,
                              Method::one_at_a_time, Method::search})
    methods += (methods.empty() ? "`" : ", `") + std::string(study::name(method)) + "`";
  CHECK(page.at("method").range == methods);
}

}  // namespace limitgauge::app
