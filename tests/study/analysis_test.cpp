#include "study/search/analysis.h"

#include <algorithm>
#include <cmath>

#include "study/plan/random_numbers.h"
#include "study/search/least_squares.h"
#include "study/search/phrases.h"
#include "study/store/table.h"
#include "tests/study/study_tables.h"
#include "tests/support/catch.h"

namespace limitgauge::study {
namespace {

using Points = std::vector<std::vector<double>>;
using Rows = std::vector<std::size_t>;

double number(const std::vector<Setting>& settings, std::size_t i) {
  return *settings[i].number;
}

bool dominates(const std::vector<double>& a, const std::vector<double>& b) {
  return a != b &&
         std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return x <= y; });
}

/// By definition, each against each.
Rows front_by_definition(const Points& points) {
  Rows front;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::none_of(points.begin(), points.end(),
                     [&](const auto& other) { return dominates(other, points[i]); }))
      front.push_back(i);
  std::sort(front.begin(), front.end(), [&](std::size_t a, std::size_t b) {
    return points[a] != points[b] ? points[a] < points[b] : a < b;
  });
  return front;
}

const Response& response_to(const Analysis& analysis, std::size_t key, std::size_t figure) {
  const auto found =
      std::find_if(analysis.responses.begin(), analysis.responses.end(),
                   [&](const Response& r) { return r.key == key && r.figure == figure; });
  REQUIRE(found != analysis.responses.end());
  return *found;
}

/// Uncut is a times the first and b times the second setting; cost is their inverse.
Job linear(double a, double b) {
  return [=](const std::vector<Setting>& s) {
    const double uncut = a * number(s, 0) + b * number(s, 1);
    return Answer{100 / number(s, 0), uncut - 0.5, uncut};
  };
}

}  // namespace

TEST_CASE("fronts that are known", "[unit][pareto]") {
  CHECK(pareto_front({}).empty());
  CHECK(pareto_front({{3}, {1}, {2}, {1}}) == Rows{1, 3});
  CHECK(pareto_front({{1, 3}, {2, 2}, {3, 1}, {3, 3}, {2, 2}, {1, 4}}) == Rows{0, 1, 4, 2});
  CHECK(pareto_front({{1, 1}, {1, 1}}) == Rows{0, 1});
  CHECK(pareto_front({{1, 2, 3}, {3, 2, 1}, {2, 2, 2}, {3, 3, 3}, {1, 2, 4}}) == Rows{0, 2, 1});
}

TEST_CASE("fronts are what their definition says", "[property][pareto]") {
  RandomNumbers random(3);
  for (int round = 0; round < 400; ++round) {
    const std::size_t dimension = 1 + random.below(4), count = random.below(60);
    const bool coarse = round % 2 == 0;  // with ties
    Points points(count, std::vector<double>(dimension));
    for (auto& point : points)
      for (double& x : point) x = coarse ? static_cast<double>(random.below(5)) : random.share();
    CHECK(pareto_front(points) == front_by_definition(points));
  }
}

TEST_CASE("a front of ten thousand points that are all on it", "[unit][pareto]") {
  constexpr std::size_t kCount = 10000;
  RandomNumbers random(4);
  Points points;
  for (std::size_t i = 0; i < kCount; ++i) {
    const double a = random.share(), b = random.share() * (1 - a);
    points.push_back({a, b, 1 - a - b});
  }
  CHECK(pareto_front(points).size() == kCount);
}

TEST_CASE("least squares by closed forms", "[unit][sensitivity]") {
  CHECK(slope({{1, 2, 3}, {5, 7, 9}}) == 2);
  CHECK_FALSE(slope({{2, 2}, {1, 3}}));
  CHECK(*elasticity({{1, 2, 4}, {3, 12, 48}}) == Approx(2));
  CHECK_FALSE(elasticity({{1, 2}, {3, 12}}));
  CHECK_FALSE(elasticity({{0, 1, 2}, {1, 2, 3}}));
  CHECK_FALSE(elasticity({{1, 2, 3}, {0, 2, 3}}));
  const std::optional<Parabola> fit = Parabola::through({{0, 1, 2, 3, 5}, {1, 2, 7, 16, 46}});
  REQUIRE(fit);  // 2 x² - x + 1
  for (const double x : {0.5, 4.0}) CHECK(fit->at(x) == Approx(2 * x * x - x + 1));
  CHECK(Parabola::through({{1, 1, 2}, {1, 3, 4}})->at(1) == Approx(2));
  CHECK_FALSE(Parabola::through({{1, 2, 3}, {1, 2, 3}}));
  CHECK_FALSE(Parabola::through({{1, 1, 1, 1}, {1, 2, 3, 4}}));
}

TEST_CASE("responses of a grid go through the job's own settings", "[unit][sensitivity]") {
  Plan plan = plan_of(Method::grid, {listed("a", {1, 2, 4}), listed("b", {1, 3})});
  plan.variables[0].base = number_setting(2);
  plan.variables[1].base = number_setting(3);
  const Analysis analysis = analyse(plan, table_of(plan, linear(0.1, 0.02)));
  CHECK(analysis.own == 3);
  CHECK(analysis.reference == 3);
  const Response& step = response_to(analysis, 0, 2);
  REQUIRE(step.points.size() == 3);
  CHECK(step.points[0].row == 1);
  CHECK(step.points[0].setting == 1);
  CHECK(step.points[0].value == Approx(0.16));
  CHECK(step.change == Approx(0.3));
  const Response& time = response_to(analysis, 0, 0);
  CHECK(time.has_elasticity);
  CHECK(time.elasticity == Approx(-1));
  CHECK_FALSE(response_to(analysis, 1, 0).has_elasticity);
  // Variances of the settings: of 1, 2, 4 14/9; of 1, 3 1. Both effects are linear and do not mix.
  const double a = 0.01 * 14 / 9, b = 0.0004;
  CHECK(*step.variance_share == Approx(a / (a + b)));
  CHECK(*response_to(analysis, 1, 2).variance_share == Approx(b / (a + b)));
  REQUIRE(analysis.rankings.size() == 3);
  const Ranking& of_uncut = analysis.rankings[1];
  CHECK(of_uncut.figure == 2);
  REQUIRE(of_uncut.responses.size() == 2);
  CHECK(analysis.responses[of_uncut.responses[0]].key == 0);
}

TEST_CASE("a grid without the job's settings goes through what is nearest", "[unit][sensitivity]") {
  Plan plan = plan_of(Method::grid, {listed("a", {1, 2, 4}), words("b", {"x", "y", "z"})});
  plan.variables[0].base = number_setting(3.5);
  const Table table = table_of(plan, [](const std::vector<Setting>& s) {
    return Answer{number(s, 0), -1, s[1].toml == "\"z\"" ? 5.0 : 1.0};
  });
  const Analysis analysis = analyse(plan, table);
  CHECK_FALSE(analysis.own);
  CHECK(analysis.reference == 7);  // a = 4, b = y, the middle one
  const Response& word = response_to(analysis, 1, 2);
  REQUIRE(word.points.size() == 3);
  CHECK(word.points[2].setting == 2);
  CHECK(word.points[2].value == 5);
  CHECK(*word.variance_share == Approx(1));
  CHECK_FALSE(word.has_elasticity);
}

TEST_CASE("a figure that never changes has no variance to share", "[unit][sensitivity]") {
  // Their mean, summed up and divided, is not the number itself.
  Plan plan = plan_of(Method::grid, {listed("a", {1, 2, 3, 4, 5, 6, 7}), listed("b", {1, 3, 5})});
  const Job constant = [](const std::vector<Setting>& s) {
    return Answer{100 / number(s, 0), -0.5, 0.000950011};
  };
  const Analysis analysis = analyse(plan, table_of(plan, constant));
  for (const std::size_t key : {0, 1}) {
    CHECK(response_to(analysis, key, 2).change == 0);
    CHECK_FALSE(response_to(analysis, key, 2).variance_share);
  }
}

TEST_CASE("one at a time: a response for each key through the base", "[unit][sensitivity]") {
  Plan plan = plan_of(Method::one_at_a_time, {listed("a", {1, 4}), listed("b", {1, 2, 3})});
  plan.variables[0].base = number_setting(2);
  plan.variables[1].base = number_setting(2);
  const Analysis analysis = analyse(plan, table_of(plan, linear(0.1, 0.02)));
  CHECK(analysis.own == 0);
  CHECK(response_to(analysis, 0, 2).points.size() == 3);
  CHECK(response_to(analysis, 0, 2).points[1].row == 0);
  CHECK(response_to(analysis, 1, 2).change == Approx(0.04));
  CHECK_FALSE(response_to(analysis, 0, 2).variance_share);
}

TEST_CASE("main effects of samples are those of the model that made them",
          "[property][sensitivity]") {
  for (const Method method : {Method::random, Method::latin_hypercube}) {
    const Plan plan = plan_of(
        method,
        {ranged("a", {1, 3}), ranged("b", {1, 3}), ranged("c", {1, 3}), words("d", {"x", "y"})},
        4000, 9);
    const Table table = table_of(plan, [](const std::vector<Setting>& s) {
      const double word = s[3].toml == "\"x\"" ? 0 : 1;
      return Answer{100 / number(s, 0), -1, 0.4 * number(s, 0) + 0.2 * number(s, 1) + 0.3 * word};
    });
    const Analysis analysis = analyse(plan, table);
    // An even distribution of width w has the variance w²/12, two values alike often a quarter.
    const double a = 0.16 / 3, b = 0.04 / 3, d = 0.09 / 4, all = a + b + d;
    const double expected[] = {a / all, b / all, 0, d / all};
    for (std::size_t key = 0; key < 4; ++key) {
      const Response& response = response_to(analysis, key, 2);
      CHECK(response.points.empty());
      CHECK(std::abs(*response.variance_share - expected[key]) < 0.03);
    }
    CHECK(response_to(analysis, 0, 2).change == Approx(0.8).epsilon(0.1));
    CHECK(response_to(analysis, 3, 2).change == Approx(0.3).epsilon(0.1));
    CHECK(response_to(analysis, 3, 2).fit.size() == 2);
    CHECK(response_to(analysis, 0, 0).elasticity == Approx(-1).epsilon(1e-3));
    CHECK(analysis.responses[analysis.rankings[1].responses[0]].key == 0);
  }
}

TEST_CASE("the cheapest case that passes is recommended, with its reasons", "[unit][recommend]") {
  Plan plan = plan_of(Method::grid, {listed("a", {1, 2, 3, 4, 5})});
  plan.variables[0].base = number_setting(2);
  Table table = table_of(plan, [](const std::vector<Setting>& s) {
    return Answer{1000 / number(s, 0), number(s, 0) - 4.5, 0.01 * number(s, 0)};
  });
  Analysis analysis = analyse(plan, table);
  CHECK(analysis.recommendation.row == 3);
  CHECK(analysis.recommendation.reason ==
        "Case 3 is the cheapest of the 4 cases that pass every gate, of 5 in all: machining time "
        "250 s (finish: uncut, certified 40 µm). That is 50 % below the job's own settings (case "
        "1, 500 s). The next cheaper one, case 4 (200 s), fails: finish: uncut beyond its limit "
        "(finish: uncut, certified 50 µm).");
  REQUIRE(analysis.fronts.size() == 1);
  CHECK(analysis.fronts[0].rows == Rows{4, 3, 2, 1, 0});
  CHECK(analysis.bought_for_nothing.empty());

  // Case 0 is as bad as case 3 now, and dearer; case 4 has no result; ties go to the first.
  table.rows[0].figures[2] = table.rows[3].figures[2];
  table.rows[2].figures = table.rows[3].figures;
  table.rows[4] = Row{table.rows[4].asked, "", Status::error, "no tool", {}, false, 1, 0};
  analysis = analyse(plan, table);
  CHECK(analysis.recommendation.row == 2);
  REQUIRE(analysis.bought_for_nothing.size() == 1);
  CHECK(analysis.bought_for_nothing[0].row == 0);
  CHECK(analysis.bought_for_nothing[0].by == 2);
  CHECK(analysis.bought_for_nothing[0].dearer == 750);
  CHECK(analysis.recommendation.reason.find(
            "No case that went through all stages is cheaper. 1 passing case costs more than "
            "another one that is at least as accurate. 1 case ended with an error.") !=
        std::string::npos);
}

TEST_CASE("where nothing passes, what comes nearest is named", "[unit][recommend]") {
  const Plan plan = plan_of(Method::grid, {listed("a", {1, 2, 3})});
  Table table = table_of(plan, [](const std::vector<Setting>& s) {
    return Answer{1000 / number(s, 0), 0.12 * number(s, 0), 0.01};
  });
  table.rows[1].status = Status::indeterminate;
  table.rows[2].status = Status::lost;
  const Analysis analysis = analyse(plan, table);
  CHECK_FALSE(analysis.recommendation.row);
  CHECK(analysis.recommendation.reason ==
        "None of 3 cases passes every gate: 1 fails, 1 cannot be decided. Nearest comes case 0, 12 "
        "% over a limit: finish: uncut beyond its limit. 1 case did not come back.");
  CHECK_FALSE(analyse(plan, Table{"", "", {"a"}, made_up_figures(), {}}).recommendation.row);
}

TEST_CASE("bought for nothing is what its definition says", "[property][recommend]") {
  RandomNumbers random(12);
  for (int round = 0; round < 100; ++round) {
    Plan plan =
        plan_of(Method::random, {ranged("a", {0, 1})}, 40, static_cast<std::uint64_t>(round));
    plan.accuracy = {"finish.uncut_mm.high", "gate_excess"};
    Table table = table_of(plan, [&](const std::vector<Setting>&) {
      return Answer{static_cast<double>(random.below(8)), static_cast<double>(random.below(6)) - 4,
                    static_cast<double>(random.below(6))};
    });
    const Analysis analysis = analyse(plan, table);
    std::size_t found = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      const auto& mine = table.rows[i].figures;
      std::optional<double> least;
      for (const Row& other : table.rows)
        if (other.status == Status::pass && *other.figures[0] < *mine[0] &&
            *other.figures[1] <= *mine[1] && *other.figures[2] <= *mine[2])
          least = std::min(least.value_or(1e9), *other.figures[0]);
      if (table.rows[i].status != Status::pass || !least) continue;
      REQUIRE(found < analysis.bought_for_nothing.size());
      const BoughtForNothing& told = analysis.bought_for_nothing[found++];
      CHECK(told.row == i);
      CHECK(told.dearer == *mine[0] - *least);
    }
    CHECK(found == analysis.bought_for_nothing.size());
  }
}

TEST_CASE("a study of ten thousand cases is analysed at once", "[unit][analysis]") {
  const Plan plan = plan_of(Method::latin_hypercube,
                            {ranged("a", {1, 2}), ranged("b", {1, 2}), ranged("c", {1, 2})}, 10000);
  const Table table = table_of(plan, linear(0.1, 0.02));
  const Analysis analysis = analyse(plan, table);
  CHECK(analysis.responses.size() == 9);
  CHECK(analysis.fronts.size() == 1);
}

TEST_CASE("quantities in sentences", "[unit][recommend]") {
  CHECK(quantity(1203.6, "s") == "1204 s");
  CHECK(quantity(98325, "s") == "98325 s");
  CHECK(quantity(12.3456, "s") == "12.35 s");
  CHECK(quantity(0.041234, "mm") == "41.23 µm");
  CHECK(quantity(0, "mm") == "0 mm");
  CHECK(quantity(0.25, "mm") == "0.25 mm");
  CHECK(quantity(3, "") == "3");
  CHECK(percent(0.123) == "12 %");
  CHECK(percent(0.0456) == "4.6 %");
  CHECK(percent(0.0001) == "less than 0.1 %");
  CHECK(percent(0) == "0 %");
}

}  // namespace limitgauge::study
