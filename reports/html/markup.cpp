#include "reports/html/markup.h"

#include <fmt/format.h>

#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

struct Look {
  const char* css;
  const char* sign;
  const char* word;
};

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

std::string cell(const Column& column, const std::string& content) {
  return fmt::format("<td role=\"cell\" data-label=\"{}\" class=\"{}{}\"><div>{}</div></td>",
                     column.title, column.is_number ? "num" : "word",
                     content.empty() || content == "–" ? " blank" : "", content);
}

}  // namespace

std::string table(std::string_view caption, const std::vector<Column>& columns,
                  const std::vector<Row>& rows) {
  // Roles are stated because a narrow page lays rows out as blocks, which would end their meaning.
  std::string out = fmt::format(
      "<div class=\"scroll\"><table role=\"table\">"
      "<caption>{}</caption><thead role=\"rowgroup\"><tr role=\"row\">",
      caption);
  for (const Column& c : columns)
    out += fmt::format("<th scope=\"col\" role=\"columnheader\"{}>{}</th>",
                       c.is_number ? " class=\"num\"" : "", c.title);
  out += "</tr></thead><tbody role=\"rowgroup\">\n";
  for (const Row& row : rows) {
    out += fmt::format("<tr role=\"row\"{}>", row.attributes);
    for (std::size_t i = 0; i < columns.size(); ++i) out += cell(columns[i], row.cells.at(i));
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string table(std::string_view caption, const std::vector<Column>& columns,
                  const std::vector<std::vector<std::string>>& rows) {
  std::vector<Row> plain;
  for (const std::vector<std::string>& cells : rows) plain.push_back({cells, {}});
  return table(caption, columns, plain);
}

std::string terms(const std::vector<Term>& list) {
  std::string out = "<dl>";
  for (const Term& t : list)
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", t.name, t.value);
  return out + "</dl>\n";
}

std::string fold(std::string_view css, std::string_view summary, std::string_view body, bool open) {
  return fmt::format("<details class=\"{}\"{}><summary>{}</summary>\n{}</details>\n", css,
                     open ? " open=\"\"" : "", summary, body);
}

std::string badge(std::string_view css, std::string_view sign, std::string_view word) {
  return fmt::format("<span class=\"badge {}\"><span aria-hidden=\"true\">{}</span> {}</span>", css,
                     sign, word);
}
std::string badge(verifier::Verdict verdict) {
  const Look look = look_of(verdict);
  return badge(look.css, look.sign, look.word);
}
std::string badge(Standing standing) {
  const Look look = look_of(standing);
  return badge(look.css, look.sign, look.word);
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
  std::size_t digits = 0;
  const int power = std::stoi(number.substr(exponent + 2), &digits);
  return fmt::format("{} × 10<sup>−{}</sup>{}", out, power, number.substr(exponent + 2 + digits));
}

std::string coordinates(const model::Vec3& p) {
  return fmt::format("<span class=\"xyz\">{}, {}, {}</span>", typeset(fixed(p.x, 3)),
                     typeset(fixed(p.y, 3)), typeset(fixed(p.z, 3)));
}

std::string png_uri(std::string_view bytes) {
  return "data:image/png;base64," + base64(bytes);
}

std::string stage_anchor(std::size_t stage) {
  return "stage-" + std::to_string(stage + 1);
}

std::string finding_anchor(std::size_t stage, const std::string& finding) {
  return stage_anchor(stage) + "-" + finding;
}

std::string line_anchor(std::size_t stage, std::size_t program_stage, std::uint32_t line) {
  return fmt::format("{}-program-{}-line-{}", stage_anchor(stage), program_stage + 1, line);
}

std::string finding_attributes(std::size_t stage, const std::string& finding) {
  return fmt::format(" id=\"{}\" data-finding=\"{}:{}\"", finding_anchor(stage, finding), stage,
                     finding);
}

std::string finding_link(std::size_t stage, const std::string& finding, const std::string& text) {
  return fmt::format("<a href=\"#{}\" data-finding=\"{}:{}\">{}</a>",
                     finding_anchor(stage, finding), stage, finding, text);
}

}  // namespace limitgauge::reports::html
