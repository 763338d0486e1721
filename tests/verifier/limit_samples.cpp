#include "tests/verifier/limit_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace limitgauge::tests {
namespace {

using model::Cage;
using model::Index;
using Kind = VertexClass::Kind;

std::string words(const VertexClass& c) {
  const std::string count = (c.count < 10 ? "0" : "") + std::to_string(c.count);
  switch (c.kind) {
    case Kind::interior:
      return c.count == 4 ? "regular" : "interior, valence " + count;
    case Kind::boundary:
      return c.count == 2 ? "regular boundary" : "boundary, faces " + count;
    case Kind::crease:
      return "crease, valence " + count;
    case Kind::dart:
      return "dart, valence " + count;
    case Kind::corner:
      return "corner";
    case Kind::semi_sharp:
      return "semi-sharp";
  }
  return {};
}

/// A refined face: the patch it lies in and its corners' parameters.
struct Tracked {
  int patch = 0;
  std::array<std::array<double, 2>, 4> uv{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

  /// The child that begins with corner k.
  Tracked child(int k) const {
    const auto middle = [&](int m) {
      return std::array<double, 2>{(uv[k][0] + uv[m][0]) / 2, (uv[k][1] + uv[m][1]) / 2};
    };
    return {patch, {uv[k], middle((k + 1) % 4), middle((k + 2) % 4), middle((k + 3) % 4)}};
  }
};

/// The faces of the once refined cage.
std::vector<Tracked> first_faces(const Cage& cage) {
  std::vector<Tracked> faces;
  int patch = 0;
  for (Index f = 0; f < cage.face_count(); ++f) {
    const int corners = static_cast<int>(cage.face(f).size());
    for (int k = 0; k < corners; ++k)
      faces.push_back(corners == 4 ? Tracked{patch}.child(k) : Tracked{patch + k});
    patch += corners == 4 ? 1 : corners;
  }
  return faces;
}

}  // namespace

CornerKinds::CornerKinds(const Cage& cage) {
  const auto own = vertex_classes(cage);
  const Cage refined = refine_uniformly(cage);
  const auto after = vertex_classes(refined);
  Index child = 0;
  for (Index f = 0; f < cage.face_count(); ++f) {
    const auto face = cage.face(f);
    if (face.size() == 4) {
      kinds_.push_back(
          {words(own[face[0]]), words(own[face[1]]), words(own[face[2]]), words(own[face[3]])});
    } else {
      for (std::size_t k = 0; k < face.size(); ++k) {
        const auto at = refined.face(child + static_cast<Index>(k));
        kinds_.push_back({words(own[face[k]]), words(after[at[1]]),
                          "n-gon centre, corners " + std::to_string(face.size()),
                          words(after[at[3]])});
      }
    }
    child += static_cast<Index>(face.size());
  }
}

std::vector<LimitSample> limit_samples(const Cage& cage, int levels) {
  const CornerKinds kinds(cage);
  std::vector<Tracked> tracked = first_faces(cage);
  Cage refined = refine_uniformly(cage);
  for (int level = 1; level < levels; ++level) {
    refined = refine_uniformly(refined);
    std::vector<Tracked> next;
    for (const Tracked& t : tracked)
      for (int k = 0; k < 4; ++k) next.push_back(t.child(k));
    tracked = std::move(next);
  }
  const auto limits = limit_positions(refined);
  std::vector<LimitSample> samples;
  for (Index f = 0; f < refined.face_count(); ++f)
    for (int k = 0; k < 4; ++k) {
      const auto& limit = limits[refined.face(f)[k]];
      const auto& t = tracked[f];
      if (limit)
        samples.push_back({t.patch, t.uv[k][0], t.uv[k][1], *limit,
                           kinds.nearest(t.patch, t.uv[k][0], t.uv[k][1])});
    }
  return samples;
}

int levels_of_sharpness(const Cage& cage) {
  double most = 0;
  for (const auto& c : cage.creases) most = std::max(most, c.sharpness < 10 ? c.sharpness : 0);
  for (const auto& c : cage.corners) most = std::max(most, c.sharpness < 10 ? c.sharpness : 0);
  return static_cast<int>(std::ceil(most));
}

double size_of(const Cage& cage) {
  model::Box3 box;
  for (const model::Vec3& v : cage.vertices) box.add(v);
  return length(box.size());
}

void ErrorTable::add(const std::string& kind, double error) {
  Row& row = rows[kind];
  ++row.samples;
  row.worst = std::max(row.worst, error);
}

void ErrorTable::add(const ErrorTable& other) {
  for (const auto& [kind, row] : other.rows) {
    rows[kind].samples += row.samples;
    rows[kind].worst = std::max(rows[kind].worst, row.worst);
  }
}

double ErrorTable::worst() const {
  double most = 0;
  for (const auto& [kind, row] : rows) most = std::max(most, row.worst);
  return most;
}

std::string ErrorTable::text() const {
  std::string out;
  for (const auto& [kind, row] : rows) {
    char line[120];
    std::snprintf(line, sizeof line, "%-28s %8ld points  worst %.1e\n", kind.c_str(), row.samples,
                  row.worst);
    out += line;
  }
  return out;
}

ErrorTable evaluator_errors(const Cage& cage, int levels) {
  const verifier::ReferenceSurface surface(cage);
  ErrorTable table;
  for (const LimitSample& s : limit_samples(cage, levels))
    if (surface.has_surface(s.patch))
      table.add(s.kind,
                distance(surface.evaluate(s.patch, s.u, s.v).position, s.position) / size_of(cage));
  return table;
}

}  // namespace limitgauge::tests
