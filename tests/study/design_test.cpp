#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "model/text/number_text.h"
#include "study/plan/design.h"
#include "study/plan/plan.h"
#include "study/plan/random_numbers.h"
#include "study/plan/sampling.h"
#include "study/plan/settings.h"
#include "tests/study/study_tables.h"
#include "tests/support/catch.h"

namespace limitgauge::study {
namespace {

std::vector<std::string> texts_of(const Case& one) {
  std::vector<std::string> texts;
  for (const Setting& setting : one.settings) texts.push_back(setting.toml);
  return texts;
}

/// What holds of every design.
void check_design(const Plan& plan, const std::vector<Case>& cases) {
  REQUIRE(cases.size() == case_count(plan));
  std::set<std::vector<std::string>> seen;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    REQUIRE(cases[i].index == i);
    REQUIRE(cases[i].settings.size() == plan.variables.size());
    REQUIRE(seen.insert(texts_of(cases[i])).second);
    for (std::size_t v = 0; v < plan.variables.size(); ++v) {
      const Setting& setting = cases[i].settings[v];
      const std::optional<Range>& range = plan.variables[v].range;
      if (setting.number) REQUIRE(model::parse_number(setting.toml) == setting.number);
      if (range) REQUIRE((*setting.number >= range->low && *setting.number <= range->high));
    }
  }
}

}  // namespace

TEST_CASE("a grid goes through all settings, the last variable fastest", "[unit][design]") {
  const Plan plan =
      plan_of(Method::grid, {listed("a", {1, 2}), words("b", {"x", "y"}), listed("c", {3, 4, 5})});
  const std::vector<Case> cases = design(plan);
  check_design(plan, cases);
  REQUIRE(cases.size() == 12);
  CHECK(texts_of(cases[0]) == std::vector<std::string>{"1", "\"x\"", "3"});
  CHECK(texts_of(cases[1]) == std::vector<std::string>{"1", "\"x\"", "4"});
  CHECK(texts_of(cases[11]) == std::vector<std::string>{"2", "\"y\"", "5"});
  CHECK_FALSE(cases[0].settings[1].number);
}

TEST_CASE("steps of a range are short decimals, its ends as stated", "[unit][design]") {
  const auto texts = [](const Range& range) {
    std::vector<std::string> all;
    for (const Setting& setting : settings_of(ranged("a", range))) all.push_back(setting.toml);
    return all;
  };
  using Texts = std::vector<std::string>;
  CHECK(texts({0.1, 0.5, 5}) == Texts{"0.1", "0.2", "0.3", "0.4", "0.5"});
  CHECK(texts({1, 5, 5}) == Texts{"1", "2", "3", "4", "5"});
  CHECK(texts({-1, 1, 3}) == Texts{"-1", "0", "1"});
  CHECK(texts({0.0625, 0.3125, 5}) == Texts{"0.0625", "0.125", "0.1875", "0.25", "0.3125"});
  CHECK(texts({0.01, 100, 5, true}) == Texts{"0.01", "0.1", "1", "10", "100"});
  CHECK(texts({0, 1, 4}) == Texts{"0", "0.3333", "0.6667", "1"});
  CHECK(texts({1000, 3000, 3}) == Texts{"1000", "2000", "3000"});
}

TEST_CASE("steps rise, keep within the range and are evenly spread", "[property][design]") {
  RandomNumbers random(7);
  for (int round = 0; round < 300; ++round) {
    const bool logarithmic = round % 2 == 0;
    const double low = (random.share() - (logarithmic ? 0 : 0.5)) * 10 + 1e-6;
    const Range range{low, low + std::pow(10, random.share() * 8 - 5), 2 + random.below(60),
                      logarithmic};
    CAPTURE(range.low, range.high, range.steps, logarithmic);
    const std::vector<Setting> steps = settings_of(ranged("a", range));
    REQUIRE(steps.size() == range.steps);
    CHECK(steps.front().number == range.low);
    CHECK(steps.back().number == range.high);
    const auto last = static_cast<double>(range.steps - 1);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      CHECK(model::parse_number(steps[i].toml) == steps[i].number);
      CHECK(std::abs(share_of(range, *steps[i].number) * last - static_cast<double>(i)) < 2e-3);
    }
  }
}

TEST_CASE("one at a time leaves all others at their base", "[unit][design]") {
  Plan plan = plan_of(Method::one_at_a_time, {listed("a", {1, 2, 3}), words("b", {"x", "y"})});
  CHECK_THROWS_AS(design(plan), std::invalid_argument);
  plan.variables[0].base = number_setting(2);
  plan.variables[1].base = Setting{"\"z\"", {}};
  const std::vector<Case> cases = design(plan);
  check_design(plan, cases);
  REQUIRE(cases.size() == 5);
  using Texts = std::vector<std::string>;
  CHECK(texts_of(cases[0]) == Texts{"2", "\"z\""});
  CHECK(texts_of(cases[1]) == Texts{"1", "\"z\""});
  CHECK(texts_of(cases[2]) == Texts{"3", "\"z\""});
  CHECK(texts_of(cases[3]) == Texts{"2", "\"x\""});
  CHECK(texts_of(cases[4]) == Texts{"2", "\"y\""});
}

TEST_CASE("random samples: as many as asked, all different, the same again", "[property][design]") {
  for (const std::size_t samples : {1u, 2u, 17u, 1000u}) {
    const Plan plan = plan_of(Method::random,
                              {ranged("a", {0.1, 0.4}), ranged("b", {1e-4, 10, 0, true}),
                               words("c", {"x", "y", "z"}), ranged("d", {1, 4, 4})},
                              samples, 5);
    const std::vector<Case> cases = design(plan);
    check_design(plan, cases);
    const std::vector<Case> again = design(plan);
    for (std::size_t i = 0; i < samples; ++i) CHECK(texts_of(cases[i]) == texts_of(again[i]));
  }
  Plan other = plan_of(Method::random, {ranged("a", {0, 1})}, 3, 5);
  const std::vector<Case> five = design(other);
  other.seed = 6;
  CHECK(texts_of(five[0]) != texts_of(design(other)[0]));
}

TEST_CASE("random samples fill their range evenly, by logarithms where asked",
          "[property][design]") {
  const Range linear{2, 5}, logarithmic{1e-3, 10, 0, true};
  const Plan plan = plan_of(Method::random, {ranged("a", linear), ranged("b", logarithmic)}, 20000);
  std::vector<double> shares[2];
  for (const Case& one : design(plan)) {
    shares[0].push_back(share_of(linear, *one.settings[0].number));
    shares[1].push_back(share_of(logarithmic, *one.settings[1].number));
  }
  for (std::vector<double>& column : shares) {
    std::sort(column.begin(), column.end());
    double largest = 0;  // Kolmogorov's distance from the even distribution
    for (std::size_t i = 0; i < column.size(); ++i)
      largest = std::max(largest, std::abs(column[i] - static_cast<double>(i) /
                                                           static_cast<double>(column.size())));
    CHECK(largest < 1.63 / std::sqrt(20000.0));  // 1 % of even samples are further
  }
}

TEST_CASE("a Latin hypercube has one sample in each stratum", "[property][design]") {
  for (const std::size_t samples : {1u, 2u, 3u, 10u, 97u, 2000u}) {
    const Range linear{0.1, 0.4}, logarithmic{1e-4, 10, 0, true};
    const Plan plan = plan_of(
        Method::latin_hypercube,
        {ranged("a", linear), words("c", {"x", "y", "z"}), ranged("b", logarithmic)}, samples, 11);
    const std::vector<Case> cases = design(plan);
    check_design(plan, cases);
    std::vector<int> in_stratum[2] = {std::vector<int>(samples), std::vector<int>(samples)};
    std::map<std::string, int> of_word;
    const auto n = static_cast<double>(samples);
    const auto count = [&](std::vector<int>& strata, const Range& range, double value) {
      std::size_t i = 0;
      while (i + 1 < samples && value >= at(range, static_cast<double>(i + 1) / n)) ++i;
      ++strata[i];
    };
    for (const Case& one : cases) {
      count(in_stratum[0], linear, *one.settings[0].number);
      count(in_stratum[1], logarithmic, *one.settings[2].number);
      ++of_word[one.settings[1].toml];
    }
    for (const std::vector<int>& strata : in_stratum)
      CHECK(std::all_of(strata.begin(), strata.end(), [](int k) { return k == 1; }));
    for (const auto& [word, times] : of_word) CHECK(std::abs(times - n / 3) < 1);
  }
}

TEST_CASE("Latin hypercubes of counted settings have no case twice", "[property][design]") {
  const std::vector<Variable> variables = {listed("a", {1, 2, 3}), words("b", {"x", "y"}),
                                           ranged("c", {1, 4, 4})};
  for (std::size_t samples = 1; samples <= 24; ++samples) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Plan plan = plan_of(Method::latin_hypercube, variables, samples, seed);
      check_design(plan, design(plan));
    }
  }
  CHECK_THROWS_AS(design(plan_of(Method::latin_hypercube, variables, 25)), std::invalid_argument);
  CHECK_THROWS_AS(design(plan_of(Method::random, variables, 25)), std::invalid_argument);
  CHECK(design(plan_of(Method::random, variables, 24)).size() == 24);
}

TEST_CASE("the generator is SplitMix64", "[unit][design]") {
  // The first numbers of the published reference implementation for the seed 1234567.
  RandomNumbers random(1234567);
  CHECK(random.next() == 6457827717110365317u);
  CHECK(random.next() == 3203168211198807973u);
  CHECK(random.next() == 9817491932198370423u);
}

TEST_CASE("plans that make no cases, or too many, are refused", "[unit][design]") {
  CHECK_THROWS_AS(design(plan_of(Method::grid, {})), std::invalid_argument);
  CHECK_THROWS_AS(design(plan_of(Method::grid, {ranged("a", {0, 1})})), std::invalid_argument);
  CHECK_THROWS_AS(design(plan_of(Method::random, {ranged("a", {0, 1})}, 0)), std::invalid_argument);
  CHECK_THROWS_AS(design(plan_of(Method::search, {ranged("a", {0, 1})})), std::invalid_argument);
  const Plan large = plan_of(Method::grid, {ranged("a", {0, 1, 1000}), ranged("b", {0, 1, 1000})});
  CHECK(case_count(large) == 1000000);
  CHECK_THROWS_AS(design(large), std::invalid_argument);
  const Plan beyond = plan_of(Method::grid, std::vector<Variable>(8, ranged("a", {0, 1, 100000})));
  CHECK(case_count(beyond) == static_cast<std::size_t>(-1));
}

TEST_CASE("the largest study is designed at once", "[property][design]") {
  for (const Method method : {Method::random, Method::latin_hypercube}) {
    const Plan plan =
        plan_of(method, {ranged("a", {0.1, 0.4}), words("b", {"x", "y"})}, kMostCases, 1);
    check_design(plan, design(plan));
  }
}

}  // namespace limitgauge::study
