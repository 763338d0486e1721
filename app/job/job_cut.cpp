#include "app/job/job_parts.h"

#include <algorithm>
#include <vector>

#include "engine/strategy/axes/leaning_axis.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

using namespace engine::strategy;

Strategy read_strategy(const TomlTable& stage) {
  const std::string word = stage.one_of("strategy", {"contour", "zigzag", "steep_shallow", "rest"});
  if (word == "contour") return Strategy::contour;
  if (word == "zigzag") return Strategy::zigzag;
  return word == "rest" ? Strategy::rest : Strategy::steep_shallow;
}

/// Keys that only some strategies use, and what stands for them where they are left out.
struct Uses {
  const char* key;
  std::vector<Strategy> by;
  std::string otherwise;  ///< empty where leaving the key out leaves the thing out
};

std::vector<Uses> uses(const CutOptions& cut) {
  const std::vector<Strategy> rows = {Strategy::zigzag, Strategy::steep_shallow, Strategy::rest};
  const std::vector<Strategy> both = {Strategy::steep_shallow, Strategy::rest};
  const std::vector<Strategy> loops = {Strategy::contour, Strategy::steep_shallow, Strategy::rest};
  const std::vector<Strategy> all = {Strategy::contour, Strategy::zigzag, Strategy::steep_shallow,
                                     Strategy::rest};
  const std::vector<Strategy> zigzag = {Strategy::zigzag};
  return {{"tilt", zigzag, ""},
          {"lead", zigzag, cut.lean ? model::shortest(cut.lean->lead_deg) : ""},
          {"lean_from", zigzag, cut.lean ? "vertical" : ""},
          {"scallop", rows, ""},
          {"angle", rows, model::shortest(cut.angle_deg)},
          {"pattern", rows, "zigzag"},
          {"boundary_pass", rows, "false"},
          {"steep_angle", both, model::shortest(cut.steep_angle_deg)},
          {"overlap", both, model::shortest(cut.overlap_or_default_mm())},
          {"direction", loops, "either"},
          {"entry", all, "ramp"},
          {"ramp_angle", all, model::shortest(cut.ramp_angle_deg)},
          {"plunge_feed", all, model::shortest(cut.plunge_feed_mm_min)},
          {"link_feed", all, model::shortest(cut.link_feed_mm_min)}};
}

/// Says what is left to defaults, and refuses what the strategy would ignore.
void check_uses(const TomlTable& stage, const std::string& name, const CutOptions& cut,
                JobContext& context) {
  std::string said;
  for (const Uses& use : uses(cut)) {
    const bool used = std::find(use.by.begin(), use.by.end(), cut.strategy) != use.by.end();
    if (!used && stage.has(use.key))
      throw model::InputError(stage.place(use.key),
                              "\"" + std::string(use.key) + "\" changes nothing of strategy \"" +
                                  strategy_name(cut.strategy) + "\"",
                              "a key that this strategy uses");
    if (!used || stage.has(use.key) || use.otherwise.empty()) continue;
    said += std::string(said.empty() ? " " : ", ") + use.key + " = " + use.otherwise;
  }
  if (!said.empty()) context.defaulted.push_back("stage " + name + ": defaults:" + said);
}

void read_shape(const TomlTable& stage, CutOptions& cut, JobContext& context) {
  if (stage.has("angle")) cut.angle_deg = stage.angle_deg("angle");
  if (stage.has("pattern"))
    cut.pattern = stage.one_of("pattern", {"zigzag", "one_way"}) == "zigzag" ? RowPattern::zigzag
                                                                             : RowPattern::one_way;
  if (stage.has("direction")) {
    const std::string word = stage.one_of("direction", {"either", "climb", "conventional"});
    cut.direction = word == "climb"          ? CutDirection::climb
                    : word == "conventional" ? CutDirection::conventional
                                             : CutDirection::either;
  }
  if (stage.has("steep_angle")) cut.steep_angle_deg = stage.between("steep_angle", 0, 90);
  if (stage.has("overlap"))
    cut.overlap_mm = part_length_or_zero_mm(stage, "overlap", context.part_lengths);
  if (stage.has("boundary_pass")) cut.boundary_pass = stage.boolean("boundary_pass");
}

void read_entry(const TomlTable& stage, CutOptions& cut) {
  if (stage.has("entry")) {
    const std::string word = stage.one_of("entry", {"plunge", "ramp", "helix"});
    cut.entry = word == "plunge" ? Entry::plunge : word == "ramp" ? Entry::ramp : Entry::helix;
  }
  if (stage.has("ramp_angle")) cut.ramp_angle_deg = stage.between("ramp_angle", 0, 90);
}

constexpr const char* kLeanExpected = "an angle from -60 to 60 degrees";

void read_tilt(const TomlTable& stage, StagePlan& plan) {
  plan.tilt_place = stage.place("tilt");
  plan.tilt_is_auto = stage.is_text("tilt");
  if (plan.tilt_is_auto && stage.text("tilt") != "auto")
    throw model::InputError(plan.tilt_place, "\"tilt\" is \"" + stage.text("tilt") + "\"",
                            std::string(kLeanExpected) + ", or \"auto\"");
  if (plan.tilt_is_auto) return;
  plan.cut.lean->tilt_deg = stage.within("tilt", -kMostLean_deg, kMostLean_deg, kLeanExpected);
}

/// How the tool leans along its rows: none of it without `tilt`.
void read_lean(const TomlTable& stage, StagePlan& plan) {
  for (const char* key : {"lead", "lean_from"})
    if (stage.has(key) && !stage.has("tilt"))
      throw model::InputError(stage.place(key), "\"" + std::string(key) + "\" without \"tilt\"",
                              "tilt = \"auto\", or an angle from -60 to 60 degrees, 0 too");
  if (!stage.has("tilt")) return;
  ToolLean& lean = plan.cut.lean.emplace();
  read_tilt(stage, plan);
  if (stage.has("lead"))
    lean.lead_deg = stage.within("lead", -kMostLean_deg, kMostLean_deg, kLeanExpected);
  if (stage.has("lean_from"))
    lean.from = stage.one_of("lean_from", {"vertical", "surface"}) == "surface"
                    ? LeanFrom::surface
                    : LeanFrom::vertical;
  if (plan.cut.boundary_pass)
    throw model::InputError(stage.place("boundary_pass"), "\"boundary_pass\" beside \"tilt\"",
                            "rows alone, which is what leans");
}

void read_feeds(const TomlTable& stage, CutOptions& cut) {
  cut.feed_mm_min = stage.rate_mm_min("feed");
  cut.plunge_feed_mm_min = stage.has("plunge_feed") ? stage.rate_mm_min("plunge_feed")
                                                    : cut.feed_mm_min * kDefaultPlungeShare;
  cut.link_feed_mm_min = stage.has("link_feed") ? stage.rate_mm_min("link_feed") : cut.feed_mm_min;
}

}  // namespace

StagePlan read_plan(const TomlTable& stage, const std::string& name, JobContext& context) {
  StagePlan plan;
  plan.cut.strategy = read_strategy(stage);
  plan.cut.step_mm = part_length_mm(stage, "step", context.part_lengths);
  if (stage.has("scallop"))
    plan.cut.scallop_mm = part_length_mm(stage, "scallop", context.part_lengths);
  plan.cut.tolerance_mm = part_length_mm(stage, "tolerance", context.part_lengths);
  read_shape(stage, plan.cut, context);
  read_entry(stage, plan.cut);
  read_feeds(stage, plan.cut);
  read_lean(stage, plan);
  check_uses(stage, name, plan.cut, context);
  if (stage.has("floor")) plan.floor_z_mm = stage.coordinate_mm("floor");
  return plan;
}

}  // namespace limitgauge::app
