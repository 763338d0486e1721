#include "tests/defects/orientations/lying_table.h"

#include <algorithm>
#include <functional>

#include "tests/support/printed.h"

namespace limitgauge::tests::defects {
namespace {

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
  const auto raised = std::count_if(results.begin(), results.end(),
                                    [](const LyingResult& r) { return r.gate_raised; });
  out << "\nGates raised to what the oracle holds possible, and the twin run again: " << raised
      << ".\n";
}

void write_lying_failures(std::ostream& out, const std::vector<LyingResult>& results) {
  for (const LyingResult& r : results) {
    if (r.good()) continue;
    out << (r.harmed ? name(r.kind) : "twin") << ", " << r.label
        << printed(", size %.4g, seed %u: ", r.size, r.seed) << r.verdict << " " << r.process
        << r.broken << "\n";
    out << told("gouge", r.gouge) << told("uncut", r.uncut);
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
