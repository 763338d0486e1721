#include <algorithm>
#include <cctype>
#include <chrono>
#include <string_view>

#include "app/cli/command_definition.h"
#include "app/cli/option_checks.h"
#include "history/entry.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

constexpr int kUsualRuns = 200, kMostRuns = 1'000'000;

CLI::Validator short_name() {
  return CLI::Validator(
      [](const std::string& text) {
        if (text.size() <= history::kLongestName) return std::string();
        return "is longer than " + std::to_string(history::kLongestName) + " bytes";
      },
      "");
}

/// Of a text in the form of a date: whether there is such a day, and such a time of day.
bool occurs(std::string_view text) {
  const auto number_at = [&](std::size_t at, std::size_t digits) {
    return model::parse_whole<int>(text.substr(at, digits)).value();
  };
  const std::chrono::year_month_day day{std::chrono::year{number_at(0, 4)},
                                        std::chrono::month{static_cast<unsigned>(number_at(5, 2))},
                                        std::chrono::day{static_cast<unsigned>(number_at(8, 2))}};
  const bool has_minutes = text.size() > 10, has_seconds = text.size() > 16;
  return day.ok() && (!has_minutes || (number_at(11, 2) < 24 && number_at(14, 2) < 60)) &&
         (!has_seconds || number_at(17, 2) < 60);
}

/// "2026-11-22", or with the time of day in UTC: the beginning of what a history holds.
bool is_date(std::string_view text) {
  constexpr std::string_view kForm = "0000-00-00T00:00:00Z";
  const bool whole =
      text.size() == 10 || text.size() == 16 || text.size() == 19 || text.size() == kForm.size();
  const bool has_form =
      whole && std::equal(text.begin(), text.end(), kForm.begin(), [](char c, char form) {
        return form == '0' ? c >= '0' && c <= '9' : c == form;
      });
  return has_form && occurs(text);
}

CLI::Validator date() {
  return CLI::Validator(
      [](const std::string& text) {
        return is_date(text) ? "" : "is no date like 2026-11-22 or 2026-11-22T18:30:00Z";
      },
      "");
}

}  // namespace

void CommandDefinition::add_history_options(CLI::App& run, HistoryOptions& history) {
  CLI::Option* kept = file(
      run.add_option("--history", history.file, "Add the run's figures to this history (SQLite)"),
      "sqlite");
  hint(run.add_option("--label", history.label, "Name of the run, in its result and the history"),
       "WORDS")
      ->check(short_name());
  hint(run.add_option("--commit", history.commit, "Commit of what is verified, for the history"),
       "COMMIT")
      ->check(short_name())
      ->needs(kept);
}

void CommandDefinition::add_history() {
  HistoryCommand& history = parsed_.history;
  CLI::App& sub = *app_.add_subcommand("history", "List and plot the figures of past runs");
  file(sub.add_option("FILE", history.file, "History that run --history wrote"), "sqlite")
      ->required();
  folder(sub.add_option("-o,--output", history.output,
                        "Folder for history.html (default: limitgauge-out/NAME of the file)"));
  hint(sub.add_option("--job", history.job, "Runs of this job only"), "NAME");
  hint(sub.add_option("--stage", history.stages, "Figures of this stage only"), "NAME")
      ->allow_extra_args(false);
  hint(sub.add_option("--metric", history.metrics,
                      "Figure to show, as result.json names it (default: gouge_mm, uncut_mm and "
                      "the machining time)"),
       "NAME")
      ->allow_extra_args(false);
  history.last = kUsualRuns;
  hint(sub.add_option("--last", history.last, "The newest N runs (default: 200)"), "N")
      ->check(whole_number(1, kMostRuns));
  hint(sub.add_option("--since", history.since, "Runs from this day on, UTC: 2026-11-22"), "DATE")
      ->check(date());
  add_common(sub);
  hide_unused(sub);
  sub.get_option("--force")->group(sub.get_option("--quiet")->get_group());
}

}  // namespace limitgauge::app
