#include <algorithm>
#include <cctype>
#include <ostream>

#include "reports/compare/comparison_text.h"
#include "reports/compare/report.h"
#include "reports/text/text.h"

namespace limitgauge::reports::compare {
namespace {

/// A comment on a change is read on the way: no more of a stage than this.
constexpr std::size_t kMostInComment = 10;
constexpr std::size_t kMostRemarks = 20;
constexpr std::size_t kLongestText = 200;

/// Within a line, and without brackets or a colon beside them, these mean nothing.
constexpr std::string_view kHarmless = ".,-()";

/// `text` as Markdown shows it letter by letter: nothing in it is a link, a mention, markup, or the
/// end of a table's cell.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : shortened(clean_text(text), kLongestText)) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\n' || c == '\t') {
      out += ' ';
    } else if (std::ispunct(byte) != 0 && kHarmless.find(c) == std::string_view::npos) {
      // An entity ends no cell and calls nobody, which a backslash before "|" or "@" may.
      out += "&#" + std::to_string(byte) + ";";
    } else {
      out += c;
    }
  }
  return out;
}

const char* mark(Judgement judgement) {
  switch (judgement) {
    case Judgement::better:
      return "▲ better";
    case Judgement::worse:
      return "▼ **worse**";
    case Judgement::same:
      return "= same";
    case Judgement::not_judged:
      break;
  }
  return "· not judged";
}

/// Figures that moved, and the certified ones of a stage in which one did.
bool is_shown(const FigureChange& figure) {
  return figure.judgement == Judgement::better || figure.judgement == Judgement::worse ||
         (figure.metric->id == "machining_time_s" &&
          std::abs(figure.now.high - figure.base.high) > 1e-3 * figure.base.high);
}

void write_figures(const Comparison& comparison, std::ostream& out) {
  bool has_head = false;
  for (const StageComparison& stage : comparison.stages) {
    for (const FigureChange& figure : stage.figures) {
      if (!is_shown(figure)) continue;
      if (!has_head)
        out << "\n| stage | figure | " << escaped(base_title(comparison)) << " | "
            << escaped(new_title(comparison))
            << " | change | floor | |\n"
               "|---|---|--:|--:|--:|--:|---|\n";
      has_head = true;
      const FigureText text = figure_text(figure);
      out << "| " << escaped(stage.name) << " | " << figure.metric->label << " | " << text.base
          << " | " << text.now << " | " << text.change << " | " << text.floor << " | "
          << mark(figure.judgement) << " |\n";
    }
  }
}

std::string place_text(const FoundPlace& place, const std::string& stage) {
  return escaped(line_text(place, stage)) + at_text(place);
}

void write_findings(const StageComparison& stage, std::ostream& out) {
  for (const FigureChange& figure : stage.figures)
    if (figure.where && figure.judgement == Judgement::worse)
      out << "- " << escaped(stage.name) << ": deepest " << figure.metric->label << " "
          << measured_length(figure.where->depth_mm) << ", "
          << place_text(*figure.where, stage.name) << "\n";
  const std::size_t shown = std::min(stage.findings.size(), kMostInComment);
  for (std::size_t i = 0; i < shown; ++i) {
    const FindingChange& change = stage.findings[i];
    out << "- " << escaped(stage.name) << ": " << name(change) << " "
        << escaped(kind_text(change.kind)) << " " << depth_text(change) << ", "
        << place_text(change.now ? *change.now : *change.base, stage.name) << " ("
        << name(change.judgement) << ")\n";
  }
  if (stage.findings.size() > shown)
    out << "- " << escaped(stage.name) << ": and " << grouped(stage.findings.size() - shown)
        << " more findings that changed\n";
}

void write_remarks(const std::string& prefix, const std::vector<Remark>& remarks,
                   std::ostream& out) {
  const std::size_t shown = std::min(remarks.size(), kMostRemarks);
  for (std::size_t i = 0; i < shown; ++i) {
    out << "- " << prefix << escaped(remarks[i].text);
    if (remarks[i].judgement != Judgement::not_judged) out << ": " << mark(remarks[i].judgement);
    out << "\n";
  }
  if (remarks.size() > shown) out << "- and " << remarks.size() - shown << " more\n";
}

}  // namespace

void write_markdown(const Comparison& comparison, std::ostream& out) {
  out << "### Limitgauge: " << escaped(comparison.now.job) << " – " << summary(comparison)
      << "\n\nVerdict: " << verdict_text(comparison.base.verdict) << " before, now **"
      << verdict_text(comparison.now.verdict) << "**.\n";
  write_figures(comparison, out);
  out << "\n";
  write_remarks("", comparison.remarks, out);
  for (const StageComparison& stage : comparison.stages) {
    write_remarks(escaped(stage.name) + ": ", stage.remarks, out);
    write_findings(stage, out);
  }
}

}  // namespace limitgauge::reports::compare
