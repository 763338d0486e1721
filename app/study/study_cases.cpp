#include "app/study/study_cases.h"

#include <optional>
#include <sstream>
#include <unordered_map>
#include <utility>

#include "model/base/error.h"
#include "reports/record/record_reader.h"

namespace limitgauge::app {

/// The cases of one call: what is known of them by and by.
struct StudyCases::Asked {
  std::span<const study::Case> cases;
  std::vector<study::Row> rows;
  std::vector<study::CaseRequest> requests;  ///< of those whose job can be read
};

std::vector<std::string> StudyCases::overrides_of(const study::Case& asked) const {
  std::vector<std::string> overrides = options_.overrides;
  for (std::size_t i = 0; i < asked.settings.size(); ++i)
    overrides.push_back(options_.keys.at(i) + "=" + asked.settings[i].toml);
  return overrides;
}

/// Before anything is run: a key that no job has is said at once.
void StudyCases::know(Asked& all) {
  const std::size_t figures = study_figures(options_.scope).size();
  std::optional<model::InputError> first_refusal;
  for (std::size_t i = 0; i < all.cases.size(); ++i) {
    if (options_.stop != nullptr && *options_.stop) throw model::Interrupted();
    study::Row& row = all.rows[i];
    row.asked = all.cases[i];
    row.figures.resize(figures);
    study::CaseRequest request;
    request.index = row.asked.index;
    request.overrides = overrides_of(row.asked);
    try {
      CaseKeys keys = keys_.keys(options_.job, request.overrides);
      row.key = request.key = std::move(keys.result);
      request.prefixes = std::move(keys.prefixes);
      all.requests.push_back(std::move(request));
    } catch (const model::InputError& refusal) {
      if (!first_refusal) first_refusal = refusal;
      row.status = study::Status::error;
      row.reason = single_line(refusal.what());
    }
  }
  any_accepted_ = any_accepted_ || !all.requests.empty();
  if (!any_accepted_ && first_refusal) throw *first_refusal;
}

/// False where the store has no result that can be read.
bool StudyCases::fill(study::Row& row) {
  const std::optional<std::string> text = store_.get("result", row.key);
  if (!text) return false;
  try {
    std::istringstream in(*text);
    fill_row(row, reports::record::read_result_json(in, "result.json"), options_.scope);
  } catch (const model::InputError&) {
    return false;
  }
  options_.result(row.asked.index, *text);
  return true;
}

void StudyCases::ended(const study::Row& row) {
  ++progress_.ended;
  if (row.reused) ++progress_.reused;
  if (row.attempts > 0) ++progress_.run;
  if (row.status == study::Status::error || row.status == study::Status::lost) ++progress_.failed;
  options_.progress(progress_);
}

void StudyCases::take_from_store(Asked& all) {
  std::vector<study::CaseRequest> others;
  std::size_t next = 0;
  for (study::Row& row : all.rows) {
    if (options_.stop != nullptr && *options_.stop) throw model::Interrupted();
    const bool known = next < all.requests.size() && all.requests[next].index == row.asked.index;
    row.reused = known && fill(row);
    if (known && !row.reused) others.push_back(std::move(all.requests[next]));
    if (known) ++next;
    if (!known || row.reused) ended(row);
  }
  all.requests = std::move(others);
}

void StudyCases::run_others(Asked& all) {
  std::unordered_map<std::size_t, study::Row*> row_of;
  for (study::Row& row : all.rows) row_of[row.asked.index] = &row;
  const auto take = [&](const study::CaseOutcome& outcome) {
    using Ending = study::CaseOutcome::Ending;
    study::Row& row = *row_of.at(outcome.index);
    row.attempts = outcome.attempts;
    row.seconds = outcome.seconds;
    row.reason = outcome.reason;
    row.status = outcome.ending == Ending::error ? study::Status::error : study::Status::lost;
    if (outcome.ending == Ending::done && !fill(row))
      row.reason = "its result was put into the cache and is not to be found there";
    ended(row);
  };
  static const std::atomic<bool> never{false};
  executor_.run(all.requests, take, options_.stop != nullptr ? *options_.stop : never);
}

std::vector<study::Row> StudyCases::rows(std::span<const study::Case> cases) {
  Asked all{cases, std::vector<study::Row>(cases.size()), {}};
  know(all);
  progress_.cases += cases.size();
  take_from_store(all);
  if (!all.requests.empty()) {
    if (!std::exchange(any_run_, true)) options_.before_running();
    run_others(all);
  }
  return std::move(all.rows);
}

std::string single_line(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at))
    text.replace(at, 1, "; ");
  return text;
}

}  // namespace limitgauge::app
