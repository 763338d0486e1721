#include "tests/defects/table.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "tests/support/printed.h"

namespace limitgauge::tests::defects {
namespace {

using verifier::Verdict;

std::string micrometres(double mm) {
  const double um = mm * 1000;
  return um < 10 ? printed("%.3f", um) : um < 1000 ? printed("%.1f", um) : printed("%.0f", um);
}

struct Band {
  const char* name;
  double from_mm, to_mm;
};
constexpr Band kBands[] = {
    {"under 0.5 µm", 0, 0.5e-3}, {"0.5–1 µm", 0.5e-3, 1e-3}, {"1–3 µm", 1e-3, 3e-3},
    {"3–10 µm", 3e-3, 0.01},     {"10–30 µm", 0.01, 0.03},   {"30–100 µm", 0.03, 0.1},
    {"0.1–0.3 mm", 0.1, 0.3},    {"0.3–2 mm", 0.3, 2},       {"over 2 mm", 2, 1e9}};

/// One side of one case that has something to be found.
struct Entry {
  const CaseResult* made_by;
  const SideResult* side;
  bool is_gouge;
};

std::vector<Entry> due_entries(const std::vector<PairResult>& results) {
  std::vector<Entry> out;
  for (const PairResult& pair : results)
    for (const CaseResult& c : pair.cases) {
      if (c.gouge.due) out.push_back({&c, &c.gouge, true});
      if (c.uncut.due) out.push_back({&c, &c.uncut, false});
    }
  return out;
}

/// How far the certified ends are from the oracle's depth along the normal. Cases that were
/// narrowed only as far as the verdict needs say nothing of that.
std::vector<double> errors_of(const std::vector<Entry>& entries) {
  std::vector<double> out;
  for (const Entry& e : entries)
    if (!e.made_by->gated)
      out.push_back(std::max(std::abs(e.side->certified.low - e.side->truth_mm),
                             std::abs(e.side->certified.high - e.side->truth_mm)));
  std::sort(out.begin(), out.end());
  return out;
}

void write_row(std::ostream& out, const std::string& name, const std::vector<Entry>& entries,
               bool with_moves) {
  if (entries.empty()) return;
  const auto count = [&](const std::function<bool(const SideResult&)>& what) {
    return static_cast<std::size_t>(std::count_if(entries.begin(), entries.end(),
                                                  [&](const Entry& e) { return what(*e.side); }));
  };
  const std::size_t found = count([](const SideResult& s) { return s.failed; });
  out << "| " << name << " | " << entries.size() << " | " << found << " | "
      << entries.size() - found << " | " << count([](const SideResult& s) { return s.located; });
  if (with_moves) out << " | " << count([](const SideResult& s) { return s.named; });
  out << " | " << count([](const SideResult& s) { return s.contained; });
  const std::vector<double> errors = errors_of(entries);
  if (errors.empty())
    out << " | – | –";
  else
    out << " | " << micrometres(errors[errors.size() / 2]) << " | " << micrometres(errors.back());
  out << " |\n";
}

void write_side(std::ostream& out, const std::vector<Entry>& all, bool gouges) {
  out << "| depth | cases | detected | missed | located |" << (gouges ? " line named |" : "")
      << " interval holds truth | median error, µm | worst error, µm |\n|---|---|---|---|---|"
      << (gouges ? "---|" : "") << "---|---|---|\n";
  std::vector<Entry> side;
  for (const Entry& e : all)
    if (e.is_gouge == gouges) side.push_back(e);
  for (const Band& band : kBands) {
    std::vector<Entry> here;
    for (const Entry& e : side)
      if (e.side->truth_mm >= band.from_mm && e.side->truth_mm < band.to_mm) here.push_back(e);
    write_row(out, band.name, here, gouges);
  }
  write_row(out, "**all**", side, gouges);
}

void write_kinds(std::ostream& out, const std::vector<PairResult>& results,
                 const std::vector<Entry>& all) {
  out << "| mishap | programs | harmless | findings due | detected | missed | located | interval "
         "holds truth | median error, µm | worst error, µm |\n"
         "|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Kind kind : kKinds) {
    std::size_t planted = 0, harmless = 0;
    for (const PairResult& pair : results)
      for (const CaseResult& c : pair.cases)
        if (c.mishap.kind == kind) ++planted, harmless += !c.gouge.due && !c.uncut.due;
    std::vector<Entry> here;
    for (const Entry& e : all)
      if (e.made_by->mishap.kind == kind) here.push_back(e);
    if (here.empty()) continue;
    write_row(out, printed("%s | %zu | %zu", name(kind), planted, harmless), here, false);
  }
}

std::string widths_of(const std::vector<PairResult>& results) {
  std::set<double> widths;
  for (const PairResult& pair : results)
    for (const CaseResult& c : pair.cases) widths.insert(c.resolution_mm);
  std::string text;
  for (const double width : widths) text += (text.empty() ? "" : " or ") + micrometres(width);
  return text;
}

void write_head(std::ostream& out, const Summary& s, const std::vector<PairResult>& results) {
  out << s.cases << " programs with a planted mishap on " << s.surfaces << " surfaces with "
      << s.cutters << " cutters, " << s.twins
      << " unharmed twins; certified width asked for: " << widths_of(results)
      << " µm; the simulator's readings compared in " << s.with_voxels << " runs.\n\n"
      << "Findings due: " << s.due << ", missed: " << s.missed
      << ". False alarms: " << s.false_alarms << " of " << s.twins << " twins ("
      << s.undecided_twins
      << " not decided at that width). Intervals without the truth: " << s.uncontained
      << ". Contradictions: " << s.broken << ".\n\n";
}

}  // namespace

Summary summarize(const std::vector<PairResult>& results) {
  Summary s;
  std::set<std::string> surfaces, cutters;
  for (const PairResult& pair : results) {
    for (const TwinResult& t : pair.twins) {
      const std::size_t comma = t.pair.rfind(", ");
      surfaces.insert(t.pair.substr(0, comma)), cutters.insert(t.pair.substr(comma));
      ++s.twins;
      s.false_alarms += t.verdict == Verdict::fail;
      s.undecided_twins += t.verdict == Verdict::indeterminate;
      s.uncontained += t.broken.empty() && !(t.gouge.contained && t.uncut.contained);
      s.broken += !t.broken.empty();
      s.with_voxels += t.voxels;
    }
    for (const CaseResult& c : pair.cases) {
      ++s.cases;
      s.broken += !c.broken.empty();
      s.with_voxels += c.voxels;
      s.uncontained += c.broken.empty() && !(c.gouge.contained && c.uncut.contained);
      s.misnamed += c.gouge.due && !c.gouge.named;
      for (const SideResult* side : {&c.gouge, &c.uncut}) {
        s.due += side->due;
        s.missed += side->due && !side->failed;
        s.misplaced += side->due && !side->located;
      }
    }
  }
  s.surfaces = surfaces.size(), s.cutters = cutters.size();
  return s;
}

void write_tables(std::ostream& out, const std::vector<PairResult>& results) {
  const std::vector<Entry> all = due_entries(results);
  write_head(out, summarize(results), results);
  out << "Gouges deeper than the twin's gate by more than the width:\n\n";
  write_side(out, all, true);
  out << "\nLeftovers, where the cutter can reach:\n\n";
  write_side(out, all, false);
  out << "\nBy mishap, gouges and leftovers together; harmless: nothing beyond the twin's gate by "
         "more than the width:\n\n";
  write_kinds(out, results, all);
}

void write_failures(std::ostream& out, const std::vector<PairResult>& results) {
  for (const PairResult& pair : results) {
    for (const TwinResult& t : pair.twins) {
      const bool good =
          t.broken.empty() && t.verdict == Verdict::pass && t.gouge.contained && t.uncut.contained;
      if (good) continue;
      out << "twin " << t.pair << ", allowance " << t.allowance_mm << ": "
          << verifier::name(t.verdict) << (t.reached_resolution ? "" : ", resolution not reached")
          << " " << t.broken << "\n";
      out << told("gouge", t.gouge) << told("uncut", t.uncut);
    }
    for (const CaseResult& c : pair.cases) {
      const auto bad = [](const SideResult& s, bool gouge) {
        return !s.contained || (s.due && (!s.failed || !s.located || (gouge && !s.named)));
      };
      if (c.broken.empty() && !bad(c.gouge, true) && !bad(c.uncut, false)) continue;
      out << "case " << c.pair << ", " << name(c.mishap.kind)
          << printed(", size %.6g mm, seed %u%s ", c.mishap.size_mm, c.mishap.seed,
                     c.gated ? ", gated" : "")
          << c.broken << "\n";
      out << told("gouge", c.gouge) << told("uncut", c.uncut);
    }
  }
}

void write_cases(std::ostream& out, const std::vector<PairResult>& results) {
  out << "pair\tmishap\tsize\tseed\tgouge\tgouge_low\tgouge_high\tgouge_gate\tuncut\t"
         "uncut_low\tuncut_high\tuncut_gate\tcells\tseconds\n";
  for (const PairResult& pair : results) {
    for (const TwinResult& t : pair.twins)
      out << t.pair << "\ttwin\t" << t.allowance_mm << "\t0\t"
          << printed("%.7f\t%.7f\t%.7f\t0\t%.7f\t%.7f\t%.7f\t0\t0\t%.2f\n", t.gouge.truth_mm,
                     t.gouge.certified.low, t.gouge.certified.high, t.uncut.truth_mm,
                     t.uncut.certified.low, t.uncut.certified.high, t.seconds);
    for (const CaseResult& c : pair.cases)
      out << c.pair << "\t" << name(c.mishap.kind)
          << printed("\t%.6g\t%u\t%.7f\t%.7f\t%.7f\t%.7f\t", c.mishap.size_mm, c.mishap.seed,
                     c.gouge.truth_mm, c.gouge.certified.low, c.gouge.certified.high,
                     c.gouge.gate_mm)
          << printed("%.7f\t%.7f\t%.7f\t%.7f\t%zu\t%.2f\n", c.uncut.truth_mm, c.uncut.certified.low,
                     c.uncut.certified.high, c.uncut.gate_mm, c.cells, c.seconds);
  }
}

namespace {

void write_scene_row(std::ostream& out, const char* name, const std::vector<SceneResult>& results,
                     const std::function<bool(const SceneResult&)>& among) {
  std::size_t planted = 0, found = 0, located = 0, contained = 0, twins = 0, alarms = 0, open = 0;
  double seconds = 0;
  for (const SceneResult& r : results) {
    if (!among(r)) continue;
    seconds += r.seconds;
    planted += r.harmed, twins += !r.harmed;
    found += r.harmed && !r.missed(), alarms += r.false_alarm();
    located += r.harmed && r.located, contained += r.harmed && r.contained;
    open += !r.harmed && r.verdict == Verdict::indeterminate;
  }
  out << "| " << name << " | " << planted << " | " << found << " | " << planted - found << " | "
      << located << " | " << contained << " | " << twins << " | " << alarms << " | " << open
      << " | " << printed("%.1f", seconds) << " |\n";
}

}  // namespace

void write_scene_table(std::ostream& out, const std::vector<SceneResult>& results) {
  out << "Defects whose depth and place follow from their making, and the like without them:\n\n"
         "| defect | planted | detected | missed | located | interval holds truth | twins | false "
         "alarms | twins not decided | seconds |\n|---|---|---|---|---|---|---|---|---|---|\n";
  for (const SceneKind kind : kSceneKinds)
    write_scene_row(out, name(kind), results, [&](const SceneResult& r) { return r.kind == kind; });
  write_scene_row(out, "**all**", results, [](const SceneResult&) { return true; });
}

void write_scene_failures(std::ostream& out, const std::vector<SceneResult>& results) {
  for (const SceneResult& r : results) {
    if (r.good()) continue;
    out << (r.harmed ? "scene " : "twin scene ") << name(r.kind) << ", " << r.label << ": "
        << verifier::name(r.verdict)
        << printed(", truth %.6f, certified [%.6f, %.6f]; located %d holds %d, %.1f s ", r.depth_mm,
                   r.certified.low, r.certified.high, r.located, r.contained, r.seconds)
        << r.broken << "\n";
  }
}

}  // namespace limitgauge::tests::defects
