#include "study/plan/sampling.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "study/plan/random_numbers.h"
#include "study/plan/settings.h"

namespace limitgauge::study {
namespace {

/// Places of settings in the lists of counted variables.
using Places = std::vector<std::size_t>;

/// Fine enough that rounding moves no sample noticeably, coarse enough for a short text.
constexpr double kLeastParts = 1e4, kPartsOfStratum = 100;

std::vector<std::vector<Setting>> counted_settings(const Plan& plan) {
  std::vector<std::vector<Setting>> all;
  for (const Variable& variable : plan.variables)
    all.push_back(is_counted(variable) ? settings_of(variable) : std::vector<Setting>{});
  return all;
}

std::string text_of(const std::vector<Setting>& settings) {
  std::string text;
  for (const Setting& setting : settings) text += setting.toml + '\0';
  return text;
}

void require_room(const Plan& plan) {
  const std::optional<std::size_t> room = combinations(plan);
  if (plan.samples == 0 || (room && *room < plan.samples))
    throw std::invalid_argument("samples that the variables do not have");
}

std::vector<std::vector<Setting>> settings_at(const std::vector<Places>& rows,
                                              const std::vector<std::vector<Setting>>& counted) {
  std::vector<std::vector<Setting>> all;
  for (const Places& row : rows) {
    all.emplace_back();
    for (std::size_t v = 0; v < row.size(); ++v) all.back().push_back(counted[v][row[v]]);
  }
  return all;
}

Places places_of(std::size_t combination, const std::vector<std::vector<Setting>>& counted) {
  Places places(counted.size());
  for (std::size_t v = counted.size(); v-- > 0; combination /= counted[v].size())
    places[v] = combination % counted[v].size();
  return places;
}

/// Some of all combinations, each at most once.
std::vector<Places> drawn_from_all(std::size_t samples, std::size_t room,
                                   const std::vector<std::vector<Setting>>& counted,
                                   RandomNumbers& random) {
  std::vector<std::size_t> order(room);
  for (std::size_t i = 0; i < room; ++i) order[i] = i;
  random.shuffle(order);
  std::vector<Places> rows;
  for (std::size_t i = 0; i < samples; ++i) rows.push_back(places_of(order[i], counted));
  return rows;
}

/// Strata 0 to samples - 1 in some order.
std::vector<std::size_t> strata(std::size_t samples, RandomNumbers& random) {
  std::vector<std::size_t> order(samples);
  for (std::size_t i = 0; i < samples; ++i) order[i] = i;
  random.shuffle(order);
  return order;
}

/// Exchanges one setting of row `r` with another row, which leaves the counts of settings as they
/// are, where that makes row `r` new and the other no duplicate. True where it did.
bool exchanged(std::vector<Places>& rows, std::size_t r, std::multiset<Places>& seen,
               RandomNumbers& random) {
  const std::size_t v = random.below(rows[r].size()), other = random.below(rows.size());
  Places mine = rows[r], theirs = rows[other];
  std::swap(mine[v], theirs[v]);
  if (mine == theirs || seen.count(mine) > 0 || seen.count(theirs) > 0) return false;
  for (const std::size_t row : {r, other}) seen.erase(seen.find(rows[row]));
  seen.insert(mine);
  seen.insert(theirs);
  rows[r] = std::move(mine);
  rows[other] = std::move(theirs);
  return true;
}

/// Makes rows that are alike different; they must be no more than half of all there can be. A row
/// that no exchange was found for becomes any combination that is left.
void part_duplicates(std::vector<Places>& rows, const std::vector<std::vector<Setting>>& counted,
                     RandomNumbers& random) {
  constexpr int kTries = 1000;
  std::multiset<Places> seen(rows.begin(), rows.end());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (int i = 0; i < kTries && seen.count(rows[r]) > 1; ++i) exchanged(rows, r, seen, random);
    if (seen.count(rows[r]) == 1) continue;
    seen.erase(seen.find(rows[r]));
    while (seen.count(rows[r]) > 0)
      for (std::size_t v = 0; v < counted.size(); ++v) rows[r][v] = random.below(counted[v].size());
    seen.insert(rows[r]);
  }
}

std::vector<Places> counted_hypercube(std::size_t samples,
                                      const std::vector<std::vector<Setting>>& counted,
                                      RandomNumbers& random) {
  std::vector<Places> rows(samples, Places(counted.size()));
  for (std::size_t v = 0; v < counted.size(); ++v) {
    const std::vector<std::size_t> order = strata(samples, random);
    for (std::size_t i = 0; i < samples; ++i) rows[i][v] = order[i] * counted[v].size() / samples;
  }
  part_duplicates(rows, counted, random);
  return rows;
}

Setting sample_of(const Variable& variable, const std::vector<Setting>& counted,
                  std::size_t stratum, std::size_t samples, RandomNumbers& random) {
  if (is_counted(variable)) return counted[stratum * counted.size() / samples];
  const auto n = static_cast<double>(samples);
  const auto from = static_cast<double>(stratum);
  const double parts = std::max(kPartsOfStratum, kLeastParts / n);
  return number_setting(drawn(*variable.range, from / n, (from + 1) / n, random.share(), parts));
}

}  // namespace

std::optional<std::size_t> combinations(const Plan& plan) {
  std::size_t count = 1;
  for (const Variable& variable : plan.variables) {
    const std::size_t settings = setting_count(variable);
    if (!is_counted(variable) || settings > kMostCases) return std::nullopt;
    count *= settings;
    if (count > kMostCases * kMostCases) return std::nullopt;
  }
  return count;
}

std::vector<std::vector<Setting>> random_samples(const Plan& plan) {
  require_room(plan);
  const std::vector<std::vector<Setting>> counted = counted_settings(plan);
  const double parts = std::max(kLeastParts, kPartsOfStratum * static_cast<double>(plan.samples));
  RandomNumbers random(plan.seed);
  std::set<std::string> seen;
  std::vector<std::vector<Setting>> all;
  while (all.size() < plan.samples) {
    std::vector<Setting> settings;
    for (std::size_t v = 0; v < counted.size(); ++v) {
      const Variable& variable = plan.variables[v];
      settings.push_back(is_counted(variable)
                             ? counted[v][random.below(counted[v].size())]
                             : number_setting(drawn(*variable.range, 0, 1, random.share(), parts)));
    }
    if (seen.insert(text_of(settings)).second) all.push_back(std::move(settings));
  }
  return all;
}

std::vector<std::vector<Setting>> latin_hypercube_samples(const Plan& plan) {
  require_room(plan);
  const std::vector<std::vector<Setting>> counted = counted_settings(plan);
  RandomNumbers random(plan.seed);
  if (const std::optional<std::size_t> room = combinations(plan)) {
    const bool crowded = *room < 2 * plan.samples;
    return settings_at(crowded ? drawn_from_all(plan.samples, *room, counted, random)
                               : counted_hypercube(plan.samples, counted, random),
                       counted);
  }
  std::vector<std::vector<Setting>> all(plan.samples);
  for (std::size_t v = 0; v < counted.size(); ++v) {
    const std::vector<std::size_t> order = strata(plan.samples, random);
    for (std::size_t i = 0; i < plan.samples; ++i)
      all[i].push_back(sample_of(plan.variables[v], counted[v], order[i], plan.samples, random));
  }
  return all;
}

}  // namespace limitgauge::study
