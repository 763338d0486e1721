#include "tests/support/feature_cages.h"

#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/cages.h"

namespace limitgauge::tests {
namespace {

using model::BoundaryRule;
using model::Cage;
using model::Index;
using model::Vec3;

Cage named(Cage cage, const std::string& name) {
  cage.name = name;
  return cage;
}

Cage creased_cube(const std::string& name, const std::vector<model::Crease>& creases,
                  const std::vector<model::Corner>& corners = {}) {
  Cage cage = named(cube_cage(), name);
  cage.vertices[7] = {1.3, 0.9, 1.2};  // off symmetry
  cage.creases = creases;
  cage.corners = corners;
  return cage;
}

/// All edges of the top face (4, 5, 7, 6): a loop of crease.
std::vector<model::Crease> top_loop(double s) {
  return {{{4, 5}, s}, {{5, 7}, s}, {{6, 7}, s}, {{4, 6}, s}};
}

Cage waved_grid(int nx, int ny, BoundaryRule rule) {
  return grid_cage(
      nx, ny,
      [](int i, int j) {
        return Vec3{10.0 * i + j % 2, 9.0 * j + i, 3.0 * ((i * 7 + j * 5) % 4)};
      },
      rule);
}

/// A polygon with a ring of quads and triangles in turn around it.
Cage ringed_polygon(int sides, BoundaryRule rule) {
  Cage cage = named({}, "ringed polygon of " + std::to_string(sides));
  cage.boundary = rule;
  std::vector<Index> inner;
  for (int k = 0; k < 2 * sides; ++k) {
    const double angle = 2 * std::numbers::pi * (k % sides) / sides, r = k < sides ? 5 : 11;
    cage.vertices.push_back({r * std::cos(angle), r * std::sin(angle), std::cos(2.0 * k)});
    if (k < sides) inner.push_back(k);
  }
  cage.add_face(inner);
  for (Index k = 0; k < sides; ++k) {
    const Index next = (k + 1) % sides;
    if (k % 2 == 0) {
      cage.add_face(std::array<Index, 4>{k, sides + k, sides + next, next});
    } else {
      cage.add_face(std::array<Index, 3>{k, sides + k, sides + next});
      cage.add_face(std::array<Index, 3>{k, sides + next, next});
    }
  }
  return cage;
}

/// Two quads back to back: four interior vertices of valence two.
Cage pillow() {
  Cage cage = named({}, "valence 2");
  cage.vertices = {{0, 0, 0}, {10, 0, 1}, {11, 9, 0}, {-1, 10, 2}};
  cage.add_face(std::array<Index, 4>{0, 1, 2, 3});
  cage.add_face(std::array<Index, 4>{3, 2, 1, 0});
  return cage;
}

void add_stars(std::vector<Cage>& all) {
  for (const int n : {3, 4, 5, 6, 7, 8, 9, 12, 20, 35, 50}) {
    all.push_back(named(star_cage(n, 2), "valence " + std::to_string(n)));
    all.push_back(named(sharp_star(n, 10, {0}), "dart in valence " + std::to_string(n)));
    all.push_back(named(sharp_star(n, 12, {0, n / 2}), "crease in valence " + std::to_string(n)));
    all.push_back(named(sharp_star(n, 10, {0, 1}), "bent crease in " + std::to_string(n)));
  }
  for (const int n : {3, 5, 9}) {
    all.push_back(named(sharp_star(n, 10, {0, 1, 2}), "three creases in " + std::to_string(n)));
    all.push_back(named(sharp_star(n, 0, {}, 10), "spike in " + std::to_string(n)));
    all.push_back(named(sharp_star(n, 10, {1}, 11), "slit in " + std::to_string(n)));
    for (const double s : {0.3, 1.5, 2.7}) {
      if (n > 5) continue;  // they add nothing but time
      const std::string of = std::to_string(n) + " of " + std::to_string(s);
      all.push_back(named(sharp_star(n, s, {0}), "soft dart in " + of));
      all.push_back(named(sharp_star(n, s, {0, 1, 2}), "soft creases in " + of));
      all.push_back(named(sharp_star(n, 10, {0}, s), "soft vertex on a dart in " + of));
      all.push_back(named(sharp_star(n, 0, {}, s), "soft vertex in " + of));
    }
  }
  Cage crossing = named(sharp_star(8, 10, {0, 2, 4, 6}), "crossing creases");
  all.push_back(crossing);
  // Spoke ends are vertices 1, 3, 5, ... and have 17, 19, ... on the boundary beyond them.
  crossing.name = "creases that end at the boundary";
  for (Index k = 1; k < 17; k += 4) crossing.creases.push_back({{k, k + 16}, k == 1 ? 1.6 : 10});
  all.push_back(crossing);
}

void add_grids(std::vector<Cage>& all) {
  for (const auto rule :
       {BoundaryRule::none, BoundaryRule::edge_and_corner, BoundaryRule::edge_only}) {
    const std::string of = " by boundary rule " + std::to_string(static_cast<int>(rule));
    all.push_back(named(waved_grid(4, 3, rule), "grid" + of));
    Cage cut = named(waved_grid(4, 4, rule), "grid with creases to the rim" + of);
    cut.creases = {{{2, 7}, 10}, {{7, 12}, 0.7}, {{10, 11}, 2.3}};
    cut.corners = {{12, 0.4}, {3, 1.2}, {24, 0.6}};
    all.push_back(cut);
    for (const int sides : {5, 6, 7}) all.push_back(ringed_polygon(sides, rule));
  }
  // Of 25 vertices, 5 a row: what rule 0 leaves out depends on the creases along the rim.
  Cage rim = named(waved_grid(4, 4, BoundaryRule::none), "grid with a sharp rim");
  for (Index k = 0; k < 4; ++k)
    for (const Index from : {k, 20 + k}) rim.creases.push_back({{from, from + 1}, 10});
  for (Index k = 0; k < 20; k += 5)
    for (const Index from : {k, 4 + k}) rim.creases.push_back({{from, from + 5}, 10});
  all.push_back(rim);
  Cage part = named(waved_grid(4, 4, BoundaryRule::none), "grid with a rim sharp in part");
  part.creases = {{{0, 1}, 10}, {{1, 2}, 12}, {{0, 5}, 10}, {{5, 10}, 10}, {{10, 15}, 1.5}};
  all.push_back(part);
  // What is a little more than a whole number runs out a step later than the number.
  for (const double s : {3.0000000000000004, 2.0000001, 1e-46, 2.9999999999}) {
    Cage soft = named(waved_grid(4, 4, BoundaryRule::edge_only), "creases of nearly a number");
    soft.creases = {{{11, 12}, s}, {{12, 13}, std::ceil(s) + 0.5}};
    all.push_back(soft);
  }
  for (const int m : {1, 2, 3, 4, 5, 8, 20}) {
    const auto of = std::to_string(m);
    all.push_back(named(boundary_fan(m, BoundaryRule::edge_only), "boundary fan " + of));
    Cage cornered = named(boundary_fan(m, BoundaryRule::edge_and_corner), "corner fan " + of);
    cornered.corners = {{0, 10}};
    all.push_back(cornered);
  }
}

}  // namespace

Cage sharp_star(int valence, double edge_sharpness, const std::vector<int>& edges,
                double vertex_sharpness) {
  Cage cage = star_cage(valence, 2);
  cage.vertices[1] += {0.7, -0.4, 0.5};  // off symmetry
  cage.vertices[4] += {-0.3, 0.8, 1};
  for (const int k : edges) cage.creases.push_back({{0, 1 + 2 * k}, edge_sharpness});
  if (vertex_sharpness > 0) cage.corners.push_back({0, vertex_sharpness});
  return cage;
}

Cage boundary_fan(int faces, BoundaryRule rule) {
  Cage cage;
  cage.boundary = rule;
  cage.vertices.push_back({0, 0, 1});
  for (const double r : {10.0, 22.0})
    for (int k = 0; k <= 2 * faces; ++k) {
      const double angle = std::numbers::pi * k / (2 * faces);
      cage.vertices.push_back(
          {r * std::cos(angle), r * std::sin(angle), 2 * std::cos(3 * angle + r)});
    }
  const Index row = 2 * faces + 1;
  for (Index k = 1; k < row; k += 2) cage.add_face(std::array<Index, 4>{0, k, k + 1, k + 2});
  for (Index k = 1; k < row; ++k)
    cage.add_face(std::array<Index, 4>{k, k + row, k + row + 1, k + 1});
  return cage;
}

Cage prism(int sides) {
  Cage cage = named({}, "prism of " + std::to_string(sides));
  std::vector<Index> top, bottom;
  for (int k = 0; k < 2 * sides; ++k) {
    const double angle = 2 * std::numbers::pi * (k % sides) / sides;
    cage.vertices.push_back(
        {8 * std::cos(angle), 8 * std::sin(angle), (k < sides ? -4 : 5) + std::cos(5.0 * k)});
    if (k < sides)
      bottom.insert(bottom.begin(), k);
    else
      top.push_back(k);
  }
  cage.add_face(top);
  cage.add_face(bottom);
  for (Index k = 0; k < sides; ++k) {
    const Index next = (k + 1) % sides;
    cage.add_face(std::array<Index, 4>{k, next, sides + next, sides + k});
  }
  return cage;
}

std::vector<Cage> feature_cages() {
  std::vector<Cage> all = {cube_cage(), pillow()};
  for (const int sides : {3, 5, 6, 7}) all.push_back(prism(sides));
  for (const double s : {0.3, 1.0, 1.5, 2.7, 10.0})
    all.push_back(creased_cube("crease loop of " + std::to_string(s), top_loop(s)));
  all.push_back(creased_cube("open crease", {{{4, 5}, 10}, {{5, 7}, 10}}));
  all.push_back(creased_cube(
      "mixed creases", {{{4, 5}, 10}, {{5, 7}, 0.3}, {{7, 3}, 2.7}, {{6, 7}, 1.5}, {{0, 1}, 0.5}}));
  all.push_back(creased_cube("corners", top_loop(1.2), {{5, 10}, {0, 0.3}, {3, 2.7}, {4, 1.5}}));
  all.push_back(creased_cube("all sharp", {{{0, 1}, 10},
                                           {{1, 3}, 10},
                                           {{3, 2}, 10},
                                           {{2, 0}, 10},
                                           {{4, 5}, 10},
                                           {{5, 7}, 10},
                                           {{7, 6}, 10},
                                           {{6, 4}, 10},
                                           {{0, 4}, 10},
                                           {{1, 5}, 10},
                                           {{3, 7}, 10},
                                           {{2, 6}, 10}}));
  Cage holed = creased_cube("closed with a hole", {{{4, 5}, 1.5}});
  holed.holes = {1, 4};
  all.push_back(holed);
  add_stars(all);
  add_grids(all);
  return all;
}

}  // namespace limitgauge::tests
