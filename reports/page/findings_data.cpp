#include "reports/page/findings_data.h"

#include <algorithm>
#include <cmath>

#include "reports/run/finding_list.h"
#include "reports/run/process.h"
#include "reports/run/program_lines.h"
#include "reports/text/text.h"

namespace limitgauge::reports::page {
namespace {

constexpr std::uint32_t kLinesAround = 3;

std::string id(char letter, std::size_t index) {
  return letter + std::to_string(index + 1);
}

/// The normal of the measured sample nearest to a place; null where its patch was not sampled.
Json normal_near(const verifier::DeviationField& field, const verifier::SurfacePlace& place) {
  const auto has_place = [&](const verifier::DeviationField::Grid& grid) {
    return grid.patch <= place.patch && place.patch < grid.patch + grid.patches;
  };
  const auto grid = std::find_if(field.grids.begin(), field.grids.end(), has_place);
  if (grid == field.grids.end()) return nullptr;
  const auto first = field.samples.begin() + grid->first;
  const auto nearer = [&](const auto& a, const auto& b) {
    return length_squared(a.place.point - place.point) <
           length_squared(b.place.point - place.point);
  };
  const std::size_t count = std::size_t(grid->columns) * grid->rows;
  return point_json(std::min_element(first, first + std::ptrdiff_t(count), nearer)->normal);
}

Json finding_json(const verifier::Finding& f, const verifier::DeviationField& field,
                  const MeshDesign* mesh, std::string name) {
  Json out = {{"id", std::move(name)},
              {"point_mm", point_json(f.place.point)},
              {"normal", normal_near(field, f.place)},
              {"depth_mm", f.depth_mm},
              {"area_mm2", f.area_mm2},
              {"patch", f.place.patch},
              {"u", f.place.u},
              {"v", f.place.v},
              {"stage", f.stage},
              {"line", f.line},
              {"move", f.move},
              {"raw_stock", f.raw_stock},
              {"body", clean_text(f.body)}};
  if (mesh != nullptr) out["triangle"] = mesh->triangle_of(f.place.patch);
  if (!f.extent_mm.empty())
    out["extent_mm"] = {point_json(f.extent_mm.low), point_json(f.extent_mm.high)};
  for (const verifier::NearPass& p : f.passes)
    out["passes"].push_back(
        {{"stage", p.stage}, {"line", p.line}, {"move", p.move}, {"distance_mm", p.distance_mm}});
  return out;
}

Json findings_list(const std::vector<verifier::Finding>& findings,
                   const verifier::DeviationField& field, const MeshDesign* mesh, char letter) {
  Json out = Json::array();
  for (std::size_t i = 0; i < std::min(findings.size(), kMostFindings); ++i)
    out.push_back(finding_json(findings[i], field, mesh, id(letter, i)));
  return out;
}

/// The worst place of a figure over tolerances, and the values that lead to it.
Json tolerated_json(const verifier::RobustFigure& f, const MeshDesign* mesh, const char* name) {
  Json out = {{"id", name},
              {"point_mm", point_json(f.place->point)},
              {"normal", point_json(f.normal)},
              {"depth_mm", f.figure_mm.low},
              {"patch", f.place->patch},
              {"u", f.place->u},
              {"v", f.place->v},
              {"stage", f.stage},
              {"line", f.line},
              {"move", f.move},
              {"raw_stock", f.raw_stock},
              {"body", clean_text(f.body)},
              {"with", clean_text(values_text(f.at))}};
  if (mesh != nullptr) out["triangle"] = mesh->triangle_of(f.place->patch);
  return out;
}

Json tolerated_list(const verifier::RobustDeviation& robust, const MeshDesign* mesh) {
  Json out = Json::array();
  if (robust.gouge.place) out.push_back(tolerated_json(robust.gouge, mesh, "GT"));
  if (robust.uncut.place) out.push_back(tolerated_json(robust.uncut, mesh, "UT"));
  return out;
}

Json process_list(const std::vector<simulator::FindingGroup>& groups) {
  Json out = Json::array();
  for (std::size_t i = 0; i < std::min(groups.size(), kMostFindings); ++i) {
    const simulator::FindingGroup& g = groups[i];
    out.push_back({{"id", id('P', i)},
                   {"kind", simulator::name(g.kind)},
                   {"words", description(g.kind)},
                   {"fails", fails(g.kind)},
                   {"line", g.worst.line},
                   {"move", g.worst.move},
                   {"first_line", g.first_line},
                   {"last_line", g.last_line},
                   {"count", g.count},
                   {"point_mm", point_json(g.worst.point)},
                   {"depth_mm", g.worst.depth_mm},
                   {"part", clean_text(g.part)},
                   {"against", clean_text(g.against)}});
  }
  return out;
}

/// Lines of stage `named`'s program that the passes around leftovers of stage `by` name.
void add_passes(const StageResult& by, std::size_t named, std::vector<std::uint32_t>& lines) {
  if (!by.ran || !by.ran->deviation) return;
  const std::vector<verifier::Finding>& uncuts = by.ran->deviation->uncuts;
  for (std::size_t i = 0; i < std::min(uncuts.size(), kMostFindings); ++i)
    for (const verifier::NearPass& p : uncuts[i].passes)
      if (p.stage == named) lines.push_back(p.line);
}

}  // namespace

Json point_json(const model::Vec3& p) {
  return {p.x, p.y, p.z};
}

Json findings_data(const StageRun& ran, const MeshDesign* mesh) {
  const std::vector<simulator::FindingGroup> groups = worst_first(ran.process);
  Json out = {{"process", process_list(groups)}, {"process_total", groups.size()}};
  if (!ran.deviation) return out;
  const verifier::StageDeviation& d = *ran.deviation;
  out["gouges"] = findings_list(d.gouges, d.field, mesh, 'G');
  out["gouges_total"] = d.gouges.size();
  out["uncuts"] = findings_list(d.uncuts, d.field, mesh, 'U');
  out["uncuts_total"] = d.uncuts.size();
  if (d.robust) out["tolerated"] = tolerated_list(*d.robust, mesh);
  return out;
}

Json text_data(const RunResult& result, std::size_t index, Blob& blob) {
  const StageResult& stage = result.stages[index];
  std::vector<std::uint32_t> wanted, lines;
  for (std::size_t by = 0; by < result.stages.size(); ++by) {
    for (const NamedLine& named : named_lines(result, by, kMostFindings))
      if (named.stage == index) wanted.push_back(named.line);
    add_passes(result.stages[by], index, wanted);
  }
  std::vector<std::uint8_t> utf8;
  if (stage.ran && stage.ran->program_text)
    for (const ProgramLine& l : program_lines(*stage.ran->program_text, wanted, kLinesAround)) {
      lines.push_back(l.line);
      utf8.insert(utf8.end(), l.text.begin(), l.text.end());
      utf8.push_back('\n');
    }
  return {{"line", blob.add(lines)}, {"utf8", blob.add(utf8)}};
}

}  // namespace limitgauge::reports::page
