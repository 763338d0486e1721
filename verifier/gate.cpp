#include <algorithm>
#include <cmath>
#include <cstdio>

#include "verifier/verify.h"

namespace limitgauge::verifier {
namespace {

/// Micrometres below a tenth of a millimetre, millimetres above; nanometres where micrometres would
/// need an exponent.
std::string length_text(double mm) {
  constexpr double kMicrometres_mm = 0.1, kNanometres_mm = 1e-6;
  char text[48];
  if (std::abs(mm) >= kMicrometres_mm)
    std::snprintf(text, sizeof text, "%.4g mm", mm);
  else if (mm == 0 || std::abs(mm) >= kNanometres_mm)
    std::snprintf(text, sizeof text, "%.4g µm", mm * 1e3);
  else
    std::snprintf(text, sizeof text, "%.4g nm", mm * 1e6);
  return text;
}

using Rounding = double (*)(double);

/// `mm` in four significant digits, rounded by `up_or_down`: what is said of an end of a certified
/// interval stays true. A number of four digits is itself, whatever its last bits say.
double outwards(double mm, Rounding up_or_down) {
  if (mm <= 0) return mm;
  constexpr double kLastBits = 1e-6;
  const double unit = std::pow(10.0, std::floor(std::log10(mm)) - 3);
  const double units = mm / unit;
  const double nearest = std::round(units);
  return (std::abs(units - nearest) < kLastBits ? nearest : up_or_down(units)) * unit;
}

std::string range_text(const Interval& figure) {
  return "between " + length_text(outwards(figure.low, std::floor)) + " and " +
         length_text(outwards(figure.high, std::ceil));
}

Verdict judge(const Interval& figure, double limit_mm) {
  if (figure.high <= limit_mm) return Verdict::pass;
  return figure.low > limit_mm ? Verdict::fail : Verdict::indeterminate;
}

std::string sentence(const std::string& what, const Interval& figure, double limit_mm,
                     Verdict verdict) {
  const std::string range =
      what + " certified " + range_text(figure) + ", limit " + length_text(limit_mm);
  switch (verdict) {
    case Verdict::pass:
      return range + ": within the limit everywhere";
    case Verdict::fail:
      return range + ": beyond the limit";
    default:
      return range + ": cannot be decided at this resolution";
  }
}

void worsen(Verdict& verdict, Verdict by) {
  const auto rank = [](Verdict v) {
    return v == Verdict::fail ? 2 : v == Verdict::indeterminate ? 1 : 0;
  };
  if (rank(by) > rank(verdict)) verdict = by;
}

/// "gouge", and by which body if not by the flutes alone.
std::string gouge_by(const StageDeviation& deviation) {
  std::string what = "gouge";
  for (const BodyFigure& b : deviation.bodies)
    if (b.body != "cutter" && b.gouge_mm.low > 0 && b.gouge_mm.low >= deviation.gouge_mm.low)
      what += " by the " + b.body;
  return what;
}

void judge_length(GateDecision& out, const std::string& what, const Interval& figure,
                  double limit_mm) {
  const Verdict verdict = judge(figure, limit_mm);
  out.reasons.push_back(sentence(what, figure, limit_mm, verdict));
  worsen(out.verdict, verdict);
}

/// δ measures to the nearest removed space or material: beside a thin wall, and in a hole that is
/// deeper than wide, it stays small, and the stock points show the height. Of cusps and of corners
/// that go into S they show somewhat more than δ too (under half as much again up to cusps of two
/// fifths of the radius, a fifth at right angles), so only twice the certified figure counts.
bool shows_more(double voxel_mm, double certified_mm, double limit_mm) {
  constexpr double kTwice = 2, kLeast_mm = 1e-3;  // stock points have errors of their own
  return certified_mm <= limit_mm && voxel_mm > limit_mm &&
         voxel_mm > kTwice * std::max(certified_mm, kLeast_mm);
}

void judge_process(GateDecision& out, const ProcessFault& fault) {
  if (fault.count == 0) return;
  out.reasons.push_back(fault.what + ": " + std::to_string(fault.count) +
                        (fault.count == 1 ? " move" : " moves"));
  worsen(out.verdict, Verdict::fail);
}

}  // namespace

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::fail:
      return "fail";
    case Verdict::indeterminate:
      return "indeterminate";
    case Verdict::not_run:
      break;
  }
  return "not_run";
}

double automatic_resolution_mm(const GateLimits& limits) {
  constexpr double kUnlimited_mm = 0.001;
  double tightest = std::numeric_limits<double>::infinity();
  if (limits.has_gouge && limits.gouge_mm > 0) tightest = std::min(tightest, limits.gouge_mm);
  if (limits.has_uncut && limits.uncut_mm > 0) tightest = std::min(tightest, limits.uncut_mm);
  return std::isfinite(tightest) ? tightest / 10 : kUnlimited_mm;
}

GateDecision decide(const StageDeviation& deviation, const GateLimits& limits,
                    std::span<const ProcessFault> faults) {
  GateDecision out{Verdict::pass, {}};
  if (limits.has_gouge) {
    judge_length(out, gouge_by(deviation), deviation.gouge_mm, limits.gouge_mm);
    if (shows_more(deviation.voxel_gouge_mm, deviation.gouge_mm.low, limits.gouge_mm)) {
      out.reasons.push_back("the stock lies " + length_text(deviation.voxel_gouge_mm) +
                            " under the allowance surface, limit " + length_text(limits.gouge_mm));
      worsen(out.verdict, Verdict::fail);
    }
  }
  if (limits.has_uncut) {
    judge_length(out, "uncut", deviation.uncut_mm, limits.uncut_mm);
    if (shows_more(deviation.voxel_uncut_mm, deviation.uncut_mm.high, limits.uncut_mm)) {
      out.reasons.push_back("material stands " + length_text(deviation.voxel_uncut_mm) +
                            " over the allowance surface, limit " + length_text(limits.uncut_mm));
      worsen(out.verdict, Verdict::fail);
    }
  }
  if (limits.has_coverage) {
    const bool enough = deviation.coverage >= limits.coverage;
    char text[128];
    std::snprintf(text, sizeof text, "coverage %.4f of the reachable area, least accepted %.4f: %s",
                  deviation.coverage, limits.coverage, enough ? "enough" : "too little");
    out.reasons.emplace_back(text);
    if (!enough) worsen(out.verdict, Verdict::fail);
  }
  for (const ProcessFault& fault : faults) judge_process(out, fault);
  return out;
}

}  // namespace limitgauge::verifier
