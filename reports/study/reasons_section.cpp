#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "reports/html/markup.h"
#include "reports/study/figure_column.h"
#include "reports/study/parts.h"
#include "reports/text/text.h"

namespace limitgauge::reports::study_report {
namespace {

using study::Status;

constexpr std::size_t kMostReasons = 50, kMostNumbers = 12;

struct Group {
  Status status;
  std::string reason;
  std::vector<std::size_t> cases;
};

/// What ended cases before a verdict comes first: it is what somebody must look into.
constexpr std::array<Status, 4> kOrder = {Status::lost, Status::error, Status::indeterminate,
                                          Status::fail};

std::vector<Group> groups(const study::Table& table) {
  std::vector<Group> list;
  std::map<std::pair<Status, std::string_view>, std::size_t> at;
  for (const study::Row& row : table.rows) {
    if (row.status == Status::pass) continue;
    const auto [found, is_new] = at.try_emplace({row.status, row.reason}, list.size());
    if (is_new) list.push_back({row.status, row.reason, {}});
    list[found->second].cases.push_back(row.asked.index);
  }
  std::stable_sort(list.begin(), list.end(), [](const Group& a, const Group& b) {
    const auto place = [](Status s) { return std::find(kOrder.begin(), kOrder.end(), s); };
    if (a.status != b.status) return place(a.status) < place(b.status);
    return a.cases.size() > b.cases.size();
  });
  return list;
}

std::string numbers(const Group& group) {
  std::string out;
  const bool linked = group.status == Status::fail || group.status == Status::indeterminate;
  for (std::size_t i = 0; i < std::min(group.cases.size(), kMostNumbers); ++i) {
    if (i > 0) out += ", ";
    out += linked
               ? fmt::format("<a href=\"{}\">{}</a>", result_path(group.cases[i]), group.cases[i])
               : std::to_string(group.cases[i]);
  }
  if (group.cases.size() > kMostNumbers)
    out += fmt::format(" and {} more", grouped(group.cases.size() - kMostNumbers));
  return out;
}

std::vector<std::string> line(const Group& group) {
  return {badge(group.status),
          group.reason.empty() ? "no reason stated" : escape_markup(group.reason),
          grouped(group.cases.size()), numbers(group)};
}

}  // namespace

std::string reasons_section(const StudyView& view) {
  const std::vector<Group> list = groups(view.table);
  std::string body = "<p>Every case passed.</p>\n";
  if (view.table.rows.empty()) body = "<p>There is no case.</p>\n";
  if (!list.empty()) {
    std::vector<std::vector<std::string>> lines;
    for (std::size_t i = 0; i < std::min(list.size(), kMostReasons); ++i)
      lines.push_back(line(list[i]));
    const std::string caption =
        list.size() > kMostReasons ? fmt::format("The first {} of {} reasons; all are in study.csv",
                                                 kMostReasons, grouped(list.size()))
                                   : "Each reason once, with its cases";
    body = html::table(
        caption, {{"Verdict", false}, {"Reason", false}, {"cases", true}, {"which", false}}, lines);
  }
  return "<section id=\"reasons\"><h2>What did not pass</h2>\n" + body + "</section>\n";
}

}  // namespace limitgauge::reports::study_report
