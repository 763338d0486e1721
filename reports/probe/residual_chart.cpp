#include "reports/probe/residual_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/probe/probe_words.h"
#include "reports/tolerance.h"

namespace limitgauge::reports::probe {
namespace {

constexpr std::size_t kMostMarks = 400;

/// Points that share one mark: as few as fit.
std::size_t points_a_mark(std::size_t points) {
  return (points + kMostMarks - 1) / kMostMarks;
}

/// What the vertical axis ends at, on both sides: a round number of mm.
double round_up(double largest_mm) {
  const double power = std::pow(10, std::floor(std::log10(std::max(largest_mm, kLeastExtent_mm))));
  for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0})
    if (largest_mm <= step * power) return step * power;
  return 10 * power;
}

double largest_drawn_mm(const ProbeResult& result) {
  double largest = 0;
  for (const ProbedPoint& point : result.points) {
    largest = std::max(largest, std::abs(point.before.gap.value_mm));
    largest = std::max(largest,
                       std::abs(point.after.gap.value_mm) + kCoverageFactor * point.measured.u_mm);
  }
  return largest;
}

struct Extent {
  double low = 0, high = 0;
};

/// Of the residuals of points from `begin` to `end`, each widened by `factor` uncertainties.
Extent extent_of(const ProbeResult& result, Residuals which, double factor, std::size_t begin,
                 std::size_t end) {
  Extent out{1e300, -1e300};
  for (std::size_t i = begin; i < end; ++i) {
    const double value = residual_of(result.points[i], which).gap.value_mm;
    const double wide = factor * result.points[i].measured.u_mm;
    out.low = std::min(out.low, value - wide);
    out.high = std::max(out.high, value + wide);
  }
  return out;
}

/// Lines with the given class, a mark a group of points; a line of no length is a dot.
std::string marks(const ProbeResult& result, Residuals which, double factor, const char* css,
                  double scale_mm) {
  const std::size_t count = result.points.size(), group = points_a_mark(count);
  std::string out = fmt::format("<g class=\"{}\">", css);
  for (std::size_t begin = 0; begin < count; begin += group) {
    const std::size_t end = std::min(count, begin + group);
    const Extent range = extent_of(result, which, factor, begin, end);
    const double x = 100 * (static_cast<double>(begin + end) / 2) / static_cast<double>(count);
    out += fmt::format("<path d=\"M{0} {1}V{2}\"/>", fixed(x, 3),
                       fixed(50 - 50 * range.high / scale_mm, 3),
                       fixed(50 - 50 * range.low / scale_mm + 1e-3, 3));
  }
  return out + "</g>\n";
}

std::string legend(const ProbeResult& result) {
  std::string out =
      "<p class=\"key\"><span class=\"before\">as measured</span> "
      "<span class=\"after\">shift taken back</span>";
  if (result.has_uncertainty) out += " <span class=\"wide\">± 2 standard uncertainties</span>";
  return out + "</p>\n";
}

std::string caption(const ProbeResult& result) {
  const std::size_t group = points_a_mark(result.points.size());
  std::string out =
      "Residuals in the order of the points’ file. Above zero the part has more material than the "
      "simulation, below zero less.";
  if (group > 1) out += fmt::format(" Each mark is the range of {} points.", grouped(group));
  return out;
}

}  // namespace

std::string residual_chart(const ProbeResult& result) {
  const double scale_mm = round_up(1.05 * largest_drawn_mm(result));
  std::string drawn;
  if (result.has_uncertainty)
    drawn += marks(result, Residuals::after, kCoverageFactor, "wide", scale_mm);
  drawn += marks(result, Residuals::before, 0, "before", scale_mm) +
           marks(result, Residuals::after, 0, "after", scale_mm);
  return fmt::format(
      "<figure class=\"residuals\"><figcaption>{}</figcaption>\n{}<div class=\"plot\">"
      "<div class=\"scale\"><span>+{}</span><span>0</span><span>−{}</span></div>"
      "<svg viewBox=\"0 0 100 100\" preserveAspectRatio=\"none\" role=\"img\" "
      "aria-label=\"Residuals of {} points: root mean square {} as measured, {} with the shift "
      "taken back\">\n<line class=\"zero\" x1=\"0\" x2=\"100\" y1=\"50\" y2=\"50\"/>\n{}</svg>"
      "</div></figure>\n",
      caption(result), legend(result), stated_length(scale_mm), stated_length(scale_mm),
      grouped(result.points.size()), shown_length(result.shift.rms_before_mm),
      shown_length(result.shift.rms_after_mm), drawn);
}

}  // namespace limitgauge::reports::probe
