#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/html/stage/tolerance_parts.h"
#include "reports/html/tolerance_words.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

using Of = verifier::Tolerance::Of;

/// What is off, and how: "the zero" is "5 µm low" and "5 µm towards −X".
struct Off {
  std::string who;
  std::vector<std::string> how;
};

std::string who_of(const verifier::Tolerance& t) {
  if (!t.tool.empty()) return "tool " + escape_markup(t.tool);
  switch (t.of) {
    case Of::runout:
      return "the teeth cutting";
    case Of::positioning:
      return "the moves placed";
    case Of::path:
      return "the tip off its path";
    default:
      return "the zero";
  }
}

std::string direction(int axis, bool up) {
  if (axis == 2) return up ? "high" : "low";
  return std::string("towards ") + (up ? "+" : "−") + (axis == 0 ? "X" : "Y");
}

std::string how_words(const verifier::Tolerance& t, double mm) {
  // Its sign is said in words.
  const std::string length = offset_words(std::abs(mm)).substr(1);
  const bool more = mm > 0;
  switch (t.of) {
    case Of::radius:
      return length + (more ? " larger in radius" : " smaller in radius");
    case Of::length:
      return length + (more ? " longer" : " shorter");
    case Of::corner_radius:
      return length + (more ? " larger in corner radius" : " smaller in corner radius");
    case Of::flat:
      return length + (more ? " wider" : " narrower") + " to its corner’s centre";
    case Of::runout:
      return length + (more ? " further out" : " further in");
    default:
      return length + " " + direction(t.axis, more);
  }
}

double value_named(const std::vector<verifier::NamedLength>& at, const std::string& name) {
  const auto found =
      std::find_if(at.begin(), at.end(), [&](const auto& value) { return value.name == name; });
  return found == at.end() ? 0 : found->mm;
}

/// "a", "a and b", "a, b and c".
std::string enumerated(const std::vector<std::string>& parts) {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i)
    out += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return out;
}

}  // namespace

std::string witness_words(const model::Tolerances& tolerances,
                          const verifier::RobustFigure& figure) {
  std::vector<Off> all;
  for (const verifier::Tolerance& t : stated_tolerances(tolerances)) {
    const double mm = value_named(figure.at, t.name());
    if (mm == 0) continue;
    const std::string who = who_of(t);
    if (all.empty() || all.back().who != who) all.push_back({who, {}});
    all.back().how.push_back(how_words(t, mm));
  }
  std::string out;
  for (const Off& off : all) out += (out.empty() ? "" : "; ") + off.who + " " + enumerated(off.how);
  return out.empty() ? "everything as stated" : out;
}

}  // namespace limitgauge::reports::html
