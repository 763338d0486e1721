#include <fmt/format.h>

#include <cmath>

#include "reports/html/markup.h"
#include "reports/study/figure_column.h"
#include "reports/study/parts.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
namespace {

std::string code(std::string_view text) {
  return "<code>" + escape_markup(text) + "</code>";
}

/// What the job itself has, beside what is recommended; nothing where both are the same.
std::string instead_of(const std::string& own, const std::string& taken) {
  return own.empty() || own == taken ? std::string() : "<small>job: " + own + "</small>";
}

std::string settings_card(const StudyView& view, const study::Row& row) {
  const auto& own = view.about.own;
  std::string list;
  for (std::size_t i = 0; i < view.table.keys.size(); ++i) {
    const std::string taken = code(setting_text(row.asked.settings.at(i)));
    list +=
        fmt::format("<div><dt>{}</dt><dd>{}{}</dd></div>", escape_markup(view.table.keys[i]), taken,
                    instead_of(i < own.size() ? code(setting_text(own[i])) : std::string(), taken));
  }
  return "<div class=\"worst\"><p class=\"what\">Settings</p><dl class=\"study-list\">" + list +
         "</dl></div>\n";
}

/// "−12.3 %", from what the job's own setting gives; nothing below a thousandth.
std::string change(double from, double to) {
  if (from == 0 || std::abs(to / from - 1) < 5e-4) return {};
  const double percent = 100 * (to / from - 1);
  return fmt::format("<small>{}{} % against the job</small>", percent > 0 ? "+" : "",
                     html::typeset(fixed(percent, std::abs(percent) < 10 ? 1 : 0)));
}

std::string figures_card(const StudyView& view, const study::Row& row) {
  const std::optional<std::size_t> own = own_row(view);
  std::string list;
  for (const std::size_t i : objectives(view)) {
    const std::optional<double>& value = row.figures.at(i);
    if (!value) continue;
    const auto before = own ? view.table.rows[*own].figures.at(i) : std::nullopt;
    list += fmt::format("<div><dt>{}</dt><dd>{}{}</dd></div>",
                        escape_markup(view.table.figures[i].label),
                        FigureColumn(view.table, i).value(*value),
                        before ? change(*before, *value) : std::string());
  }
  if (list.empty()) return {};
  return "<div class=\"worst\"><p class=\"what\">What it gives</p><dl class=\"study-list\">" +
         list + "</dl></div>\n";
}

/// As a POSIX shell reads it.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'')
      out += "'\\''";
    else
      out += c;
  }
  return out + "'";
}

std::string command(const StudyView& view, const study::Row& row) {
  const std::string& path = view.about.job_path;
  std::string line = "limitgauge run " + quoted(path.empty() ? view.table.job : path);
  for (std::size_t i = 0; i < view.table.keys.size(); ++i)
    line += " \\\n  --set " + quoted(view.table.keys[i] + "=" + row.asked.settings.at(i).toml);
  return "<p class=\"study-command\">" + code(line) + "</p>\n";
}

std::string taken_row(const StudyView& view, const study::Row& row) {
  const std::size_t number = row.asked.index;
  const bool is_own = own_row(view) == view.analysis.recommendation.row;
  return fmt::format(
      "<div class=\"verdict {}\"><p class=\"word\">Take case <a href=\"{}\">{}</a> {}</p>"
      "<p>{}{}</p>\n<div class=\"cards\">{}{}</div>\n{}</div>\n",
      css_class(row.status), result_path(number), number, badge(row.status),
      escape_markup(view.analysis.recommendation.reason),
      is_own ? " It is what the job itself states." : "", settings_card(view, row),
      figures_card(view, row), command(view, row));
}

std::string recommendation(const StudyView& view) {
  const study::Recommendation& taken = view.analysis.recommendation;
  if (taken.row) return taken_row(view, view.table.rows.at(*taken.row));
  return fmt::format(
      "<div class=\"verdict {}\"><p class=\"word\">No setting to recommend</p><p>{}</p></div>\n",
      count(view.table, study::Status::fail) > 0 ? "fail" : "open", escape_markup(taken.reason));
}

std::string counts(const study::Table& table) {
  std::string out = fmt::format("<p class=\"study-counts\"><strong>{} case{}</strong>",
                                grouped(table.rows.size()), table.rows.size() == 1 ? "" : "s");
  for (const study::Status status : kStatuses)
    if (const std::size_t n = count(table, status))
      out += fmt::format(" <span class=\"part\">{} {}</span>", grouped(n), badge(status));
  return out + "</p>\n";
}

std::string effort(const StudyView& view) {
  std::size_t reused = 0;
  for (const study::Row& row : view.table.rows) reused += row.reused ? 1 : 0;
  std::string out = fmt::format("{} run, {} taken from the store",
                                grouped(view.table.rows.size() - reused), grouped(reused));
  if (view.about.seconds > 0) out += ", in " + duration_text(view.about.seconds);
  if (!view.about.engine.empty()) out += ", engine " + escape_markup(view.about.engine);
  return out;
}

}  // namespace

std::string masthead(const StudyView& view) {
  const study::Table& table = view.table;
  std::vector<html::Term> list = {{"Job", escape_markup(table.job)}, {"Effort", effort(view)}};
  if (!view.about.created.empty()) list.push_back({"Created", escape_markup(view.about.created)});
  if (!view.about.version.empty())
    list.push_back({"Program version", "limitgauge " + escape_markup(view.about.version)});
  return fmt::format("<header><p class=\"kind\">Limitgauge · study of settings</p><h1>{}</h1>\n",
                     escape_markup(table.name)) +
         recommendation(view) + counts(table) + html::terms(list) + "</header>\n";
}

}  // namespace limitgauge::reports::study_report
