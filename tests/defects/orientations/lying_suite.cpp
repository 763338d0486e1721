#include "tests/defects/orientations/lying_suite.h"

#include <cstdio>
#include <functional>

#include "tests/defects/surfaces.h"
#include "tests/support/cages.h"
#include "tests/support/folders.h"

namespace limitgauge::tests::defects {
namespace {

template <class... Values>
std::string printed(const char* pattern, Values... values) {
  char text[300];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

/// Parts and cutters of half the suite's size: 5 to 7 mm, so that a job takes a second or two.
constexpr double kScale = 0.5;

model::Cutter small(model::Cutter cutter) {
  cutter.diameter_mm *= kScale, cutter.corner_radius_mm *= kScale;
  cutter.flute_length_mm *= kScale;
  return cutter;
}

/// A part that is cut from a little beside its own axis.
model::Cage leaning(const model::Cage& cage, std::mt19937& random) {
  constexpr double kMost_deg = 12;
  const double a = between(random, 0, 6.28318);
  return model::turned(placed(cage, {kScale, 0, {}}),
                       turned_about({std::cos(a), std::sin(a), 0}, between(random, 0, kMost_deg)));
}

std::vector<LyingKind> kinds_for(Holding holding, std::size_t turn, std::size_t count) {
  // The lost word is of machines alone.
  const std::size_t kinds = std::size(kLyingKinds) - (holding == Holding::still ? 1 : 0);
  std::vector<LyingKind> out;
  for (std::size_t k = 0; k < count; ++k) out.push_back(kLyingKinds[(turn + k) % kinds]);
  return out;
}

void write_lying_row(std::ostream& out, const std::string& name,
                     const std::vector<LyingResult>& results,
                     const std::function<bool(const LyingResult&)>& among) {
  std::size_t planted = 0, missed = 0, located = 0, held = 0, twins = 0, alarms = 0, open = 0,
              broken = 0;
  double seconds = 0;
  for (const LyingResult& r : results) {
    if (!among(r)) continue;
    seconds += r.seconds, broken += !r.broken.empty();
    held += r.contained();
    planted += r.harmed, missed += r.missed(), located += r.harmed && r.located();
    twins += !r.harmed, alarms += r.false_alarm();
    open += !r.harmed && r.verdict != "fail" && r.verdict != "pass";
  }
  if (planted + twins == 0) return;
  out << "| " << name << " | " << planted << " | " << planted - missed << " | " << missed << " | "
      << located << " | " << twins << " | " << alarms << " | " << open << " | " << held << " | "
      << broken << " | " << printed("%.1f", seconds) << " |\n";
}

}  // namespace

std::vector<LyingPlan> lying_plans(unsigned seed, std::size_t defects, std::size_t twins) {
  const std::vector<NamedCage> surfaces = suite_surfaces(tests::fixtures().string());
  const std::vector<model::Cutter> cutters = suite_cutters();
  constexpr Holding kOnMachines[] = {Holding::table_table, Holding::head_table, Holding::head_head};
  std::vector<LyingPlan> plans;
  for (std::size_t k = 0, planted = 0; k < twins; ++k) {
    LyingPlan plan;
    plan.seed = seed * 1000 + static_cast<unsigned>(k);
    std::mt19937 random(plan.seed + 500'000'000);
    const NamedCage& surface = surfaces[(k / 2 * 5 + k % 2 * 3) % surfaces.size()];
    plan.surface_name = surface.name, plan.cage = leaning(surface.cage, random);
    plan.cutter = small(cutters[(k / 2 + k / 8) % cutters.size()]);
    plan.step_mm = 0.2 + 0.05 * static_cast<double>(k % 4);
    plan.across = static_cast<int>(k / 2 % 2);
    plan.allowance_mm = k % 5 == 4 ? 0.05 : 0;
    plan.holding = k % 2 == 0 ? Holding::still : kOnMachines[k / 2 % 3];
    const std::size_t count = defects * (k + 1) / twins - planted;
    plan.kinds = kinds_for(plan.holding, planted / 2 + k % 3, count);
    planted += count;
    plans.push_back(std::move(plan));
  }
  return plans;
}

void write_lying_tables(std::ostream& out, const std::vector<LyingResult>& results) {
  const std::string head =
      " | planted | detected | missed | located | twins | false alarms | twins not decided | "
      "intervals hold truth | contradictions | seconds "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  out << "Parts that lie turned, each a job and a program that are run:\n\n| defect" << head;
  for (const LyingKind kind : kLyingKinds)
    write_lying_row(out, name(kind), results,
                    [&](const LyingResult& r) { return r.harmed && r.kind == kind; });
  write_lying_row(out, "none", results, [](const LyingResult& r) { return !r.harmed; });
  write_lying_row(out, "**all**", results, [](const LyingResult&) { return true; });
  out << "\n| held by" << head;
  for (const Holding holding : kHoldings)
    write_lying_row(out, name(holding), results,
                    [&](const LyingResult& r) { return r.holding == holding; });
}

void write_lying_failures(std::ostream& out, const std::vector<LyingResult>& results) {
  const auto side = [&](const char* what, const SideResult& s) {
    out << printed(
        "  %s: truth %.6f, certified [%.6f, %.6f], gate %.6f mm; due %d failed %d "
        "located %d named %d holds %d\n",
        what, s.truth_mm, s.certified.low, s.certified.high, s.gate_mm, s.due, s.failed, s.located,
        s.named, s.contained);
  };
  for (const LyingResult& r : results) {
    if (r.good()) continue;
    out << (r.harmed ? name(r.kind) : "twin") << ", " << r.label
        << printed(", size %.4g, seed %u: ", r.size, r.seed) << r.verdict << " " << r.process
        << r.broken << "\n";
    side("gouge", r.gouge);
    side("uncut", r.uncut);
  }
}

void write_lying_cases(std::ostream& out, const std::vector<LyingResult>& results) {
  out << "label\tdefect\tsize\tseed\tverdict\tgouge\tgouge_low\tgouge_high\tgouge_gate\tuncut\t"
         "uncut_low\tuncut_high\tuncut_gate\tgood\tseconds\tprocess\n";
  for (const LyingResult& r : results)
    out << r.label << "\t" << (r.harmed ? name(r.kind) : "twin")
        << printed("\t%.5g\t%u\t", r.size, r.seed) << r.verdict
        << printed("\t%.7f\t%.7f\t%.7f\t%.7f", r.gouge.truth_mm, r.gouge.certified.low,
                   r.gouge.certified.high, r.gouge.gate_mm)
        << printed("\t%.7f\t%.7f\t%.7f\t%.7f", r.uncut.truth_mm, r.uncut.certified.low,
                   r.uncut.certified.high, r.uncut.gate_mm)
        << printed("\t%d\t%.2f\t", r.good(), r.seconds) << r.process << "\n";
}

}  // namespace limitgauge::tests::defects
