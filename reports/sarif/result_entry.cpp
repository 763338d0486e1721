#include "reports/sarif/result_entry.h"

#include "reports/sarif/fingerprint.h"
#include "reports/text/text.h"

namespace limitgauge::reports::sarif {
namespace {

/// Brackets and braces mean links and placeholders in SARIF's messages.
std::string message_text(const std::string& text) {
  std::string out;
  for (const char c : clean_text(text)) {
    if (c == '[' || c == ']' || c == '\\') out += '\\';
    if (c == '{' || c == '}') out += c;
    out += c;
  }
  return out;
}

std::string at(const model::Vec3& p) {
  return "(" + fixed(p.x, 3) + ", " + fixed(p.y, 3) + ", " + fixed(p.z, 3) + ") mm";
}

std::optional<double> limit_of(const StageResult& stage, const ListedFinding& f) {
  const verifier::GateLimits& l = stage.limits;
  if (f.kind == "gouge" && l.has_gouge) return l.gouge_mm;
  if (f.kind == "uncut" && l.has_uncut) return l.uncut_mm;
  if (f.kind == "missing_stock" && l.has_gouge) return l.gouge_mm;
  return {};
}

/// What a length of the finding is called.
std::string size_words(const ListedFinding& f) {
  if (f.kind == "near_miss") return measured_length(-f.depth_mm) + " away";
  if (f.kind == "uncut") return measured_length(f.depth_mm) + " high";
  return measured_length(f.depth_mm) + " deep";
}

std::string message(const RunResult& result, const ListedFinding& f) {
  const StageResult& stage = result.stages[f.stage];
  std::string text = stage.name + " " + f.id + ": " + f.words + "; " + size_words(f);
  if (const auto limit = limit_of(stage, f))
    text += (f.significance == Significance::undecided ? ", not decided against the limit "
                                                       : ", limit ") +
            stated_length(*limit);
  text += "; at " + at(f.point);
  if (f.place)
    text += ", patch " + std::to_string(f.place->patch) + ", u " + three_digits(f.place->u) +
            ", v " + three_digits(f.place->v);
  if (f.program_stage != f.stage)
    text += "; by a move of stage " + result.stages[f.program_stage].name;
  return message_text(text);
}

Json properties(const RunResult& result, const ListedFinding& f) {
  Json out = {{"id", f.id},
              {"stage", clean_text(result.stages[f.stage].name)},
              {f.kind == "near_miss" ? "distance_mm" : "depth_mm",
               f.kind == "near_miss" ? -f.depth_mm : f.depth_mm},
              {"point_mm", {f.point.x, f.point.y, f.point.z}}};
  if (const auto limit = limit_of(result.stages[f.stage], f)) out["limit_mm"] = *limit;
  if (f.area_mm2) out["area_mm2"] = *f.area_mm2;
  if (f.place) out["patch"] = f.place->patch, out["u"] = f.place->u, out["v"] = f.place->v;
  if (!f.body.empty()) out["body"] = clean_text(f.body);
  if (f.line > 0) out["move"] = f.move;
  if (!f.process) return out;
  out["against"] = clean_text(f.process->against);
  out["count"] = f.process->count;
  out["first_line"] = f.process->first_line, out["last_line"] = f.process->last_line;
  return out;
}

Json location_of(const Places& places, const std::string& stage, std::size_t program,
                 std::uint32_t line) {
  return {{"physicalLocation", places.location(program, line)},
          {"logicalLocations", {{{"name", stage}, {"kind", "stage"}}}}};
}

/// The passes around a leftover; the ends of a run of moves.
Json related(const RunResult& result, const ListedFinding& f, const Places& places) {
  Json out = Json::array();
  const auto add = [&](std::size_t stage, std::uint32_t line, const std::string& words) {
    if (line == 0) return;
    out.push_back({{"id", out.size() + 1},
                   {"physicalLocation", places.location(stage, line)},
                   {"message", {{"text", message_text(words)}}}});
  };
  for (const verifier::NearPass& pass : f.passes)
    if (pass.stage < result.stages.size())
      add(pass.stage, pass.line,
          "a pass of stage " + result.stages[pass.stage].name + ", " +
              measured_length(pass.distance_mm) + " from the deepest place");
  if (f.process && f.process->first_line != f.process->last_line) {
    add(f.stage, f.process->first_line, "the first of these moves");
    add(f.stage, f.process->last_line, "the last of these moves");
  }
  return out;
}

}  // namespace

const char* level_of(Significance significance) {
  switch (significance) {
    case Significance::fails:
      return "error";
    case Significance::undecided:
      return "warning";
    default:
      return "note";
  }
}

Json result_entry(const RunResult& result, const ListedFinding& f, const Places& places,
                  int ordinal) {
  const std::string stage = clean_text(result.stages[f.stage].name);
  const std::string count = ":" + std::to_string(ordinal);
  const std::string place = place_fingerprint(f, stage) + count;
  Json prints = {{"limitgaugePlace/v1", place}};
  const std::uint32_t first = f.process ? f.process->first_line : f.line;
  const std::string& line = places.text(f.program_stage, first);
  if (!line.empty()) prints["limitgaugeLine/v1"] = line_fingerprint(f, stage, line);
  // By this key GitHub's code scanning knows a finding again.
  prints["primaryLocationLineHash"] = place;
  Json out = {{"ruleId", f.kind},
              {"ruleIndex", rule_index(f.kind)},
              {"level", level_of(f.significance)},
              {"message", {{"text", message(result, f)}}},
              {"locations", {location_of(places, stage, f.program_stage, f.line)}}};
  Json others = related(result, f, places);
  if (!others.empty()) out["relatedLocations"] = std::move(others);
  out["partialFingerprints"] = std::move(prints);
  out["properties"] = properties(result, f);
  return out;
}

Json stage_entry(const RunResult& result, std::size_t stage, const char* rule, const char* level,
                 const std::string& message, const Places& places) {
  const std::string name = clean_text(result.stages[stage].name);
  const std::string print = hash_text("stage/1\n" + std::string(rule) + "\n" + name + "\n") + ":1";
  return {
      {"ruleId", rule},
      {"ruleIndex", rule_index(rule)},
      {"level", level},
      {"message", {{"text", message_text(name + ": " + message)}}},
      {"locations", {location_of(places, name, stage, 0)}},
      {"partialFingerprints", {{"limitgaugePlace/v1", print}, {"primaryLocationLineHash", print}}},
      {"properties", {{"stage", name}}}};
}

}  // namespace limitgauge::reports::sarif
