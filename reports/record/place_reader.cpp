#include <limits>

#include "reports/record/record_reader.h"

namespace limitgauge::reports::record {
namespace {

model::Vec3 point_of(const JsonValue& entry) {
  return {entry["x"].number(), entry["y"].number(), entry["z"].number()};
}

/// Lines count from 1: 0 stands for none.
std::optional<std::uint32_t> line_of(const JsonValue& entry) {
  const std::uint64_t line = entry["line"].count(std::numeric_limits<std::uint32_t>::max());
  return line > 0 ? std::optional(static_cast<std::uint32_t>(line)) : std::nullopt;
}

std::string text_of(const LineTexts& texts, const std::string& stage,
                    std::optional<std::uint32_t> line) {
  if (!line) return {};
  const auto found = texts.find({stage, *line});
  return found == texts.end() ? std::string{} : found->second;
}

double diagonal_of(const JsonValue& box) {
  const std::vector<JsonValue> corners = box.items();
  if (corners.size() != 2) box.refuse("has not two corners", "lower and upper corner");
  return model::distance(corners[0].point(), corners[1].point());
}

void read_surface_place(const JsonValue& place, Place& out) {
  out.at_mm = point_of(place);
  out.patch = static_cast<int>(place["patch"].count(std::numeric_limits<int>::max()));
  out.u = place["u"].share();
  out.v = place["v"].share();
}

/// Whose line it is, and by which body.
void read_maker(const JsonValue& entry, const std::string& name, const LineTexts& texts,
                Place& out) {
  out.line = line_of(entry);
  const std::optional<JsonValue> stage = entry.find("stage");
  out.stage = stage ? stage->text() : name;
  out.line_text = text_of(texts, out.stage, out.line);
  if (const std::optional<JsonValue> body = entry.find("body")) out.body = body->text();
}

Place read_place(const JsonValue& entry, const std::string& name, const LineTexts& texts) {
  Place out;
  read_surface_place(entry, out);
  out.depth_mm = entry["depth_mm"].length();
  out.area_mm2 = entry["area_mm2"].length();
  read_maker(entry, name, texts, out);
  if (const std::optional<JsonValue> box = entry.find("extent_mm"))
    out.extent_mm = diagonal_of(*box);
  return out;
}

ProcessFinding at_line(const JsonValue& entry, const std::string& name, const LineTexts& texts) {
  ProcessFinding out;
  out.at_mm = point_of(entry);
  out.line = line_of(entry);
  out.line_text = text_of(texts, name, out.line);
  return out;
}

ProcessFinding read_finding(const JsonValue& entry, const std::string& name,
                            const LineTexts& texts) {
  ProcessFinding out = at_line(entry, name, texts);
  out.kind = entry["kind"].text();
  out.fails = entry["fails"].flag();
  out.part = entry["part"].text();
  out.against = entry["against"].text();
  out.count = entry["count"].count();
  const std::optional<JsonValue> depth = entry.find("depth_mm");
  out.depth_mm = depth ? depth->length() : entry["distance_mm"].length();
  return out;
}

ProcessFinding read_collision(const JsonValue& entry, const std::string& kind,
                              const std::string& name, const LineTexts& texts) {
  ProcessFinding out = at_line(entry, name, texts);
  out.kind = kind;
  if (const std::optional<JsonValue> part = entry.find("part")) {
    out.part = part->text();
    if (out.part == "shank") out.kind = "shank_in_stock";
  }
  out.depth_mm = entry["depth_mm"].length();
  return out;
}

}  // namespace

std::vector<Place> read_places(const std::vector<JsonValue>& findings, const std::string& name,
                               const LineTexts& texts) {
  std::vector<Place> out;
  out.reserve(findings.size());
  for (const JsonValue& entry : findings) out.push_back(read_place(entry, name, texts));
  return out;
}

std::optional<Place> read_reached(const JsonValue& figure, const std::string& name,
                                  const LineTexts& texts) {
  const std::optional<JsonValue> place = figure.find("place");
  if (!place) return std::nullopt;
  Place out;
  read_surface_place(*place, out);
  out.depth_mm = figure["low"].length();
  out.stage = name;
  if (figure.find("line")) read_maker(figure, name, texts, out);  // none where raw stock stands
  return out;
}

std::vector<ProcessFinding> read_process(const JsonValue& simulation, const std::string& name,
                                         const StageContext& run) {
  const LineTexts& texts = run.texts;
  std::vector<ProcessFinding> out;
  if (run.has_process || simulation.find("findings")) {
    for (const JsonValue& entry : simulation["findings"].items())
      out.push_back(read_finding(entry, name, texts));
    return out;
  }
  for (const JsonValue& entry : simulation["rapid_collisions"].items())
    out.push_back(read_collision(entry, "rapid_through_stock", name, texts));
  for (const JsonValue& entry : simulation["holder_collisions"].items())
    out.push_back(read_collision(entry, "holder_in_stock", name, texts));
  return out;
}

std::vector<ProcessCount> count_process(const std::vector<ProcessFinding>& findings) {
  std::map<std::string, std::size_t> by_kind;
  for (const ProcessFinding& finding : findings) by_kind[finding.kind] += finding.count;
  std::vector<ProcessCount> out;
  for (const auto& [kind, count] : by_kind) out.push_back({kind, count});
  return out;
}

}  // namespace limitgauge::reports::record
