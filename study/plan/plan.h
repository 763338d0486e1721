#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/store/table.h"

namespace limitgauge::study {

enum class Method { grid, list, random, latin_hypercube, one_at_a_time, search };
const char* name(Method method);

/// Cases of one study at most.
inline constexpr std::size_t kMostCases = 100'000;

/// Numbers from `low` to `high`, both in; `steps` of them where they are counted, evenly spread, by
/// their logarithms where `logarithmic`.
struct Range {
  double low = 0, high = 0;
  std::size_t steps = 0;  ///< 0: not stated; drawn from as a continuum
  bool logarithmic = false;
};

/// A key of the job that is varied: over listed values or over a range.
struct Variable {
  std::string key;              ///< as --set takes it: "stage.finish.step"
  std::vector<Setting> values;  ///< empty where there is a range
  std::optional<Range> range;
  std::optional<Setting> base;  ///< the job's own setting, or what stands in for it; may be unknown
};

/// The figure that a search for the largest setting is for: the setting itself.
inline constexpr const char* kSearchedSetting = "searched_setting";

/// What a search is for: the least `cost` at which every gate of every stage passes, or the largest
/// setting.
struct Search {
  std::string cost = "machining_time_s";  ///< id of a figure
  /// The one key that is varied, all of whose settings are numbers: its largest setting is sought,
  /// and `cost` is kSearchedSetting.
  std::optional<std::string> largest;
  std::size_t most_cases = 40;
  double accuracy = 0.01;  ///< share of a range at which a setting counts as found
  /// Cases that are run side by side. Part of the plan and not of the machine: it decides which
  /// cases are run.
  std::size_t batch = 4;
};

/// A study as its file states it.
struct Plan {
  std::string name;
  std::filesystem::path job;  ///< resolved against the study file
  std::string job_as_stated;
  Method method = Method::grid;
  std::vector<Variable> variables;
  std::vector<std::vector<Setting>> listed;  ///< of Method::list: a setting for each variable
  std::size_t samples = 0;                   ///< of random and latin_hypercube
  std::uint64_t seed = 0;
  Search search;
  std::string cost = "machining_time_s";  ///< figure that accuracy is bought with
  std::vector<std::string>
      accuracy;  ///< figures that are bought; empty: uncut and gouge of the last stage
};

}  // namespace limitgauge::study
