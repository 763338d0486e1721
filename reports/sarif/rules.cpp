#include "reports/sarif/rules.h"

#include <array>
#include <stdexcept>

namespace limitgauge::reports::sarif {
namespace {

struct Rule {
  const char *id, *name, *level, *what, *help;
};

constexpr std::array kRules = {
    Rule{"gouge", "Gouge", "error", "The cut goes below the allowance surface.",
         "The depth is the run along the normal from the limit surface moved out by the "
         "allowance inwards through what was taken away, proven at the place named. Error: beyond "
         "the gate's limit; "
         "warning: the certified interval holds the limit; note: the job sets no limit. Look at "
         "the tip's height on the line named; where a shank or holder is named, at the reach of "
         "the tool."},
    Rule{"uncut", "Leftover", "error",
         "Material stands above the allowance surface where a cutter could have reached.",
         "The depth is the run along the normal outwards through the material that stands, proven "
         "at the place "
         "named. The line is that of the nearest pass, the related locations are the passes around "
         "it. Levels as for gouges. Look at the step between the passes named, or for a pass that "
         "is missing."},
    Rule{"missing_stock", "MissingStock", "error", "The raw stock does not cover the surface.",
         "The depth says how far the surface lies outside the raw stock at the place named; no "
         "program line is to blame. Levels as for gouges, against the gouge limit. Look at the "
         "stock's size and position."},
    Rule{"rapid_through_stock", "RapidThroughStock", "error",
         "A rapid goes through material that stands at that moment.",
         "Raise the clearance height, or let the move be a feed."},
    Rule{"shank_in_stock", "ShankInStock", "error",
         "The shank meets material that stands at that moment.",
         "Use a tool that is longer or thinner above its flutes, or clear what stands beside it "
         "first."},
    Rule{"holder_in_stock", "HolderInStock", "error",
         "The holder meets material that stands at that moment.",
         "Use a tool that reaches further out of its holder, or clear what stands beside it "
         "first."},
    Rule{"fixture_touched", "FixtureTouched", "error", "A part of the tool touches a fixture.",
         "Lead the move around the fixture named, or clamp elsewhere."},
    Rule{"spindle_stopped", "SpindleStopped", "error",
         "Material is removed while the program has the spindle at rest.",
         "Start the spindle (M3 or M4, with S) before the line named."},
    Rule{"feed_missing", "FeedMissing", "error", "A feed move has no feed rate.",
         "Program F on the line named or before it."},
    Rule{"below_flutes", "BelowFlutes", "error", "The cut is deeper than the flutes are long.",
         "Cut in more levels, or use longer flutes."},
    Rule{"steep_descent", "SteepDescent", "error",
         "The cutter goes down into material more steeply than it can.",
         "Ramp or helix in at a slope that the tool allows."},
    Rule{"cut_while_turning", "CutWhileTurning", "error",
         "Rotary axes turn at a feed rate while the flutes are in material, which is not simulated.",
         "Position the rotary axes clear of the part, then cut."},
    Rule{"beyond_travel", "BeyondTravel", "error", "A move leaves the machine's travel limits.",
         "Move the program's zero, or clamp the part elsewhere."},
    Rule{"slight_contact", "SlightContact", "note",
         "A rapid, a part above the flutes or a move at rest touches by less than the contact "
         "tolerance.",
         "Nothing fails; the tolerance stands among the report's assumptions, and a job can state "
         "a tighter one."},
    Rule{"near_miss", "NearMiss", "note",
         "A rapid, shank or holder passes stock or a fixture within the stated clearance.",
         "Nothing is touched and nothing fails; the distance that is left stands in the result."},
    Rule{kCoverageRule, "Coverage", "error",
         "Too little of the reachable surface lies inside both limits.",
         "The share is by area. The gouges and leftovers say where it is lost."},
    Rule{kUnreachableRule, "Unreachable", "error",
         "More of the surface is out of reach of every cutter used so far than the gate allows.",
         "The area is certified. Use a cutter that reaches there, or another setup."},
    Rule{kUnavoidableRule, "UnavoidableUncut", "error",
         "More material must be left where no cutter used so far can reach than the gate allows.",
         "The height is certified. Use a smaller cutter there, or one that reaches."},
    Rule{kVerdictRule, "Verdict", "error",
         "A verdict other than pass that no single place explains.",
         "The message has the reasons that the gate gave."},
};

}  // namespace

Json rules() {
  Json out = Json::array();
  for (const Rule& rule : kRules)
    out.push_back({{"id", rule.id},
                   {"name", rule.name},
                   {"shortDescription", {{"text", rule.what}}},
                   {"fullDescription", {{"text", std::string(rule.what) + " " + rule.help}}},
                   {"help", {{"text", rule.help}}},
                   {"defaultConfiguration", {{"level", rule.level}}}});
  return out;
}

std::size_t rule_index(const std::string& id) {
  for (std::size_t i = 0; i < kRules.size(); ++i)
    if (kRules[i].id == id) return i;
  throw std::invalid_argument("no such rule: " + id);
}

}  // namespace limitgauge::reports::sarif
