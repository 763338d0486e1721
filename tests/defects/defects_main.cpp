// The planted-defect suite: the verifier is given programs that harm the part in known ways, and
// their unharmed twins.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <string_view>

#include "model/base/run_control.h"
#include "tests/defects/orientations/lying_bench.h"
#include "tests/defects/orientations/lying_suite.h"
#include "tests/defects/orientations/lying_table.h"
#include "tests/defects/scenes.h"
#include "tests/defects/surfaces/surfaces.h"
#include "tests/defects/table.h"
#include "tests/defects/triples.h"
#include "tests/support/folders.h"

namespace limitgauge::tests::defects {
namespace {

/// Widest certified interval.
constexpr double kResolution_mm = 0.001;
constexpr double kSmallest_mm = 0.0005, kLargest_mm = 2;
constexpr std::size_t kVoxelsEvery = 12;

struct Options {
  std::size_t sample = 0;                                        ///< cases; 0: all
  std::size_t scenes = std::numeric_limits<std::size_t>::max();  ///< of those there are
  std::size_t triples = 0;  ///< random triples held against the oracle
  unsigned threads = 2;
  std::string surface, cutter;  ///< only these
  std::string cases_file;
  double minutes = std::numeric_limits<double>::infinity();  ///< no pair is begun after these
  unsigned orientations = 0;  ///< above 0: passes lie turned, each pair in a way of its own; a seed
  std::size_t jobs = 0;       ///< above 0: nothing but so many defects where parts lie turned
  std::size_t twins = 0;      ///< of them; 0: three to ten defects
  std::string keep;           ///< folder for the files of those jobs
};

/// Mishaps on one surface with one cutter in the full run.
constexpr Kind kProgramme[] = {Kind::sunk_pass,      Kind::rapid_through,  Kind::shifted_pass,
                               Kind::wrong_length,   Kind::missing_pass,   Kind::wrong_radius,
                               Kind::skipped_line,   Kind::rotated_offset, Kind::sunk_pass,
                               Kind::raised_pass,    Kind::swapped_units,  Kind::rapid_through,
                               Kind::wrong_allowance};

/// Sizes spread evenly over the logarithm by the golden ratio, so that any part of the suite has
/// small and large ones of every kind.
Mishap mishap(Kind kind, std::size_t number) {
  const double turn = std::fmod(static_cast<double>(number) * std::numbers::phi, 1.0);
  return {kind, kSmallest_mm * std::pow(kLargest_mm / kSmallest_mm, turn),
          static_cast<unsigned>(1000 + number)};
}

std::vector<PairPlan> full_plan(const Options& options) {
  const std::vector<NamedCage> surfaces = suite_surfaces(tests::fixtures().string());
  const std::vector<model::Cutter> cutters = suite_cutters();
  std::vector<PairPlan> plans;
  std::size_t number = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    for (std::size_t c = 0; c < cutters.size(); ++c) {
      constexpr double kSteps_mm[] = {0.3, 0.5, 0.4, 0.7, 0.35};
      PairPlan plan{surfaces[s].name, surfaces[s].cage,      cutters[c], 0, 0, false, {}, 0,
                    kVoxelsEvery,     s * cutters.size() + c};
      plan.resolution_mm = kResolution_mm;
      plan.step_mm = kSteps_mm[(s + 2 * c) % std::size(kSteps_mm)];
      plan.across = static_cast<int>((s + c) % 2);
      plan.modal = (s + c) % 3 == 0;
      for (const Kind kind : kProgramme) plan.mishaps.push_back(mishap(kind, number++));
      const bool wanted = (options.surface.empty() || options.surface == plan.surface_name) &&
                          (options.cutter.empty() || options.cutter == plan.cutter.id);
      if (wanted) plans.push_back(plan);
    }
  return plans;
}

/// Every surface and every cutter, each with a few mishaps; other kinds from pair to pair.
std::vector<PairPlan> sample_of(const std::vector<PairPlan>& all, std::size_t cases) {
  constexpr std::size_t kPerPair = 4, kCutters = 4;
  std::vector<PairPlan> out;
  const std::size_t surfaces = all.size() / kCutters;
  for (std::size_t k = 0; k * kPerPair < cases; ++k) {
    PairPlan plan = all[(k % surfaces) * kCutters + k % kCutters];
    // The last kind needs a twin of its own.
    const std::size_t kinds = plan.mishaps.size() - 1;
    std::vector<Mishap> few;
    for (std::size_t m = 0; m < kPerPair; ++m) few.push_back(plan.mishaps[(k * 3 + m * 4) % kinds]);
    plan.mishaps = few;
    plan.voxels_every = k % 4 == 0 ? kPerPair : 0;
    out.push_back(plan);
  }
  return out;
}

bool read_options(int count, char** words, Options& options) {
  for (int i = 1; i + 1 < count; i += 2) {
    const std::string_view key = words[i], value = words[i + 1];
    const auto number = [&](auto& to) {
      return std::from_chars(value.data(), value.data() + value.size(), to).ec == std::errc{};
    };
    const bool good = key == "--sample"         ? number(options.sample)
                      : key == "--scenes"       ? number(options.scenes)
                      : key == "--triples"      ? number(options.triples)
                      : key == "--threads"      ? number(options.threads)
                      : key == "--surface"      ? (options.surface = value, true)
                      : key == "--cutter"       ? (options.cutter = value, true)
                      : key == "--minutes"      ? number(options.minutes)
                      : key == "--orientations" ? number(options.orientations)
                      : key == "--jobs"         ? number(options.jobs)
                      : key == "--twins"        ? number(options.twins)
                      : key == "--keep"         ? (options.keep = value, true)
                      : key == "--cases"        ? (options.cases_file = value, true)
                                                : false;
    if (!good) return false;
  }
  return count % 2 == 1;
}

/// Runs the pairs, surfaces and cutters in turn, as far as the time allows.
std::vector<PairResult> run_pairs(const std::vector<PairPlan>& plans, const Options& options) {
  using Clock = std::chrono::steady_clock;
  const auto seconds_since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const auto start = Clock::now();
  std::vector<PairResult> results(plans.size());
  constexpr std::size_t kStride = 5;  // coprime to the number of cutters: all come early
  const std::size_t stride = std::gcd(kStride, plans.size()) == 1 ? kStride : 1;
  model::parallel_for(plans.size(), options.threads, [&](std::size_t turn) {
    const std::size_t k = turn * stride % plans.size();
    if (seconds_since(start) > 60 * options.minutes) return;
    const auto begun = Clock::now();
    results[k] = run_pair(plans[k]);
    std::fprintf(stderr, "%s, %s: %zu cases, %.1f s\n", plans[k].surface_name.c_str(),
                 plans[k].cutter.id.c_str(), results[k].cases.size(), seconds_since(begun));
  });
  std::fprintf(stderr, "%.0f s\n", seconds_since(start));
  return results;
}

/// The scenes, the triples: true where nothing went wrong.
bool run_scenes(const Options& options) {
  std::vector<Scene> scenes = suite_scenes();
  if (options.scenes < scenes.size()) scenes.resize(options.scenes);
  std::vector<SceneResult> results(scenes.size());
  model::parallel_for(scenes.size(), options.threads, [&](std::size_t k) {
    results[k] = run_scene(scenes[k]);
    const SceneResult& r = results[k];
    std::fprintf(stderr, "%s, %s%s: %s, %.1f s\n", name(r.kind), r.label.c_str(),
                 r.harmed ? "" : " (twin)", verifier::name(r.verdict), r.seconds);
  });
  write_scene_table(std::cout, results);
  write_scene_failures(std::cerr, results);
  return std::all_of(results.begin(), results.end(), [](const SceneResult& r) { return r.good(); });
}

bool run_triples(const Options& options) {
  std::vector<TripleResult> results(options.triples);
  model::parallel_for(options.triples, options.threads, [&](std::size_t k) {
    results[k] = hold_against_oracle(random_triple(static_cast<unsigned>(k)));
  });
  std::size_t wrong = 0;
  for (std::size_t k = 0; k < results.size(); ++k) {
    wrong += !results[k].contradictions.empty();
    for (const std::string& what : results[k].contradictions)
      std::cerr << "triple " << k << ": " << what << "\n";
  }
  if (!results.empty())
    std::cout << "\nRandom triples of surface, cutters and paths held against the oracle: "
              << results.size() << ", with a contradiction: " << wrong << ".\n";
  return wrong == 0;
}

/// Turned over, on a side, or in any way, by turns.
model::Pose any_pose(std::mt19937_64& random) {
  std::uniform_real_distribution<double> part(-1, 1);
  model::Pose pose;
  switch (random() % 3) {
    case 0:
      pose = model::turn_about({1, 0, 0}, 180);
      break;
    case 1:
      pose = model::turn_about({0, 1, 0}, random() % 2 == 0 ? 90 : -90);
      break;
    default:
      pose = model::turn_about({part(random), part(random), part(random)}, 180 * part(random));
  }
  pose.shift_mm = {10 * part(random), 10 * part(random), 10 * part(random)};
  return pose;
}

/// Parts that lie turned, as jobs: 0 where nothing went wrong.
int run_jobs(const Options& options) {
  const std::size_t twins = options.twins > 0 ? options.twins : (3 * options.jobs + 9) / 10;
  std::vector<LyingPlan> plans = lying_plans(options.orientations, options.jobs, twins);
  std::erase_if(plans, [&](const LyingPlan& plan) {
    return (!options.surface.empty() && options.surface != plan.surface_name) ||
           (!options.cutter.empty() && options.cutter != plan.cutter.id);
  });
  std::vector<std::vector<LyingResult>> found(plans.size());
  model::parallel_for(plans.size(), options.threads, [&](std::size_t k) {
    found[k] = run_lying(plans[k], options.keep);
    double seconds = 0;
    for (const LyingResult& r : found[k]) seconds += r.seconds;
    std::fprintf(stderr, "%s: %zu jobs, %.1f s\n", found[k].front().label.c_str(), found[k].size(),
                 seconds);
  });
  std::vector<LyingResult> results;
  for (const auto& some : found) results.insert(results.end(), some.begin(), some.end());
  write_lying_tables(std::cout, results);
  write_lying_failures(std::cerr, results);
  if (!options.cases_file.empty()) {
    std::ofstream cases(options.cases_file);
    write_lying_cases(cases, results);
  }
  return std::all_of(results.begin(), results.end(), [](const auto& r) { return r.good(); }) ? 0
                                                                                             : 1;
}

int run(const Options& options) {
  if (options.jobs > 0) return run_jobs(options);
  std::vector<PairPlan> plans = full_plan(options);
  if (options.sample > 0) plans = sample_of(plans, options.sample);
  std::mt19937_64 random(options.orientations);
  if (options.orientations > 0)
    for (PairPlan& plan : plans) plan.lying = any_pose(random);
  const std::vector<PairResult> results = run_pairs(plans, options);
  write_tables(std::cout, results);
  write_failures(std::cerr, results);
  if (!options.cases_file.empty()) {
    std::ofstream cases(options.cases_file);
    write_cases(cases, results);
  }
  const auto left_out = std::count_if(results.begin(), results.end(),
                                      [](const PairResult& r) { return r.cases.empty(); });
  if (left_out > 0)
    std::cout << "\nNot run for want of time: " << left_out << " of " << results.size()
              << " pairs of surface and cutter.\n";
  std::cout << "\n";
  const bool scenes_good = run_scenes(options), triples_good = run_triples(options);
  return summarize(results).good() && left_out == 0 && scenes_good && triples_good ? 0 : 1;
}

}  // namespace
}  // namespace limitgauge::tests::defects

int main(int count, char** words) {
  using namespace limitgauge::tests::defects;
  Options options;
  if (!read_options(count, words, options)) {
    std::fprintf(stderr,
                 "usage: limitgauge_defects [--sample CASES] [--scenes COUNT] [--triples COUNT] "
                 "[--threads N] [--surface NAME] "
                 "[--cutter ID] [--cases FILE.tsv] [--minutes M] [--orientations SEED] "
                 "[--jobs DEFECTS] [--twins COUNT] [--keep FOLDER]\n");
    return 2;
  }
  return run(options);
}
