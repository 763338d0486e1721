#include "tests/reports/sample_study.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "model/text/number_text.h"
#include "reports/text/text.h"

namespace limitgauge::reports {
namespace {

using study::Status;

constexpr double kGate_mm = 0.03, kRadius_mm = 3;
enum Figures { machining_time, uncut_high, gouge_high, uncut_low, gouge_low, coverage, moves };

study::Setting number(double value) {
  return {model::shortest(value), value};
}

std::vector<study::Figure> figures() {
  return {{"machining_time_s", "machining time", "s"},
          {"finish.uncut_mm.high", "finish: certified uncut", "mm"},
          {"finish.gouge_mm.high", "finish: certified gouge", "mm"},
          {"finish.uncut_mm.low", "finish: uncut at its witness", "mm"},
          {"finish.gouge_mm.low", "finish: gouge at its witness", "mm"},
          {"finish.coverage", "finish: coverage", ""},
          {"finish.moves", "finish: moves", ""}};
}

/// What a finish with these settings gives; the terms that no setting changes are those of a dome
/// of 20 mm.
std::vector<std::optional<double>> measured(double step, double tolerance, double allowance) {
  const double rows = 20 / step;
  const double cusp = step * step / (8 * kRadius_mm) * 1.35;
  const double count = rows * 20 / std::sqrt(8 * kRadius_mm * tolerance);
  const double time = rows * 21.5 / 25 + count * 0.004 + 38 - 12 * allowance;
  const double uncut = cusp + 0.6 * tolerance + 0.05 * std::max(0.0, allowance - 0.2);
  const double gouge = 0.9 * tolerance + 0.4e-3 / step * 0.2;
  const double width = 1.4e-3;
  return {time,
          uncut + width / 2,
          gouge + width / 2,
          uncut - width / 2,
          std::max(0.0, gouge - width / 2),
          std::clamp(1.02 - uncut, 0.0, 1.0),
          std::floor(count)};
}

void judge(study::Row& row) {
  const double uncut = *row.figures[uncut_high], gouge = *row.figures[gouge_high];
  row.status = Status::pass;
  if (std::max(*row.figures[uncut_low], *row.figures[gouge_low]) > kGate_mm) {
    row.status = Status::fail;
    row.reason = *row.figures[uncut_low] > kGate_mm
                     ? "finish: uncut is beyond its limit of 0.03 mm"
                     : "finish: gouge is beyond its limit of 0.03 mm";
  } else if (std::max(uncut, gouge) > kGate_mm) {
    row.status = Status::indeterminate;
    row.reason = "finish: the limit of 0.03 mm lies within the certified interval";
  }
}

study::Row row_of(std::size_t index, double step, double tolerance, double allowance) {
  study::Row row;
  row.asked = {index, {number(step), number(tolerance), number(allowance)}};
  row.key = std::string(60, "0123456789abcdef"[index % 16]) + "00ff";
  row.figures = measured(step, tolerance, allowance);
  row.reused = index % 4 == 0;
  row.attempts = row.reused ? 0 : 1;
  row.seconds = row.reused ? 0 : 2.5;
  judge(row);
  return row;
}

void lose(study::Row& row, Status status, const std::string& reason, unsigned attempts) {
  row.status = status;
  row.reason = reason;
  row.attempts = attempts;
  std::fill(row.figures.begin(), row.figures.end(), std::nullopt);
}

std::vector<double> steps_of(std::size_t count) {
  if (count == 5) return {0.2, 0.3, 0.4, 0.6, 0.8};
  std::vector<double> steps;
  for (std::size_t i = 0; i < count; ++i) steps.push_back(0.1 + 0.001 * double(i));
  return steps;
}

study::Variable variable(const std::string& key, const std::vector<double>& values) {
  study::Variable out{key, {}, {}, {}};
  for (const double value : values) out.values.push_back(number(value));
  return out;
}

}  // namespace

SampleStudy sample_study_of(std::size_t count) {
  SampleStudy sample;
  const std::vector<double> steps = steps_of(count), tolerances = {0.002, 0.005, 0.01, 0.02},
                            allowances = {0.2, 0.3, 0.5};
  sample.plan.name = sample.table.name = "dome: step-over, tolerance and allowance";
  sample.plan.job = "/nowhere/quick-dome.toml";
  sample.plan.job_as_stated = sample.table.job = "quick-dome.toml";
  sample.plan.variables = {variable("stage.finish.step", steps),
                           variable("stage.finish.tolerance", tolerances),
                           variable("stage.rough.allowance", allowances)};
  for (const study::Variable& v : sample.plan.variables) sample.table.keys.push_back(v.key);
  sample.table.figures = figures();
  for (const double step : steps)
    for (const double tolerance : tolerances)
      for (const double allowance : allowances)
        sample.table.rows.push_back(row_of(sample.table.rows.size(), step, tolerance, allowance));
  lose(sample.table.rows[7], Status::error,
       "quick-dome.toml:52:13: error: allowance 0.3 is more than the stock holds; less than 0.25",
       1);
  lose(sample.table.rows[20], Status::lost, "the process was ended by signal 9 (killed)", 3);
  sample.about = {
      "0.1.0", "2026-11-22T01:40:00Z", "local", 148.2, {number(0.3), number(0.01), number(0.3)}};
  for (std::size_t i = 0; i < 3; ++i) sample.plan.variables[i].base = sample.about.own[i];
  sample.analysis = study::analyse(sample.plan, sample.table);
  return sample;
}

SampleStudy sample_study() {
  return sample_study_of(5);
}

SampleStudy hostile_study() {
  const std::string markup = "</script><img src=x onerror=window.hostile=1>\"'&{a|b}";
  SampleStudy sample = sample_study();
  study::Table& table = sample.table;
  sample.plan.method = study::Method::list;
  sample.plan.name = table.name = "=HYPERLINK(\"x\")" + markup;
  sample.plan.job_as_stated = table.job = "it's " + markup + ".toml";
  table.keys[0] = "@key" + markup;
  table.keys[1] = "-key\xff";
  table.figures[1].label = markup;
  table.figures[1].unit = "<b>";
  table.figures[0].id = "+machining" + markup;
  table.rows.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    study::Row& row = table.rows[i];
    row.asked.settings[0] = {"\"=cmd|' /C calc'!A" + std::to_string(i) + markup + "\"", {}};
    row.asked.settings[1] = {"-0.5", -0.5};
    row.asked.settings[2] = {"\"=1+1\"", {}};
    row.status = i == 0 ? Status::fail : i == 1 ? Status::indeterminate : Status::error;
    row.reason = "\t-1+" + markup + "\r\nsecond \x01 line";
  }
  table.rows[2].figures.assign(table.figures.size(), std::nullopt);
  sample.plan.variables[0] = {table.keys[0], {table.rows[0].asked.settings[0]}, {}, {}};
  sample.analysis = {};
  sample.analysis.fronts = {{{table.figures[0].id, table.figures[1].id}, {0}}};
  sample.analysis.recommendation.reason = "Nothing passes: " + markup;
  sample.about.created = sample.about.engine = markup;
  sample.about.own = table.rows[0].asked.settings;
  return sample;
}

SampleStudy failed_study() {
  SampleStudy sample = sample_study();
  for (study::Row& row : sample.table.rows) {
    if (row.status != Status::pass && row.status != Status::indeterminate) continue;
    if (row.asked.index % 3 == 0) {
      lose(row, Status::lost, "the process was ended by signal 9 (killed)", 3);
    } else {
      row.status = Status::fail;
      row.reason = "finish: gouge is beyond its limit of 0.001 mm";
    }
  }
  sample.analysis = study::analyse(sample.plan, sample.table);
  return sample;
}

SampleStudy single_study() {
  SampleStudy sample = sample_study();
  sample.plan.method = study::Method::list;
  sample.table.rows.resize(1);
  sample.analysis = study::analyse(sample.plan, sample.table);
  sample.about = {};
  return sample;
}

}  // namespace limitgauge::reports
