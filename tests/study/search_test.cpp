#include "study/search/search.h"

#include <cmath>
#include <set>

#include "tests/study/study_tables.h"
#include "tests/support/catch.h"

namespace limitgauge::study {
namespace {

using SearchEnds = SearchResult::Ending;

double number_at(const std::vector<Setting>& settings, std::size_t i) {
  return *settings[i].number;
}

/// A search on a made-up job, with what holds of every one checked.
SearchResult searched(const Plan& plan, const Job& job, const std::atomic<bool>* stop = nullptr) {
  std::set<std::string> seen;
  const Evaluate evaluate = [&](std::span<const Case> cases) {
    std::vector<Row> rows;
    for (const Case& one : cases) {
      std::string key;
      for (const Setting& setting : one.settings) key += setting.toml + " ";
      CHECK(seen.insert(key).second);
      rows.push_back(row_of(one, job(one.settings)));
    }
    return rows;
  };
  const std::vector<Figure> figures = made_up_figures();
  SearchResult result = search(plan, figures, evaluate, stop);
  CHECK(result.rows.size() <= plan.search.most_cases);
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    CHECK(result.rows[i].asked.index == i);
    if (result.rows[i].status != Status::pass) continue;
    REQUIRE(result.best);
    CHECK(*result.rows[*result.best].figures[0] <= *result.rows[i].figures[0]);
  }
  if (result.best) CHECK(result.rows[*result.best].status == Status::pass);
  return result;
}

double best_of(const SearchResult& result, std::size_t variable) {
  REQUIRE(result.best);
  return number_at(result.rows[*result.best].asked.settings, variable);
}

/// Passes up to `border` of a step that costs less the larger it is.
Job up_to(double border) {
  return [=](const std::vector<Setting>& s) {
    return Answer{100 / number_at(s, 0), number_at(s, 0) / border - 1, number_at(s, 0)};
  };
}

}  // namespace

TEST_CASE("one range: the border is found to the accuracy", "[property][search]") {
  for (const std::size_t batch : {1u, 2u, 4u, 7u}) {
    for (const bool logarithmic : {false, true}) {
      for (double border = 0.11; border < 1; border += 0.0737) {
        Plan plan = plan_of(Method::search, {ranged("step", {0.1, 1, 0, logarithmic})});
        plan.search.batch = batch;
        const SearchResult result = searched(plan, up_to(border));
        CAPTURE(batch, border, result.ending);
        CHECK(result.how == SearchEnds::converged);
        CHECK_FALSE(result.contradicted);
        const Range& range = *plan.variables[0].range;
        const double left = share_of(range, border) - share_of(range, best_of(result, 0));
        CHECK(left >= 0);
        CHECK(left <= plan.search.accuracy * (1 + 1e-9));
        CHECK(result.rows.size() <= 22);
      }
    }
  }
}

TEST_CASE("the other way round: what is dear at the small end", "[unit][search]") {
  const Plan plan = plan_of(Method::search, {ranged("quality", {1, 9})});
  const SearchResult result = searched(plan, [](const std::vector<Setting>& s) {
    return Answer{number_at(s, 0), 5 - number_at(s, 0), 1};
  });
  CHECK(best_of(result, 0) >= 5);
  CHECK(best_of(result, 0) <= 5.08);
}

TEST_CASE("steps of one range and listed numbers are found exactly", "[property][search]") {
  for (std::size_t border = 1; border <= 50; ++border) {
    const Plan steps = plan_of(Method::search, {ranged("n", {1, 50, 50})});
    const Job job = up_to(static_cast<double>(border));
    CHECK(best_of(searched(steps, job), 0) == static_cast<double>(border));
  }
  const Plan listed_ones = plan_of(Method::search, {listed("n", {8, 1, 3, 20})});
  CHECK(best_of(searched(listed_ones, up_to(9)), 0) == 8);
}

TEST_CASE("ends of a range, and nothing that passes", "[unit][search]") {
  const Plan plan = plan_of(Method::search, {ranged("step", {0.1, 1})});
  const SearchResult all = searched(plan, up_to(2));
  CHECK(best_of(all, 0) == 1);
  CHECK(all.rows.size() == 4);
  CHECK(all.ending ==
        "The search converged after 4 cases of at most 40: the cheap end of the range passes.");

  const SearchResult none = searched(plan, up_to(0.01));
  CHECK(none.how == SearchEnds::nothing_passes);
  CHECK_FALSE(none.best);
  CHECK(none.ending.find("Nothing that was run passes every gate.") != std::string::npos);

  // Passes between the first settings only.
  const SearchResult hidden = searched(plan, [](const std::vector<Setting>& s) {
    return Answer{100 / number_at(s, 0), std::abs(number_at(s, 0) - 0.52) * 50 - 1, 1};
  });
  CHECK(best_of(hidden, 0) > 0.49);
}

TEST_CASE("what is not monotone is said", "[unit][search]") {
  const Plan plan = plan_of(Method::search, {ranged("step", {0.1, 1})});
  const SearchResult gap = searched(plan, [](const std::vector<Setting>& s) {
    const double x = number_at(s, 0);
    return Answer{100 / x, x > 0.3 && x < 0.5 ? 1.0 : x - 0.8, 1};
  });
  CHECK(gap.contradicted);
  CHECK(gap.ending.find("case 1 (0.4) does not pass, but case 2 (0.7) beyond it does") !=
        std::string::npos);
  CHECK(best_of(gap, 0) == Approx(0.8).margin(0.01));

  const SearchResult dear = searched(plan, [](const std::vector<Setting>& s) {
    const double x = number_at(s, 0);
    return Answer{x > 0.6 ? 300 / x : 100 / x, x - 2, 1};
  });
  CHECK(dear.contradicted);
  CHECK(dear.ending.find("against the trend") != std::string::npos);
}

TEST_CASE("no more cases than allowed, and the best of those", "[unit][search]") {
  for (std::size_t most = 2; most < 12; ++most) {
    Plan plan = plan_of(Method::search, {ranged("step", {0.1, 1})});
    plan.search.most_cases = most;
    plan.search.accuracy = 1e-4;
    plan.search.batch = 2;
    const SearchResult result = searched(plan, up_to(0.654321));
    CHECK(result.how == SearchEnds::budget);
    CHECK(result.rows.size() == most);
    CHECK(best_of(result, 0) <= 0.654321);
    CHECK(result.ending.find("no more cases may be run") != std::string::npos);
  }
}

TEST_CASE("a search is stopped between cases", "[unit][search]") {
  const Plan plan = plan_of(Method::search, {ranged("step", {0.1, 1}), ranged("b", {0, 1})});
  std::atomic<bool> stop = false;
  int asked = 0;
  const SearchResult result = searched(
      plan,
      [&](const std::vector<Setting>& s) {
        if (++asked == 9) stop = true;
        return up_to(0.5)(s);
      },
      &stop);
  CHECK(result.how == SearchEnds::stopped);
  CHECK(result.rows.size() < 20);
  CHECK(result.ending.find("it was stopped") != std::string::npos);
}

TEST_CASE("what evaluating throws comes through", "[unit][search]") {
  const Plan plan = plan_of(Method::search, {ranged("step", {0.1, 1}), ranged("b", {0, 1})});
  const Evaluate broken = [n = 0](std::span<const Case> cases) mutable {
    if (++n > 3) throw std::logic_error("disk");
    std::vector<Row> rows;
    for (const Case& one : cases) rows.push_back(row_of(one, up_to(0.5)(one.settings)));
    return rows;
  };
  const std::vector<Figure> figures = made_up_figures();
  CHECK_THROWS_WITH(search(plan, figures, broken), "disk");
}

TEST_CASE("two ranges: the best on the border is found", "[unit][search]") {
  // Time falls with step-over and with tolerance; what is left is h = a² + b, limit 0.5: the least
  // time on the border is found by one equation.
  Plan plan = plan_of(Method::search, {ranged("a", {0.1, 1}), ranged("b", {0.01, 0.6})});
  plan.search.most_cases = 120;
  const auto time = [](double a, double b) { return 10 / a + 0.5 / b; };
  double least = 1e9;
  for (double a = 0.1; a < 0.7; a += 1e-4) {
    const double b = std::min(0.6, 0.5 - a * a);
    if (b >= 0.01) least = std::min(least, time(a, b));
  }
  const Job job = [&](const std::vector<Setting>& s) {
    const double a = number_at(s, 0), b = number_at(s, 1);
    return Answer{time(a, b), (a * a + b) / 0.5 - 1, a * a + b};
  };
  const SearchResult result = searched(plan, job);
  INFO(result.ending);
  REQUIRE(result.best);
  CHECK(*result.rows[*result.best].figures[0] < 1.03 * least);
  const SearchResult again = searched(plan, job);
  REQUIRE(again.rows.size() == result.rows.size());
  for (std::size_t i = 0; i < again.rows.size(); ++i)
    CHECK(again.rows[i].asked.settings == result.rows[i].asked.settings);
}

TEST_CASE("text is chosen, too", "[unit][search]") {
  Plan plan = plan_of(Method::search, {ranged("a", {0.1, 1}), words("w", {"slow", "fast", "bad"})});
  plan.search.most_cases = 60;
  const SearchResult result = searched(plan, [](const std::vector<Setting>& s) {
    const double factor = s[1].toml == "\"slow\"" ? 2 : 1;
    const double excess = s[1].toml == "\"bad\"" ? 1 : number_at(s, 0) - 0.6;
    return Answer{factor * 100 / number_at(s, 0), excess, 1};
  });
  INFO(result.ending);
  CHECK(result.how == SearchEnds::converged);
  CHECK(result.rows[*result.best].asked.settings[1].toml == "\"fast\"");
  CHECK(best_of(result, 0) > 0.58);
}

TEST_CASE("few combinations are all run", "[unit][search]") {
  const Plan plan = plan_of(Method::search, {listed("a", {1, 2, 3}), words("w", {"x", "y"})});
  const SearchResult result = searched(plan, [](const std::vector<Setting>& s) {
    return Answer{100 / number_at(s, 0), s[1].toml == "\"x\"" ? number_at(s, 0) - 2.5 : 1, 1};
  });
  CHECK(result.rows.size() == 6);
  CHECK(best_of(result, 0) == 2);
  CHECK(result.ending.find("every combination was run") != std::string::npos);
}

TEST_CASE("a case that ends early, or not at all, misleads nothing", "[unit][search]") {
  // Beyond 0.7 the first stage fails and the time of the second is missing: it looks cheap.
  const Plan plan = plan_of(Method::search, {ranged("step", {0.1, 1})});
  const Evaluate evaluate = [](std::span<const Case> cases) {
    std::vector<Row> rows;
    for (const Case& one : cases) {
      const double x = *one.settings[0].number;
      rows.push_back(row_of(one, up_to(0.5)(one.settings)));
      if (x > 0.7) rows.back().figures = {1.0, 4.0, std::nullopt};
      if (x > 0.9) rows.back() = Row{one, "", Status::error, "no path", {}, false, 1, 0};
    }
    return rows;
  };
  const std::vector<Figure> figures = made_up_figures();
  const SearchResult result = search(plan, figures, evaluate);
  INFO(result.ending);
  CHECK(best_of(result, 0) == Approx(0.5).margin(0.01));
}

}  // namespace limitgauge::study
