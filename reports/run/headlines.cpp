#include "reports/run/headlines.h"

#include <algorithm>

#include "reports/run/gate_figures.h"
#include "reports/run/process.h"
#include "verifier/gate/verify.h"

namespace limitgauge::reports {
namespace {

/// What it is called that this figure is beyond its limit; nothing for counts of the process, whose
/// kinds have names of their own.
std::string beyond_words(const GateFigure& figure, bool nothing_reached) {
  if (figure.name == "gouge") return "gouged beyond the limit";
  if (figure.name == "uncut") return "material left beyond the limit";
  if (figure.name == "coverage") return "coverage too small";
  if (figure.name == "unreachable")
    return nothing_reached ? "nothing is in reach of any cutter" : "more out of reach than allowed";
  if (figure.name == "unavoidable uncut") return "more must stay than allowed";
  if (figure.name == "missing stock") return "raw stock is missing";
  return {};
}

void add_figures(const StageResult& stage, std::vector<std::string>& beyond, std::string& open) {
  const bool nothing_reached =
      judge_any_reach(*stage.ran->deviation, stage.limits) == verifier::Verdict::fail;
  for (const GateFigure& figure : gate_figures(stage)) {
    if (figure.standing == Standing::undecided) open += (open.empty() ? "" : ", ") + figure.name;
    if (figure.standing != Standing::beyond) continue;
    if (std::string words = beyond_words(figure, nothing_reached); !words.empty())
      beyond.push_back(std::move(words));
  }
}

}  // namespace

std::vector<std::string> headlines(const StageResult& stage) {
  if (!stage.ran) return {"not run"};
  std::vector<std::string> out;
  std::string open;
  if (stage.ran->deviation) add_figures(stage, out, open);
  for (const simulator::FindingKind kind : kFindingKinds)
    if (fails(kind) && count(stage.ran->process, {kind}) > 0) out.emplace_back(description(kind));
  if (!open.empty()) out.push_back("undecided: " + open);
  return out;
}

}  // namespace limitgauge::reports
