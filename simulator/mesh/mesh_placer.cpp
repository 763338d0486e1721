#include "simulator/mesh/mesh_placer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "simulator/mesh/surface_points.h"
#include "simulator/process/near_material.h"
#include "simulator/tolerance.h"

namespace limitgauge::simulator {
namespace {

using model::Vec3;

constexpr int kMostSteps = 12;
constexpr std::size_t kMostFaces = 6;

// A face of the surface about a cell, with its normal where it was met and in the cell's middle.
struct Face {
  SurfaceMaker maker;
  Vec3 normal, in_middle;
};

double sine_between(const Face& a, const Face& b) {
  if (a.maker == b.maker && a.normal == b.normal) return 0;
  return a.maker == b.maker ? length(cross(a.normal, b.normal))
                            : length(cross(a.in_middle, b.in_middle));
}

bool sharp(const Face& a, const Face& b) {
  return sine_between(a, b) > (a.maker == b.maker ? kSharpOfOneSine : kSharpSine);
}

Vec3 middle_of(std::span<const Vec3> crossings) {
  Vec3 middle;
  for (const Vec3& p : crossings) middle += p / static_cast<double>(crossings.size());
  return middle;
}

class MiddlePlacer : public NetPlacer {
 public:
  Vec3 place(const Index3&, std::span<const Vec3> crossings) override {
    return middle_of(crossings);
  }
};

class ExactPlacer : public NetPlacer {
 public:
  ExactPlacer(const Material& material, const Lattice& lattice, std::atomic<std::size_t>& unmoved)
      : material_(material, lattice), lattice_(lattice), unmoved_(unmoved) {}

  Vec3 place(const Index3& cell, std::span<const Vec3> crossings) override {
    material_.turn_to(cell);
    const Vec3 middle = middle_of(crossings);
    const auto faces = faces_about(cell, crossings, middle);
    if (const auto edge = sharp_place(cell, middle, faces)) return *edge;
    if (faces.size() == 1)
      if (const auto onto = place_on(faces[0].maker, middle)) return *onto;
    const StockPoint onto = project_to_surface(material_, middle, lattice_.voxel_mm, hint_);
    if (onto.residual_mm <= kOnSurface_mm && distance(onto.position, middle) <= lattice_.voxel_mm)
      return onto.position;
    ++unmoved_;
    return middle;
  }

 private:
  // They are good until the next cell's.
  std::span<const Face> faces_about(const Index3& cell, std::span<const Vec3> crossings,
                                    const Vec3& middle) {
    std::size_t count = 0;
    for (const Vec3& p : crossings) {
      const MaterialSample& s = sample(cell, p, middle);
      hint_ = s.maker;
      const Face face{s.maker, s.gradient, s.gradient};
      const bool known = std::any_of(faces_.begin(), faces_.begin() + count, [&](const Face& f) {
        return f.maker == face.maker && !sharp(f, face);
      });
      if (!known && count < kMostFaces) faces_[count++] = face;
    }
    const std::span<Face> faces = std::span(faces_).first(count);
    if (count > 1)
      for (Face& f : faces) f.in_middle = material_.sample_of(f.maker, middle).gradient;
    return faces;
  }

  // One step onto a maker's surface, where that is the material's and the step is enough: of balls
  // and planes it is.
  std::optional<Vec3> place_on(SurfaceMaker maker, const Vec3& from) const {
    const MaterialSample s = material_.sample_of(maker, from);
    const Vec3 p = from - s.gradient * s.value;
    if (std::abs(s.value) > lattice_.voxel_mm) return std::nullopt;
    return on_surface(p, maker) ? std::optional(p) : std::nullopt;
  }

  // The maker and its normal at a crossing, remembered for the cells beside this one. Looked at
  // from a little further out: a crossing in an edge of the surface then shows the face that the
  // cell's others do not.
  const MaterialSample& sample(const Index3& cell, const Vec3& crossing, const Vec3& middle) {
    Known& known = known_[place_of(crossing)];
    if (known.at == crossing) return known.sample;
    const auto from_outside = [&](const Vec3& p) {
      return material_.sample(p + (p - middle) * kFurtherOut, hint_);
    };
    known = {crossing, from_outside(crossing)};
    if (std::abs(known.sample.value) >= kOffCrossing_voxels * lattice_.voxel_mm)
      known.sample = from_outside(exact_crossing(cell, crossing));
    return known.sample;
  }

  // Beside an edge the level set is not linear, and its crossing of the cell's edge may be off by
  // much of a voxel: it is halved down to there.
  Vec3 exact_crossing(const Index3& cell, const Vec3& crossing) const {
    constexpr int kHalvings = 10;
    const Vec3 low = lattice_.point(cell),
               high = lattice_.point({cell[0] + 1, cell[1] + 1, cell[2] + 1});
    int axis = 0;
    while (axis < 3 && (crossing[axis] == low[axis] || crossing[axis] == high[axis])) ++axis;
    if (axis == 3) return crossing;
    Vec3 inside = crossing, outside = crossing;
    inside[axis] = low[axis], outside[axis] = high[axis];
    if (material_.sample(inside, hint_).value >= 0) std::swap(inside, outside);
    for (int i = 0; i < kHalvings; ++i) {
      const Vec3 p = (inside + outside) * 0.5;
      (material_.sample(p, hint_).value < 0 ? inside : outside) = p;
    }
    return outside;
  }

  static std::size_t place_of(const Vec3& p) {
    std::uint64_t h = 0;
    for (int a = 0; a < 3; ++a) h = (h ^ std::bit_cast<std::uint64_t>(p[a])) * 0x9e3779b97f4a7c15U;
    return static_cast<std::size_t>(h >> 54);
  }

  std::optional<Vec3> sharp_place(const Index3& cell, const Vec3& middle,
                                  std::span<const Face> faces) {
    if (faces.size() < 2) return std::nullopt;
    double widest = 0;
    std::vector<Face> meeting;
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (sharp(faces[i], faces[j]) && sine_between(faces[i], faces[j]) > widest)
          widest = sine_between(faces[i], faces[j]), meeting = {faces[i], faces[j]};
    if (meeting.empty()) return std::nullopt;
    const Vec3 along = cross(meeting[0].normal, meeting[1].normal);
    double fullest = kSharpSine * length(along);
    for (const Face& f : faces)
      if (sharp(f, meeting[0]) && sharp(f, meeting[1]) && std::abs(dot(along, f.normal)) > fullest)
        fullest = std::abs(dot(along, f.normal)), meeting.resize(2), meeting.push_back(f);
    if (meeting.size() == 3)
      if (const auto corner = meeting_place(cell, middle, meeting)) return corner;
    meeting.resize(2);
    return meeting_place(cell, middle, meeting);
  }

  // Newton's steps onto all of the faces at once; only a place in the cell and on the stock's
  // surface is one.
  std::optional<Vec3> meeting_place(const Index3& cell, const Vec3& from,
                                    const std::vector<Face>& faces) const {
    Vec3 p = from;
    std::array<MaterialSample, 3> at;
    const std::span<MaterialSample> used = std::span(at).first(faces.size());
    for (std::size_t k = 0; k < faces.size(); ++k) at[k] = {0, faces[k].normal, faces[k].maker};
    for (int step = 0; step < kMostSteps; ++step) {
      if (sample_faces(used, p) <= kOnSurface_mm)
        return in_cell(cell, p) && on_surface(p, at[0].maker) ? std::optional(p) : std::nullopt;
      const Vec3 move = step_onto(used);
      const double l = length(move);
      p += l > lattice_.voxel_mm ? move * (lattice_.voxel_mm / l) : move;
    }
    return std::nullopt;
  }

  // Where one maker has several of the faces, each is looked at from a place half a voxel away from
  // the others, where it is the nearest one. Gives the largest distance.
  double sample_faces(std::span<MaterialSample> faces, const Vec3& p) const {
    std::array<Vec3, 3> normal;
    for (std::size_t k = 0; k < faces.size(); ++k) normal[k] = faces[k].gradient;
    double worst = 0;
    for (std::size_t k = 0; k < faces.size(); ++k) {
      Vec3 q = p;
      const SurfaceMaker maker = faces[k].maker;
      for (std::size_t j = 0; j < faces.size(); ++j)
        if (j != k && faces[j].maker == maker)
          q += normal[j] * ((maker.pass == 0 ? -0.5 : 0.5) * lattice_.voxel_mm);
      const MaterialSample s = material_.sample_of(maker, q);
      faces[k] = {s.value + dot(s.gradient, p - q), s.gradient, maker};
      worst = std::max(worst, std::abs(faces[k].value));
    }
    return worst;
  }

  bool on_surface(const Vec3& p, SurfaceMaker guess) const {
    return std::abs(material_.sample(p, guess).value) <= kOnSurface_mm;
  }

  bool in_cell(const Index3& cell, const Vec3& p) const {
    const Vec3 low = lattice_.point(cell);
    const double slack = kWholeSpacing * lattice_.voxel_mm;
    for (int a = 0; a < 3; ++a)
      if (p[a] < low[a] - slack || p[a] > low[a] + lattice_.voxel_mm + slack) return false;
    return true;
  }

  NearMaterial material_;
  const Lattice& lattice_;
  std::atomic<std::size_t>& unmoved_;
  SurfaceMaker hint_;
  std::array<Face, kMostFaces> faces_;
  struct Known {
    Vec3 at{std::nan(""), 0, 0};
    MaterialSample sample;
  };
  std::vector<Known> known_ = std::vector<Known>(1 << 10);
};

}  // namespace

MakePlacer middle_placers() {
  return [] { return std::make_unique<MiddlePlacer>(); };
}

MakePlacer exact_placers(const Material& material, const Lattice& lattice,
                         std::atomic<std::size_t>& unmoved) {
  return [&material, &lattice, &unmoved] {
    return std::make_unique<ExactPlacer>(material, lattice, unmoved);
  };
}

}  // namespace limitgauge::simulator
