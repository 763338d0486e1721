#include "reports/html/markup.h"

#include <fmt/format.h>

#include "reports/base64.h"
#include "reports/text.h"

namespace limitgauge::reports::html {
namespace {

struct Look {
  const char* css;
  const char* sign;
  const char* word;
};

std::string badge_of(const Look& look) {
  return fmt::format("<span class=\"badge {}\"><span aria-hidden=\"true\">{}</span> {}</span>",
                     look.css, look.sign, look.word);
}

Look look_of(verifier::Verdict verdict) {
  switch (verdict) {
    case verifier::Verdict::pass:
      return {"pass", "✓", "Passed"};
    case verifier::Verdict::fail:
      return {"fail", "✕", "Failed"};
    case verifier::Verdict::indeterminate:
      return {"open", "?", "Undecided"};
    case verifier::Verdict::not_run:
      break;
  }
  return {"none", "–", "Not run"};
}

Look look_of(Standing standing) {
  switch (standing) {
    case Standing::within:
      return {"pass", "✓", "within"};
    case Standing::beyond:
      return {"fail", "✕", "beyond"};
    case Standing::undecided:
      return {"open", "?", "undecided"};
    case Standing::no_limit:
      return {"none", "–", "no limit"};
    case Standing::not_run:
      break;
  }
  return {"none", "–", "not run"};
}

}  // namespace

std::string table(std::string_view caption, const std::vector<Column>& columns,
                  const std::vector<std::vector<std::string>>& rows) {
  std::string out = "<div class=\"scroll\"><table>";
  if (!caption.empty()) out += fmt::format("<caption>{}</caption>", caption);
  out += "<thead><tr>";
  for (const Column& c : columns)
    out += fmt::format("<th scope=\"col\"{}>{}</th>", c.is_number ? " class=\"num\"" : "", c.title);
  out += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < columns.size(); ++i)
      out += fmt::format("<td data-label=\"{}\" class=\"{}{}\"><div>{}</div></td>",
                         columns[i].title, columns[i].is_number ? "num" : "word",
                         row.at(i).empty() ? " blank" : "", row.at(i));
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string terms(const std::vector<Term>& list) {
  std::string out = "<dl>";
  for (const Term& t : list)
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", t.name, t.value);
  return out + "</dl>\n";
}

std::string badge(verifier::Verdict verdict) {
  return badge_of(look_of(verdict));
}
std::string badge(Standing standing) {
  return badge_of(look_of(standing));
}
const char* word(verifier::Verdict verdict) {
  return look_of(verdict).word;
}
const char* css_class(verifier::Verdict verdict) {
  return look_of(verdict).css;
}

std::string typeset(const std::string& number) {
  const std::size_t exponent = number.find("e-");
  std::string out;
  for (const char c : number.substr(0, exponent)) {
    if (c == '-') {
      out += "−";
    } else {
      out += c;
    }
  }
  if (exponent == std::string::npos) return out;
  return fmt::format("{} × 10<sup>−{}</sup>", out, std::stoi(number.substr(exponent + 2)));
}

std::string coordinates(const model::Vec3& p) {
  return fmt::format("<span class=\"xyz\">{}, {}, {}</span>", typeset(fixed(p.x, 3)),
                     typeset(fixed(p.y, 3)), typeset(fixed(p.z, 3)));
}

std::string png_uri(std::string_view bytes) {
  return "data:image/png;base64," + base64(bytes);
}

}  // namespace limitgauge::reports::html
