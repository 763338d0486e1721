#include <algorithm>
#include <set>
#include <sstream>

#include "model/text/rounded.h"
#include "reports/run/finding_list.h"
#include "reports/run/gate_figures.h"
#include "reports/run/process.h"
#include "reports/run/program_lines.h"
#include "reports/run/report.h"
#include "reports/text/terminal_table.h"
#include "reports/text/text.h"
#include "verifier/gate/verify.h"

namespace limitgauge::reports {
namespace {

constexpr std::size_t kGougeColumn = 4, kUncutColumn = 5;

const char* relation(Standing standing) {
  switch (standing) {
    case Standing::within:
      return " ≤ ";
    case Standing::beyond:
      return " > ";
    default:
      return " ? ";
  }
}

/// "[0.076, 0.41] ≤ 10 µm": what is proven, how it stands, and the limit.
std::string with_its_limit(const GateFigure& figure) {
  if (figure.standing == Standing::not_run) return "–";
  if (figure.limit.empty()) return figure.measured;
  const std::string numbers = figure.measured.substr(0, figure.measured.rfind(' '));
  return numbers + relation(figure.standing) + figure.limit;
}

Tone tone_of(verifier::Verdict verdict) {
  switch (verdict) {
    case verifier::Verdict::pass:
      return Tone::good;
    case verifier::Verdict::fail:
      return Tone::bad;
    case verifier::Verdict::indeterminate:
      return Tone::doubtful;
    case verifier::Verdict::not_run:
      break;
  }
  return Tone::faint;
}

std::vector<TerminalTable::Cell> row_of(const StageResult& stage) {
  const std::vector<GateFigure> figures = gate_figures(stage);
  return {{stage.name},
          {stage.tool},
          {stage.program.empty() ? stage.strategy : stage.program},
          {verdict_text(stage.verdict()), tone_of(stage.verdict())},
          {with_its_limit(figures[0])},
          {with_its_limit(figures[1])},
          {stage.ran ? figures[2].measured : "–"}};
}

std::vector<TerminalTable::Cell> cut_row_of(const StageResult& stage) {
  const auto ran = [&](const std::string& text) {
    return TerminalTable::Cell{stage.ran ? text : "–"};
  };
  return {{stage.name},
          {stage.tool},
          {stage.program},
          {verdict_text(stage.verdict()), tone_of(stage.verdict())},
          ran(stage.ran ? grouped(faults(stage.ran->process)) : ""),
          ran(stage.ran ? three_digits(stage.ran->removed_volume_mm3 / 1000) + " cm³" : "")};
}

TerminalTable cut_table_of(const RunResult& result) {
  constexpr TerminalTable::Column kName = {false, true}, kText, kNumber = {true};
  TerminalTable table({kName, kName, kName, kText, kNumber, kNumber});
  table.add_row({{"stage"}, {"tool"}, {"program"}, {"verdict"}, {"faults"}, {"removed"}});
  for (const StageResult& stage : result.stages) table.add_row(cut_row_of(stage));
  return table;
}

/// The names give way on a narrow terminal.
TerminalTable table_of(const RunResult& result) {
  if (!result.surface) return cut_table_of(result);
  constexpr TerminalTable::Column kName = {false, true}, kText, kNumber = {true};
  TerminalTable table({kName, kName, kName, kText, kText, kText, kNumber});
  table.add_row(
      {{"stage"}, {"tool"}, {"strategy"}, {"verdict"}, {"gouge"}, {"uncut"}, {"coverage"}});
  for (const StageResult& stage : result.stages) table.add_row(row_of(stage));
  return table;
}

/// `text` broken at spaces so that no line is longer than `width`; later lines are indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::istringstream words(text);
  std::string out, word;
  std::size_t at = 0;
  while (words >> word) {
    const std::size_t length = code_points(word);
    if (at > indent && at + 1 + length > width) {
      out += '\n' + std::string(indent, ' ');
      at = indent;
    } else if (at > 0) {
      out += ' ';
      ++at;
    }
    out += word;
    at += length;
  }
  return out + '\n';
}

/// What the program says at the worst place of each kind that fails its stage or may: "part.ngc:23:
/// G0 X10".
std::vector<std::string> lines_to_blame(const RunResult& result, std::size_t index) {
  std::vector<std::string> out;
  std::set<std::string> told;
  for (const ListedFinding& f : list_findings(result, index)) {
    const bool counts =
        f.significance == Significance::fails || f.significance == Significance::undecided;
    if (!counts || f.line == 0 || !told.insert(f.kind).second) continue;
    const StageResult& made = result.stages[f.program_stage];
    if (!made.ran || !made.ran->program_text) continue;
    for (const ProgramLine& line : program_lines(*made.ran->program_text, {{f.line}}, 0)) {
      const std::string text =
          program_file(made) + ":" + std::to_string(line.line) + ": " + line.text;
      if (std::find(out.begin(), out.end(), text) == out.end()) out.push_back(text);
    }
  }
  return out;
}

/// Why a stage does not pass, and the lines of the program that it is about.
std::string why_not(const RunResult& result, std::size_t index, std::size_t width) {
  const StageResult& stage = result.stages[index];
  if (stage.verdict() == verifier::Verdict::pass) return {};
  const std::string begin = clean_text(stage.name) + ": ";
  std::string out;
  for (const std::string& reason : stage.decision.reasons)
    if (!is_note(reason) && !verifier::tells_a_pass(reason))
      out += wrapped(begin + clean_text(reason), 4, width);
  for (const std::string& line : lines_to_blame(result, index))
    out += wrapped(begin + clean_text(line), 4, width);
  return out;
}

/// Of a stage that passes: how far its tolerances could grow, and what ends that first.
std::string margin_line(const StageResult& stage, std::size_t width) {
  if (stage.verdict() != verifier::Verdict::pass || !stage.ran || !stage.ran->deviation) return {};
  const auto& robust = stage.ran->deviation->robust;
  const verifier::RobustFigure* least = robust ? verifier::least_margin(*robust) : nullptr;
  if (!least || !least->margin->proven) return {};
  const double factor = *least->margin->proven;
  const std::string times = model::factor_text(factor, model::Rounding::down);
  return wrapped(clean_text(stage.name) + ": passes with tolerances up to " + times +
                     " times as wide (" + (least == &robust->gouge ? "gouge" : "uncut") + ")",
                 4, width);
}

/// "machining time 5 min 10 s (rough 3 min, finish 2 min 10 s)".
std::string time_text(const RunResult& result, const char* name,
                      double (*seconds)(const StageResult&)) {
  double all_s = 0;
  std::string parts;
  std::size_t ran = 0;
  for (const StageResult& stage : result.stages) {
    if (!stage.ran) continue;
    all_s += seconds(stage);
    parts += (ran++ > 0 ? ", " : "") + clean_text(stage.name) + ' ' + duration_text(seconds(stage));
  }
  return name + duration_text(all_s) + (ran > 1 ? " (" + parts + ")" : "");
}

std::string times_of(const RunResult& result, std::size_t width) {
  const auto machining = [](const StageResult& s) { return s.ran->machining_time_s; };
  const auto computing = [](const StageResult& s) { return s.seconds; };
  return wrapped(time_text(result, "machining time ", machining), 4, width) +
         wrapped(time_text(result, "computing time ", computing), 4, width);
}

}  // namespace

std::string verdict_table(const RunResult& result, bool colour, std::size_t width) {
  TerminalTable table = table_of(result);
  table.fit(width);
  const bool narrow = result.surface && table.width() > width;
  if (narrow) {
    // The intervals stand on a line of their own below their stage.
    table.hide(kGougeColumn);
    table.hide(kUncutColumn);
    table.fit(width);
  }
  std::string out = table.line(0, colour);
  for (std::size_t i = 0; i < result.stages.size(); ++i) {
    out += table.line(i + 1, colour);
    if (!narrow || !result.stages[i].ran) continue;
    const std::vector<GateFigure> figures = gate_figures(result.stages[i]);
    out +=
        "  gouge " + with_its_limit(figures[0]) + "   uncut " + with_its_limit(figures[1]) + '\n';
  }
  for (const StageResult& stage : result.stages)
    for (const std::string& note : stage_notes(stage))
      out += wrapped(clean_text(stage.name) + ": " + note, 4, width);
  for (const StageResult& stage : result.stages) out += margin_line(stage, width);
  for (std::size_t i = 0; i < result.stages.size(); ++i) out += why_not(result, i, width);
  out += times_of(result, width);
  if (!result.surface) out += wrapped("nothing was measured against a design", 0, width);
  return out +
         "verdict: " + painted(verdict_text(result.verdict), tone_of(result.verdict), colour) +
         '\n';
}

}  // namespace limitgauge::reports
