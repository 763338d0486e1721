#include "tests/app/toml/job_page.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <sstream>

#include "app/toml/toml_table.h"
#include "model/text/number_text.h"
#include "tests/app/job_text.h"
#include "tests/support/catch.h"

namespace limitgauge::app {
namespace {

/// The way to a table of a job: keys, and indices of entries where they are arrays.
struct Step {
  std::string key;
  std::optional<std::size_t> index;
};
using Path = std::vector<Step>;

/// A key of a table in one of the jobs.
struct Occurrence {
  const toml::table* job;
  Path table;
  std::string key;
};

toml::table& table_at(toml::table& job, const Path& path) {
  toml::table* at = &job;
  for (const Step& step : path) {
    toml::node* node = at->get(step.key);
    at = (step.index ? node->as_array()->get(*step.index) : node)->as_table();
  }
  return *at;
}

std::string dotted(const std::string& prefix, const std::string& key) {
  // The nine work offsets are one row, and so are all tools that have tolerances.
  if (prefix.ends_with(".work_offsets.")) return prefix + "G54";
  return prefix + (prefix == "tolerances.tool." ? "ID" : key);
}

using Catch::Matchers::EndsWith;
/// `prefix` is dotted, without names of entries: "stage.gate.".
using Visit = std::function<void(const toml::table& table, const Path&, const std::string& prefix)>;

/// All tables of a job, itself first.
void visit_tables(const toml::table& table, const Path& path, const std::string& prefix,
                  const Visit& visit) {
  visit(table, path, prefix);
  for (auto&& [key, node] : table) {
    const std::string name(key.str());
    const std::string below = dotted(prefix, name) + ".";
    const auto enter = [&](const toml::node& entry, std::optional<std::size_t> index) {
      Path inner = path;
      inner.push_back({name, index});
      if (const toml::table* one = entry.as_table()) visit_tables(*one, inner, below, visit);
    };
    const toml::array* list = node.as_array();
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i) enter(*list->get(i), i);
    if (list == nullptr) enter(node, std::nullopt);
  }
}

bool holds_tables(const toml::node& node) {
  const toml::array* list = node.as_array();
  return node.is_table() || (list != nullptr && !list->empty() && list->get(0)->is_table());
}

std::string text_of(const toml::table& job) {
  std::ostringstream out;
  out << job;
  return out.str();
}

class Jobs {
 public:
  Jobs() {
    for (const std::string& text : jobs_with_every_key()) jobs_.push_back(toml::parse(text));
    for (const toml::table& job : jobs_)
      visit_tables(job, {}, "",
                   [&](const toml::table& table, const Path& path, const std::string& prefix) {
                     for (auto&& [key, node] : table)
                       note(node, dotted(prefix, std::string(key.str())),
                            {&job, path, std::string(key.str())});
                   });
  }

  const std::vector<toml::table>& jobs() const { return jobs_; }
  const std::set<std::string>& tables() const { return tables_; }
  const std::map<std::string, std::vector<Occurrence>>& keys() const { return keys_; }

 private:
  /// A work offset is a value or a table.
  void note(const toml::node& node, const std::string& name, Occurrence at) {
    if (holds_tables(node)) tables_.insert(name);
    if (!holds_tables(node) || name.ends_with(".work_offsets.G54"))
      keys_[name].push_back(std::move(at));
  }

  std::vector<toml::table> jobs_;
  std::set<std::string> tables_;
  std::map<std::string, std::vector<Occurrence>> keys_;
};

/// What the job is refused with when the key's value is another: `value` as TOML, or none at all.
std::string error_with(const Occurrence& at, const std::string& value) {
  toml::table job = *at.job;
  toml::table& table = table_at(job, at.table);
  table.erase(at.key);
  if (!value.empty()) {
    const toml::table stated = toml::parse("value = " + value);
    stated.get("value")->visit([&](const auto& node) { table.insert(at.key, node); });
  }
  return error_of(text_of(job));
}

bool accepted(const Occurrence& at, const std::string& value) {
  return error_with(at, value) == "no error";
}

/// Values at and beyond the ends of a range.
struct Ends {
  std::vector<std::string> inside, outside;
};

/// For the words of docs/job.md's column "range"; nothing where they are words of another kind.
std::optional<Ends> ends_of(const std::string& range) {
  static const std::vector<std::pair<std::string, Ends>> kRanges = {
      {"> 0, or `auto`", {{"\"auto\""}, {"0", "-1", "\"fine\""}}},
      {"-60 to 60, or `auto`",
       {{"-60", "60", "\"auto\""}, {"-60.01", "60.01", "\"least\"", "nan"}}},
      {"-60 to 60", {{"-60", "60"}, {"-60.01", "60.01", "\"auto\""}}},
      {"> 0, < 90", {{"1", "89"}, {"0", "90"}}},
      {"> 0, < 180", {{"60", "179"}, {"0", "180"}}},
      {"> 0 for a bull, ≥ 0 else", {{}, {"-1"}}},
      {"> 0", {{}, {"0", "-1", "nan", "\"1\""}}},
      {"≥ 0", {{"0"}, {"-1", "inf"}}},
      {"0 to 1", {{"0", "1"}, {"-0.01", "1.01"}}},
      {"0 to 90", {{"0", "90"}, {"-0.01", "90.01"}}},
      {"whole, 0 to 9", {{}, {"-1", "0.5", "10"}}},
      {"whole, 0 up", {{}, {"-1", "0.5"}}},
      {"whole, 1 up", {{"1"}, {"-1", "0.5"}}},
      {"true, false", {{"true", "false"}, {"1", "\"true\""}}},
      {"three numbers > 0", {{"[1, 2, 3]"}, {"[1, 2, 0]", "[1, 2]"}}},
      {"three numbers, or a table", {{"[-1, 0, 2]"}, {"[1, 2]", "1"}}},
      {"three numbers", {{"[-1, 0, 2]"}, {"[1, 2]", "[1, 2, \"3\"]", "1"}}},
      {"two ascending numbers", {{"[-1, 0.5]"}, {"[2, 1]", "[1, 1]", "[1, 2, 3]"}}},
      {"two ascending whole numbers", {{"[1, 1]", "[1, 2]"}, {"[2, 1]", "[1, 2.5]"}}},
      {"a file", {{}, {"\"no-such-file\"", "\"\"", "1"}}},
      {"a folder", {{}, {"\"no-such-folder\"", "\"\"", "1"}}},
      {"any", {{}, {"\"1\"", "nan"}}},
      {"0 to 1, or an area",
       {{"0", "1", "\"0 mm2\"", "\"12.5mm²\""},
        {"-0.01", "1.01", "nan", "\"\"", "\"0.5\"", "\"-1 mm2\"", "\"2 cm2\"", "true"}}},
      {"± or [low, high]",
       {{"0.001", "0", "[-0.001, 0.002]", "[0.001, 0.001]"},
        {"-0.001", "[0.002, 0.001]", "[0.1]", "nan", "\"0.01\""}}},
      {"three of ± or [low, high]",
       {{"[0, 0.001, 0.002]", "[[-0.001, 0], 0, 0]"}, {"0.001", "[0, 0]", "[0, 0, -1]"}}},
      {"three numbers ≥ 0", {{"[0, 0.001, 0]"}, {"[0, -0.001, 0]", "0.001", "[[0, 0.1], 0, 0]"}}},
      {"text", {{}, {"\"\"", "1"}}},
      {"text, once", {{}, {"\"\"", "1"}}},
      {"an `id`", {{}, {"\"no-such-tool\""}}},
      {"a machine's axis, `spindle`, `none`", {{"\"none\"", "\"A\""}, {"\"Z\"", "1"}}},
      {"a setup's name", {{}, {"\"no-such-setup\"", "1"}}},
      {"three rows of a rotation",
       {{"[[0, -1, 0], [1, 0, 0], [0, 0, 1]]"},
        {"[1, 2, 3]", "[[1, 0, 0], [0, 1, 0], [0, 0, -1]]", "[[1, 0, 0], [0, 1, 0], [0, 0, 2]]"}}},
      {"as the job's, once", {{}, {"\"a/b\"", "\".a\""}}},
      {"letters, digits, `.`, `_`, `-`; 100 at most, the first neither `.` nor `-`",
       {{"\"a.B_9-\""}, {"\"a b\"", "\".a\"", "\"-a\"", "\"a/b\""}}}};
  for (const auto& [words, ends] : kRanges)
    if (range == words) return ends;
  return std::nullopt;
}

/// "`a`, `b`" as "\"a\", \"b\"", which is how an error lists choices.
std::string choices_of(std::string range) {
  for (char& c : range)
    if (c == '`') c = '"';
  return range;
}

std::string joined(const std::set<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += word + '\n';
  return all;
}

}  // namespace

TEST_CASE("docs/job.md has the keys that a job can have, and no others", "[unit][job]") {
  const Jobs jobs;
  std::set<std::string> known;
  for (const toml::table& job : jobs.jobs()) {
    REQUIRE(error_of(text_of(job)) == "no error");
    visit_tables(job, {}, "", [&](const toml::table&, const Path& path, const std::string& prefix) {
      toml::table other = job;
      table_at(other, path).insert("no-such-key", 1);
      INFO("in " << prefix);
      try {
        read(text_of(other));
        FAIL("an unknown key was taken");
      } catch (const UnknownKey& error) {
        for (const std::string& key : error.known()) known.insert(dotted(prefix, key));
      }
    });
  }
  std::set<std::string> documented, leaves;
  for (const auto& [key, row] : documented_keys()) documented.insert(key);
  for (const std::string& key : known) {
    // Otherwise a key could hold keys that were not looked at.
    INFO(key << " is in none of the jobs of this test");
    REQUIRE((jobs.keys().count(key) > 0 || jobs.tables().count(key) > 0));
    if (jobs.keys().count(key) > 0) leaves.insert(key);
  }
  CHECK(joined(documented) == joined(leaves));
}

TEST_CASE("ranges in docs/job.md are those of the reader", "[unit][job]") {
  const Jobs jobs;
  for (const auto& [key, row] : documented_keys()) {
    INFO(key << ": " << row.range);
    REQUIRE(jobs.keys().count(key) == 1);
    const std::vector<Occurrence>& places = jobs.keys().at(key);
    const std::optional<Ends> ends = ends_of(row.range);
    if (!ends) {
      // A list of words: the reader's own error names the same.
      const std::string error = error_with(places.front(), "\"no-such-word\"");
      CHECK_THAT(error, EndsWith("expected one of " + choices_of(row.range)));
      continue;
    }
    for (const std::string& value : ends->outside)
      for (const Occurrence& at : places) {
        INFO("with " << value);
        CHECK_FALSE(accepted(at, value));
      }
    for (const std::string& value : ends->inside) {
      INFO("with " << value << ": " << error_with(places.front(), value));
      CHECK(std::any_of(places.begin(), places.end(),
                        [&](const Occurrence& at) { return accepted(at, value); }));
    }
  }
}

TEST_CASE("docs/job.md says which keys must be stated", "[unit][job]") {
  const Jobs jobs;
  for (const auto& [key, row] : documented_keys()) {
    INFO(key << ", default " << row.fallback);
    REQUIRE(jobs.keys().count(key) == 1);
    const auto missed = [](const Occurrence& at) { return !accepted(at, ""); };
    const std::vector<Occurrence>& places = jobs.keys().at(key);
    if (row.fallback == "–")
      CHECK(std::any_of(places.begin(), places.end(), missed));
    else
      CHECK_FALSE(std::all_of(places.begin(), places.end(), missed));
  }
}

TEST_CASE("defaults in docs/job.md are those of the reader", "[unit][job]") {
  const Job job = read(with(good_job(), "strategy = \"zigzag\"", "strategy = \"steep_shallow\""));
  const JobStage& stage = job.stages.at(0);
  const engine::strategy::CutOptions& cut = stage.plan->cut;
  using engine::strategy::Entry;
  const std::map<std::string, std::string> defaults = {
      {"surface.precision", model::shortest(job.design->precision_mm)},
      {"surface.transform.scale", model::shortest(job.design->placement.scale)},
      {"machine.rapid", model::shortest(job.rapid_mm_min)},
      {"machine.clearance", model::shortest(job.clearance_mm)},
      {"machine.acceleration", job.acceleration_mm_s2 ? "some" : "none"},
      {"machine.junction_deviation", model::shortest(job.junction_deviation_mm)},
      {"program_frame.rotate_z", model::shortest(job.program_frame.rotate_z_deg)},
      {"post.dialect", model::name(job.post.dialect)},
      {"post.decimals", std::to_string(job.post.decimals)},
      {"post.arcs", job.post.arc_tolerance_mm ? "some" : "none"},
      {"post.line_numbers", job.post.line_numbers ? "true" : "false"},
      {"post.cl_data", job.post.cl_data ? "true" : "false"},
      {"tool.flute_length", model::shortest(stage.cutter.flute_length_mm / 6) + " diameters"},
      {"tool.plunge", stage.cutter.steepest_descent_deg == 90 ? "true" : "false"},
      {"stage.allowance", model::shortest(stage.allowance_mm)},
      {"stage.plunge_feed",
       cut.plunge_feed_mm_min == Approx(500) ? "a third of the feed" : "other"},
      {"stage.link_feed", cut.link_feed_mm_min == cut.feed_mm_min ? "the feed" : "other"},
      {"stage.angle", model::shortest(cut.angle_deg)},
      {"stage.steep_angle", model::shortest(cut.steep_angle_deg)},
      {"stage.overlap", cut.overlap_or_default_mm() == 2 * cut.step_mm ? "two steps" : "other"},
      {"stage.boundary_pass", cut.boundary_pass ? "true" : "false"},
      {"stage.entry", cut.entry == Entry::ramp ? "ramp" : "other"},
      {"stage.ramp_angle", model::shortest(cut.ramp_angle_deg)},
      {"stage.gate.uncut", stage.limits.has_uncut ? "some" : "none"},
      {"simulation.voxel", job.voxel_mm ? "some" : "auto"},
      {"verification.resolution", job.resolution_mm ? "some" : "auto"},
      {"tolerances.margin", job.finds_margin ? "true" : "false"},
      {"report.stock", job.stock_surface == reports::StockSurfaceFile::cut ? "cut" : "other"},
      {"report.pictures", job.pictures ? "true" : "false"}};
  const std::map<std::string, DocumentedKey> page = documented_keys();
  for (const auto& [key, value] : defaults) {
    INFO(key);
    REQUIRE(page.count(key) == 1);
    CHECK(page.at(key).fallback == value);
  }
}

}  // namespace limitgauge::app
