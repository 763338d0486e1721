#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/study/figure_column.h"
#include "reports/text/embedded.h"
#include "tests/reports/page/page_support.h"
#include "tests/reports/sample_study.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;
using namespace limitgauge::reports::study_report;
using Json = nlohmann::json;

namespace {

std::string csv_of(const SampleStudy& s) {
  std::ostringstream out;
  write_study_csv(s.plan, s.table, s.analysis, out);
  return out.str();
}

std::string json_text(const SampleStudy& s) {
  std::ostringstream out;
  write_study_json(s.plan, s.table, s.analysis, out, s.about);
  return out.str();
}

std::string page_of(const SampleStudy& s) {
  std::ostringstream out;
  write_study_html(s.plan, s.table, s.analysis, out, s.about);
  return out.str();
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// What the script finds under its id.
Json data_of(const std::string& page) {
  const std::string head = "id=\"limitgauge-data\">";
  const std::size_t from = page.find(head) + head.size();
  return Json::parse(page.substr(from, page.find("</script>", from) - from));
}

/// What stands before the script's data: what is read without a script.
std::string words_of(const std::string& page) {
  return page.substr(page.find("<body>"), page.find("<script") - page.find("<body>"));
}

TEST_CASE("study.csv holds a line a case, its figures in all their digits", "[unit]") {
  const SampleStudy sample = sample_study();
  const std::string text = csv_of(sample);
  CHECK(occurrences(text, "\r\n") == 61);
  CHECK(
      text.starts_with("case,status,reason,\"stage.finish.step\",\"stage.finish.tolerance\","
                       "\"stage.rough.allowance\",\"machining_time_s\",\"finish.uncut_mm.high\","));
  CHECK(contains(text, ",key,reused,attempts,seconds\r\n0,pass,\"\",0.2,0.002,0.2,"));
  // A case without figures has empty cells for them, and its reason.
  CHECK(contains(
      text, "\r\n20,lost,\"the process was ended by signal 9 (killed)\",0.3,0.01,0.5,,,,,,,,"));
}

TEST_CASE("study.csv: texts that a spreadsheet would reckon out are harmless, numbers stay numbers",
          "[unit]") {
  const std::string text = csv_of(hostile_study());
  CHECK(contains(text, ",\"'@key"));
  CHECK(contains(text, ",\"'-key\xEF\xBF\xBD\","));
  CHECK(contains(text, ",\"'+machining"));
  // In the quotes of TOML it is text already.
  CHECK(contains(text, ",\"\"\"=cmd|'"));
  CHECK(contains(text, ",-0.5,\"'=1+1\","));
  CHECK(contains(text, "\"'\t-1+"));
  for (const char* raw : {",\"=", ",\"@", ",\"-", ",\"+"}) CHECK_FALSE(contains(text, raw));
}

TEST_CASE("study.json holds what the table and the analysis hold", "[unit]") {
  const SampleStudy sample = sample_study();
  const Json whole = Json::parse(json_text(sample));
  CHECK(whole["schema"] == "limitgauge.study/1");
  CHECK(whole["plan"]["method"] == "grid");
  REQUIRE(whole["cases"].size() == 60);
  for (std::size_t i = 0; i < 60; ++i) {
    const study::Row& row = sample.table.rows[i];
    const Json& one = whole["cases"][i];
    CHECK(one["case"] == i);
    CHECK(one["status"] == study::name(row.status));
    CHECK(one["settings"][1]["number"] == *row.asked.settings[1].number);
    for (std::size_t k = 0; k < sample.table.figures.size(); ++k) {
      if (row.figures[k])
        CHECK(one["figures"][k] == *row.figures[k]);
      else
        CHECK(one["figures"][k].is_null());
    }
  }
  CHECK(whole["cases"][42]["result"] == "cases/0000/0042/result.json");
  CHECK_FALSE(whole["cases"][20].contains("result"));
  const std::size_t counted =
      whole["counts"]["pass"].get<std::size_t>() + whole["counts"]["fail"].get<std::size_t>() + 3;
  CHECK(counted == 60);
  const std::size_t taken = sample.analysis.recommendation.row.value();
  CHECK(whole["analysis"]["recommendation"]["case"] == taken);
  CHECK(whole["analysis"]["fronts"].size() == sample.analysis.fronts.size());
  CHECK(whole["analysis"]["responses"].size() == sample.analysis.responses.size());
  CHECK(whole["own"]["case"] == 19);
  CHECK(whole["run"]["cases"][4]["reused"] == true);
}

TEST_CASE("study.json: two runs of a study differ under \"run\" alone", "[unit]") {
  SampleStudy first = sample_study(), second = sample_study();
  second.about.created = "2026-11-23T00:00:00Z";
  second.about.engine = "slurm";
  second.about.seconds = 3;
  for (study::Row& row : second.table.rows) {
    row.reused = !row.reused;
    row.attempts += 1;
    row.seconds *= 2;
  }
  const std::string a = json_text(first), b = json_text(second);
  CHECK(a != b);
  REQUIRE(a.find("\n  \"run\": {") != std::string::npos);
  CHECK(a.substr(0, a.find("\n  \"run\": {")) == b.substr(0, b.find("\n  \"run\": {")));
  CHECK(json_text(first) == a);
}

TEST_CASE("a figure that is not finite is named, not written", "[unit]") {
  SampleStudy sample = sample_study();
  sample.table.rows[3].figures[1] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(json_text(sample), ContainsSubstring("finish.uncut_mm.high"));
  CHECK_THROWS_WITH(csv_of(sample), ContainsSubstring("finish.uncut_mm.high"));
  CHECK_THROWS_WITH(page_of(sample), ContainsSubstring("finish.uncut_mm.high"));
}

TEST_CASE("cases lie in folders of a hundred", "[unit]") {
  CHECK(result_path(0) == "cases/0000/0000/result.json");
  CHECK(result_path(99) == "cases/0000/0099/result.json");
  CHECK(result_path(100) == "cases/0100/0100/result.json");
  CHECK(result_path(12345) == "cases/12300/12345/result.json");
}

TEST_CASE("study.html says without a script what to take, why, and what became of every case",
          "[unit]") {
  const SampleStudy sample = sample_study();
  const std::string words = words_of(page_of(sample));
  const study::Row& taken = sample.table.rows.at(sample.analysis.recommendation.row.value());
  const std::string number = std::to_string(taken.asked.index);
  CHECK(contains(words, "Take case <a href=\"" + result_path(taken.asked.index) + "\">" + number));
  CHECK(contains(words, "--set &#39;stage.finish.step=" + taken.asked.settings[0].toml + "&#39;"));
  CHECK(contains(words, "<small>job: <code>0.3</code></small>"));
  CHECK(contains(words, "the job’s own"));
  CHECK(contains(words, "ended by signal 9 (killed)"));
  CHECK(contains(words, "Grid: every combination"));
  for (const study::Status status : kStatuses) CHECK(contains(words, badge(status)));
  // All of 60 cases are listed, and no more than 200 ever are.
  const std::string table = words.substr(words.find("<section id=\"cases\""));
  CHECK(occurrences(table.substr(0, table.find("</section>")), "<tr role=\"row\"") == 61);
}

TEST_CASE("study.html: what the script reads is what the table holds", "[unit]") {
  const SampleStudy sample = sample_study();
  const Json data = data_of(page_of(sample));
  CHECK(data["format"] == "limitgauge.study-page/1");
  REQUIRE(data["cases"].size() == 60);
  for (std::size_t i = 0; i < 60; ++i) {
    const study::Row& row = sample.table.rows[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const Json& key = data["keys"][k];
      CHECK(key["settings"][key["of"][i].get<std::size_t>()][1] == *row.asked.settings[k].number);
    }
    const Json& uncut = data["figures"][1]["values"][i];
    REQUIRE(uncut.is_null() == !row.figures[1]);
    // Seven digits of each figure are drawn.
    if (row.figures[1]) CHECK(uncut.get<double>() == Approx(*row.figures[1]).epsilon(1e-6));
  }
  CHECK(data["own"] == 19);
}

TEST_CASE("study.html: text of others stays text", "[unit]") {
  const std::string page = page_of(hostile_study());
  CHECK_FALSE(contains(words_of(page), "<img src=x"));
  CHECK_FALSE(contains(page, "</script><img"));
  CHECK(occurrences(page, "</script>") == 2);
  CHECK(contains(words_of(page), "&lt;/script&gt;&lt;img src=x onerror=window.hostile=1&gt;"));
  CHECK(contains(page, "script-src 'sha256-" + std::string(embedded::study_js_sha256()) + "'"));
  CHECK(data_of(page)["cases"].size() == 3);
}

TEST_CASE("study.html: nothing to recommend, one case, no case at all", "[unit]") {
  const std::string failed = words_of(page_of(failed_study()));
  CHECK(contains(failed, "No setting to recommend"));
  CHECK_FALSE(contains(failed, "Take case"));
  CHECK(contains(words_of(page_of(single_study())), "All 1 case."));
  SampleStudy none = single_study();
  none.table.rows.clear();
  none.analysis = {};
  none.analysis.recommendation.reason = "There is no case.";
  CHECK(contains(words_of(page_of(none)), "There is no case."));
  CHECK(Json::parse(json_text(none))["cases"].empty());
}

TEST_CASE("study.html of 10,008 cases: listed are the best 200", "[unit]") {
  const SampleStudy sample = sample_study_of(834);
  const std::string page = page_of(sample);
  const std::string words = words_of(page);
  CHECK(contains(words, "The first 200 of 10\u202F008 cases"));
  const std::string table = words.substr(words.find("<section id=\"cases\""));
  CHECK(occurrences(table.substr(0, table.find("</section>")), "<tr role=\"row\"") == 201);
  CHECK(data_of(page)["cases"].size() == 10'008);
  // Without the script. Measured: 1.2 MB.
  CHECK(page.size() - embedded::study_js().size() < 3'000'000);
}

}  // namespace

TEST_CASE("the command that is ready to run names the job from where the study was started",
          "[unit][study]") {
  SampleStudy study = sample_study();
  study.about.job_path = "parts/wing's/job.toml";
  CHECK(page_of(study).find("limitgauge run &#39;parts/wing&#39;\\&#39;&#39;s/job.toml&#39; \\") !=
        std::string::npos);
}
