#include "reports/html/job/surface_section.h"

#include <fmt/format.h>

#include "reports/html/markup.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

/// The rules that shape this cage's surface, in words.
std::string rules_text(const verifier::SurfaceRules& r) {
  std::string text = "Catmull-Clark, boundary ";
  switch (r.boundary) {
    case model::BoundaryRule::none:
      text += "none (faces at it are no surface)";
      break;
    case model::BoundaryRule::edge_and_corner:
      text += "edge and corner";
      break;
    case model::BoundaryRule::edge_only:
      text += "edge only";
      break;
  }
  const auto add = [&](model::Index count, const char* what) {
    if (count > 0) text += fmt::format(", {} {}", count, what);
  };
  add(r.sharp_edges, "sharp edges"), add(r.semi_sharp_edges, "semi-sharp edges, uniform");
  add(r.sharp_vertices, "sharp vertices"), add(r.semi_sharp_vertices, "semi-sharp vertices");
  add(r.darts, "darts"), add(r.holes, "holes");
  return text;
}

std::string witness_text(const witness::Agreement& w) {
  std::string text =
      fmt::format("{}: {} limit points within {} mm, {} normals within {} rad",
                  escape_markup(w.evaluator), grouped(w.points), typeset(three_digits(w.worst_mm)),
                  grouped(w.normals), typeset(three_digits(w.worst_normal_rad)));
  text += fmt::format(" (rounding may amount to {} mm)", typeset(three_digits(w.bound_mm)));
  if (w.normals_left_out > 0)
    text += fmt::format("; {} normals at sharp or irregular places not compared",
                        grouped(w.normals_left_out));
  if (w.points_left_out > 0)
    text += fmt::format("; {} points not compared", grouped(w.points_left_out));
  return text;
}

}  // namespace

std::string surface_section(const SurfaceResult& s) {
  const model::Vec3 size = s.bbox_mm.size();
  return "<section id=\"surface\"><h2>Design surface</h2>\n" +
         terms(
             {{"Size of the limit surface", fmt::format("{} × {} × {} mm", fixed(size.x, 3),
                                                        fixed(size.y, 3), fixed(size.z, 3))},
              {"Area", three_digits(s.area_mm2) + " mm²"},
              {"Patches", grouped(std::uint64_t(s.summary.patches))},
              {"Faces of the cage", grouped(std::uint64_t(s.summary.faces))},
              {"Boundary edges", grouped(std::uint64_t(s.summary.boundary_edges))},
              {"Extraordinary vertices", grouped(std::uint64_t(s.summary.extraordinary_vertices))},
              {"Rules of the surface", rules_text(s.rules)},
              {"Held against", witness_text(s.witness)}}) +
         "</section>\n";
}

}  // namespace limitgauge::reports::html
