#include <algorithm>
#include <cmath>

#include "study/search/analysis.h"
#include "study/search/search.h"
#include "tests/study/study_tables.h"
#include "tests/support/catch.h"

/// What is to be large: a margin as an objective, and the largest setting of a key.
namespace limitgauge::study {
namespace {

using Rows = std::vector<std::size_t>;

Figure margin_figure() {
  return {"finish.margin.low", "finish: tolerance margin, proven", "", true, true};
}

double number_of(const Row& row) {
  return *row.asked.settings.at(0).number;
}

/// Time, excess, uncut and margin of each case.
struct Outcome {
  Answer answer;
  std::optional<double> margin;
};

Table margin_table(const std::vector<Outcome>& outcomes) {
  Table table;
  table.keys = {"step"};
  table.figures = made_up_figures();
  table.figures.push_back(margin_figure());
  for (const Outcome& one : outcomes) {
    const std::size_t index = table.rows.size();
    Row row = row_of({index, {number_setting(static_cast<double>(index))}}, one.answer);
    row.figures.push_back(one.margin);
    table.rows.push_back(std::move(row));
  }
  return table;
}

Plan margin_plan() {
  Plan plan = plan_of(Method::list, {listed("step", {0, 1, 2, 3, 4})});
  plan.accuracy = {"finish.margin.low"};
  return plan;
}

/// The largest setting of one key, with what is proven of each.
Plan largest_plan(const Range& range) {
  Plan plan = plan_of(Method::search, {ranged("tolerances.runout", range)});
  plan.search.largest = "tolerances.runout";
  plan.cost = plan.search.cost = kSearchedSetting;
  return plan;
}

/// Passes up to `pass`, is proven to fail from `fail` on. Of a job that fails the last stage is not
/// run, as where the first one does.
SearchResult largest(const Plan& plan, double pass, double fail) {
  std::vector<Figure> figures = made_up_figures();
  figures.push_back({kSearchedSetting, "tolerances.runout", "", false, true});
  return search(plan, figures, [&](std::span<const Case> cases) {
    std::vector<Row> rows;
    for (const Case& one : cases) {
      const double x = *one.settings[0].number;
      Row row = row_of(one, {100, x - pass, 0.01});
      if (x > pass) row.status = x < fail ? Status::indeterminate : Status::fail;
      if (x > pass) row.figures[0] = row.figures[2] = std::nullopt;
      row.figures.push_back(x);
      rows.push_back(std::move(row));
    }
    return rows;
  });
}

}  // namespace

TEST_CASE("a front of time against margin", "[unit][pareto]") {
  // 1 takes longer than 2 for a smaller margin; 3 has no margin at all.
  const Table table = margin_table({{{100, -1, 1}, 3.0},
                                    {{90, -1, 1}, 1.5},
                                    {{80, -1, 1}, 2.0},
                                    {{60, -1, 1}, std::nullopt},
                                    {{70, -1, 1}, 1.0}});
  const Analysis analysis = analyse(margin_plan(), table);
  REQUIRE(analysis.fronts.size() == 1);
  CHECK(analysis.fronts[0].objectives ==
        std::vector<std::string>{"machining_time_s", "finish.margin.low"});
  CHECK(analysis.fronts[0].rows == Rows{4, 2, 0});
  REQUIRE(analysis.bought_for_nothing.size() == 1);
  CHECK(analysis.bought_for_nothing[0].row == 1);
  CHECK(analysis.bought_for_nothing[0].by == 2);
  CHECK(analysis.bought_for_nothing[0].dearer == 10);
}

TEST_CASE("a margin as what is paid with: the largest is recommended", "[unit][pareto]") {
  Plan plan = margin_plan();
  plan.cost = "finish.margin.low";
  plan.accuracy = {"machining_time_s"};
  const Table table = margin_table({{{100, -1, 1}, 3.0}, {{90, 1, 1}, 5.0}, {{80, -1, 1}, 2.0}});
  const Analysis analysis = analyse(plan, table);
  REQUIRE(analysis.recommendation.row == 0u);
  const std::string& reason = analysis.recommendation.reason;
  CHECK(reason.find("Case 0 is the best of the 2 cases") != std::string::npos);
  CHECK(reason.find("The next better one, case 1 (5), fails") != std::string::npos);
  CHECK(analysis.fronts[0].rows == Rows{1, 2});
}

TEST_CASE("a search for the largest margin", "[unit][search]") {
  Plan plan = plan_of(Method::search, {ranged("step", {0, 10})});
  plan.search.cost = "finish.margin.low";
  std::vector<Figure> figures = made_up_figures();
  figures.push_back(margin_figure());
  const SearchResult result = search(plan, figures, [](std::span<const Case> cases) {
    std::vector<Row> rows;
    for (const Case& one : cases) {
      const double x = *one.settings[0].number;
      Row row = row_of(one, {100, x - 6.2, x});
      row.figures.push_back(1 + x);
      rows.push_back(std::move(row));
    }
    return rows;
  });
  INFO(result.ending);
  REQUIRE(result.best);
  CHECK_FALSE(result.contradicted);
  CHECK(number_of(result.rows[*result.best]) == Approx(6.15).margin(0.051));
}

TEST_CASE("a figure over tolerances that is missing does not make a case half a case",
          "[unit][search]") {
  Plan plan = plan_of(Method::search, {ranged("step", {0.1, 1})});
  std::vector<Figure> figures = made_up_figures();
  figures.push_back(margin_figure());
  const SearchResult result = search(plan, figures, [](std::span<const Case> cases) {
    std::vector<Row> rows;
    for (const Case& one : cases) {
      const double x = *one.settings[0].number;
      Row row = row_of(one, {100 / x, x - 0.5, x});
      row.figures.push_back(std::nullopt);
      rows.push_back(std::move(row));
    }
    return rows;
  });
  INFO(result.ending);
  REQUIRE(result.best);
  CHECK(number_of(result.rows[*result.best]) == Approx(0.495).margin(0.006));
}

TEST_CASE("the largest setting, and the smallest that is proven to fail", "[property][search]") {
  for (const bool logarithmic : {false, true}) {
    for (double pass = 0.0021; pass < 0.045; pass += 0.0049) {
      for (const double undecided : {0.0, 0.0031}) {
        const Plan plan = largest_plan({0.001, 0.05, 0, logarithmic});
        const SearchResult result = largest(plan, pass, pass + undecided);
        CAPTURE(logarithmic, pass, undecided, result.ending);
        CHECK(result.how == SearchEnding::converged);
        CHECK_FALSE(result.contradicted);
        REQUIRE(result.best);
        const Range& range = *plan.variables[0].range;
        const double best = number_of(result.rows[*result.best]);
        CHECK(best <= pass);
        CHECK(share_of(range, pass) - share_of(range, best) <= plan.search.accuracy * (1 + 1e-9));
        double fail = 1;
        for (const Row& row : result.rows)
          if (row.status == Status::fail) fail = std::min(fail, number_of(row));
        if (pass + undecided < range.high)
          CHECK(share_of(range, fail) - share_of(range, pass + undecided) <=
                plan.search.accuracy * (1 + 1e-9));
        CHECK(result.ending.find("smallest that is proven to fail: case") != std::string::npos);
      }
    }
  }
}

TEST_CASE("the largest setting at the ends of its range", "[unit][search]") {
  const SearchResult all = largest(largest_plan({0.001, 0.05}), 1, 2);
  REQUIRE(all.best);
  CHECK(number_of(all.rows[*all.best]) == 0.05);
  CHECK(all.ending.find("the large end of the range passes. Largest that is proven to pass: case 3 "
                        "(0.05); smallest that is proven to fail: none.") != std::string::npos);
  const SearchResult none = largest(largest_plan({0.001, 0.05}), 0, 0.02);
  CHECK_FALSE(none.best);
  CHECK(none.how == SearchEnding::nothing_passes);
  CHECK(none.ending.find("Largest that is proven to pass: none; smallest that is "
                         "proven to fail: case") != std::string::npos);
  Plan two = largest_plan({0.001, 0.05});
  two.variables.push_back(ranged("other", {0, 1}));
  CHECK_THROWS_AS(largest(two, 0.01, 0.02), std::invalid_argument);
}

}  // namespace limitgauge::study
