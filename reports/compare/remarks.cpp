#include "reports/compare/run_comparison.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/compare/comparison_text.h"
#include "reports/text/text.h"

namespace limitgauge::reports::compare {
namespace {

using verifier::Verdict;

int rank(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return 0;
    case Verdict::indeterminate:
      return 1;
    case Verdict::fail:
      return 2;
    default:
      return 3;
  }
}

/// What explains a change, and is not judged.
void name(std::vector<Remark>& out, const std::string& id, const std::string& text) {
  out.push_back({id, Judgement::not_judged, text});
}

void name_lack(std::vector<Remark>& out, const std::string& id, const std::string& what, bool base,
               bool now) {
  if (!base && !now) return;
  const char* who = base && now ? " (both runs)" : base ? " (base run)" : " (new run)";
  name(out, id, what + who);
}

std::string moves_text(std::size_t count) {
  return grouped(count) + (count == 1 ? " move" : " moves");
}

}  // namespace

void name_change(std::vector<Remark>& out, const std::string& id, const std::string& what,
                 const std::string& base, const std::string& now) {
  if (base != now) name(out, id, what + " was " + base + ", is " + now);
}

std::optional<Remark> compare_verdicts(const std::string& what, Verdict base, Verdict now) {
  if (base == now) return std::nullopt;
  return Remark{"verdict", rank(now) > rank(base) ? Judgement::worse : Judgement::better,
                what + " was " + verdict_text(base) + ", is " + verdict_text(now)};
}

std::vector<Remark> compare_settings(const record::StageRecord& base,
                                     const record::StageRecord& now, const Options& options) {
  std::vector<Remark> out;
  name_change(out, "tool", "tool", base.tool, now.tool);
  if (!base.cutter.empty() && !now.cutter.empty()) {
    name_change(out, "cutter", "cutter", base.cutter, now.cutter);
    for (Remark& remark : compare_descents(base.cutter, now.cutter, options))
      out.push_back(std::move(remark));
  }
  const auto way = [](const record::StageRecord& stage) {
    return stage.program.empty() ? stage.strategy : "program " + stage.program;
  };
  name_change(out, "strategy", "path", way(base), way(now));
  if (base.program.empty() && now.program.empty()) {
    name_change(out, "step", "step", stated_length(base.step_mm), stated_length(now.step_mm));
    name_change(out, "tolerance", "tolerance", stated_length(base.tolerance_mm),
                stated_length(now.tolerance_mm));
  }
  if (base.allowance_mm && now.allowance_mm && *base.allowance_mm != *now.allowance_mm)
    out.push_back({"allowance", Judgement::not_judged,
                   "allowance was " + stated_length(*base.allowance_mm) + ", is " +
                       stated_length(*now.allowance_mm) +
                       ": gouge and uncut are measured against another surface"});
  return out;
}

std::vector<Remark> compare_certificates(const record::DeviationMeasures& base,
                                         const record::DeviationMeasures& now) {
  std::vector<Remark> out;
  name_change(out, "resolution", "resolution", stated_length(base.resolution_mm),
              stated_length(now.resolution_mm));
  name_lack(out, "resolution", "resolution was not reached", !base.reached_resolution,
            !now.reached_resolution);
  const auto lacks = [](const record::DeviationMeasures& m) {
    return m.robust && !m.robust->reached_resolution;
  };
  name_lack(out, "resolution", "resolution was not reached over the tolerances", lacks(base),
            lacks(now));
  name_lack(out, "findings", "list of findings is not complete", !base.findings_complete,
            !now.findings_complete);
  return out;
}

namespace {

/// Empty where all is in reach.
std::string reach_text(const record::DeviationMeasures& m) {
  // By samples where there are no areas by proof.
  const double whole_mm2 = m.reach.reachable_mm2 + m.reach.unreachable_mm2 + m.reach.undecided_mm2;
  const double area_mm2 = whole_mm2 > 0 ? m.reach.unreachable_mm2 : m.unreachable_area_mm2;
  if (!(area_mm2 > 0)) return {};
  std::string text = three_digits(area_mm2) + " mm²";
  if (whole_mm2 > 0) text += " (" + three_digits(100 * area_mm2 / whole_mm2) + " %)";
  return text + ", unavoidable uncut up to " + measured_length(m.unavoidable_mm.high);
}

}  // namespace

std::optional<Remark> tell_reach(const record::DeviationMeasures& base,
                                 const record::DeviationMeasures& now) {
  const std::string was = reach_text(base), is = reach_text(now);
  if (was.empty() && is.empty()) return std::nullopt;
  const std::string said = is.empty() ? std::string("nothing") : is;
  return Remark{
      "reach", Judgement::not_judged,
      "unreachable: " + said + (was == is ? "" : "; before: " + (was.empty() ? "nothing" : was))};
}

std::vector<Remark> compare_process_counts(const record::StageMeasures& base,
                                           const record::StageMeasures& now,
                                           const Options& options) {
  std::map<std::string, std::pair<std::size_t, std::size_t>> counts;
  for (const record::ProcessCount& c : base.process) counts[c.kind].first = c.count;
  for (const record::ProcessCount& c : now.process) counts[c.kind].second = c.count;
  std::vector<Remark> out;
  for (const auto& [kind, both] : counts) {
    const auto [was, is] = both;
    if (was == is) continue;
    const Judgement judgement = is > was ? Judgement::worse : Judgement::better;
    out.push_back({"process",
                   kind == "near_miss" || kind == "slight_contact"
                       ? Judgement::not_judged
                       : if_judged(options, "process", judgement),
                   kind_text(kind) + ": " + moves_text(was) + " before, now " + moves_text(is)});
  }
  return out;
}

namespace {

using record::InputRecord;

const InputRecord* find_input(const std::vector<InputRecord>& all, const InputRecord& wanted) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const InputRecord& i) {
    return i.role == wanted.role && i.file == wanted.file;
  });
  if (same != all.end()) return &*same;
  // Another folder, another command line: of a role that only one file has, it is that one.
  const auto has_role = [&](const InputRecord& i) { return i.role == wanted.role; };
  if (std::count_if(all.begin(), all.end(), has_role) != 1) return nullptr;
  return &*std::find_if(all.begin(), all.end(), has_role);
}

/// The cage and the stock say what is measured: with others, figures are of another part.
std::string consequence(const std::string& role) {
  if (role == "cage" || role == "mesh") return ": the figures are those of another surface";
  return role == "stock" ? ": the figures are those of another stock" : "";
}

void compare_inputs(const std::vector<InputRecord>& base, const std::vector<InputRecord>& now,
                    std::vector<Remark>& out) {
  const auto add = [&out](const std::string& text) { name(out, "input", text); };
  for (const InputRecord& input : now) {
    const InputRecord* was = find_input(base, input);
    if (!was)
      add(input.role + " " + input.file + " is new");
    else if (was->sha256 != input.sha256)
      add(input.role + " " + input.file + " was changed" + consequence(input.role));
  }
  for (const InputRecord& input : base)
    if (!find_input(now, input)) add(input.role + " " + input.file + " is read no more");
}

/// Whether a design is the same one but for rounding.
bool is_same(const record::DesignExtent& a, const record::DesignExtent& b) {
  constexpr double kPlace_mm = 1e-9, kArea = 1e-9;  // of doubles written out whole
  return model::distance(a.box_mm.low, b.box_mm.low) <= kPlace_mm &&
         model::distance(a.box_mm.high, b.box_mm.high) <= kPlace_mm &&
         std::abs(a.area_mm2 - b.area_mm2) <= kArea * std::max(a.area_mm2, b.area_mm2);
}

/// What was measured and how, as far as no file shows it.
void compare_asked(const record::RunRecord& base, const record::RunRecord& now,
                   std::vector<Remark>& out) {
  const auto stated = [](const std::vector<std::string>& overrides) {
    return overrides.empty() ? "nothing" : joined(overrides, ", ");
  };
  name_change(out, "overrides", "set on the command line", stated(base.overrides),
              stated(now.overrides));
  if (base.design && now.design && !is_same(*base.design, *now.design))
    name(out, "surface", "the design has another box or area" + consequence("cage"));
  const auto differ = [](const std::string& was, const std::string& is) {
    return !was.empty() && !is.empty() && was != is;
  };
  if (differ(base.stock, now.stock))
    name(out, "stock", "what is stated of the raw stock has changed" + consequence("stock"));
  if (differ(base.programs, now.programs))
    name(out, "programs",
         "what programs were told of zero, offsets, start, control or tools has changed");
  if (base.setups != now.setups) name(out, "setups", "how the setups stand has changed");
}

/// Names of `run` that `other` has, too, in their order.
std::vector<std::string> shared_names(const record::RunRecord& run,
                                      const record::RunRecord& other) {
  std::vector<std::string> out;
  for (const record::StageRecord& stage : run.stages)
    if (std::any_of(other.stages.begin(), other.stages.end(),
                    [&](const auto& o) { return o.name == stage.name; }))
      out.push_back(stage.name);
  return out;
}

}  // namespace

std::vector<Remark> compare_heads(const record::RunRecord& base, const record::RunRecord& now) {
  std::vector<Remark> out;
  if (base.job != now.job)
    name(out, "job", "these are results of two jobs: " + base.job + " and " + now.job);
  if (base.version != now.version)
    name(out, "version", "Limitgauge was " + base.version + ", is " + now.version);
  compare_inputs(base.inputs, now.inputs, out);
  compare_asked(base, now, out);
  if (shared_names(base, now) != shared_names(now, base))
    name(out, "order", "the stages follow each other in another order");
  return out;
}

}  // namespace limitgauge::reports::compare
