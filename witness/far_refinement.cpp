#include "witness/far_refinement.h"

#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <opensubdiv/version.h>

#include "witness/bounds.h"

namespace limitgauge::witness {
namespace {

using model::Cage;
using model::Index;

Sdc::Options options_of(const Cage& cage) {
  using Rule = Sdc::Options;
  Sdc::Options options;
  switch (cage.boundary) {
    case model::BoundaryRule::none:
      options.SetVtxBoundaryInterpolation(Rule::VTX_BOUNDARY_NONE);
      break;
    case model::BoundaryRule::edge_only:
      options.SetVtxBoundaryInterpolation(Rule::VTX_BOUNDARY_EDGE_ONLY);
      break;
    case model::BoundaryRule::edge_and_corner:
      options.SetVtxBoundaryInterpolation(Rule::VTX_BOUNDARY_EDGE_AND_CORNER);
      break;
  }
  return options;
}

/// The tags of a cage in the arrays that a descriptor points to.
struct TagArrays {
  std::vector<int> face_sizes, crease_pairs, corner_vertices;
  std::vector<float> crease_weights, corner_weights;

  explicit TagArrays(const Cage& cage) {
    for (Index f = 0; f < cage.face_count(); ++f)
      face_sizes.push_back(static_cast<int>(cage.face(f).size()));
    for (const auto& c : cage.creases) {
      crease_pairs.insert(crease_pairs.end(), c.vertices.begin(), c.vertices.end());
      crease_weights.push_back(in_single_precision(c.sharpness));
    }
    for (const auto& c : cage.corners) {
      corner_vertices.push_back(c.vertex);
      corner_weights.push_back(in_single_precision(c.sharpness));
    }
  }
};

/// What `tags` and `cage` hold must outlive the descriptor.
Far::TopologyDescriptor descriptor_of(const Cage& cage, const TagArrays& tags) {
  Far::TopologyDescriptor d;
  d.numVertices = static_cast<int>(cage.vertices.size());
  d.numFaces = cage.face_count();
  d.numVertsPerFace = tags.face_sizes.data();
  d.vertIndicesPerFace = cage.face_corners.data();
  d.numCreases = static_cast<int>(tags.crease_weights.size());
  d.creaseVertexIndexPairs = tags.crease_pairs.data();
  d.creaseWeights = tags.crease_weights.data();
  d.numCorners = static_cast<int>(tags.corner_weights.size());
  d.cornerVertexIndices = tags.corner_vertices.data();
  d.cornerWeights = tags.corner_weights.data();
  d.numHoles = static_cast<int>(cage.holes.size());
  d.holeIndices = cage.holes.data();
  return d;
}

bool is_finite_sharpness(float sharpness) {
  return Sdc::Crease::IsSemiSharp(sharpness);
}

}  // namespace

Primvars control_points(const Cage& cage) {
  Primvars points;
  points.reserve(cage.vertices.size());
  for (const model::Vec3& p : cage.vertices) points.push_back({p});
  return points;
}

FarRefinement::FarRefinement(const Cage& cage, int levels) {
  // It would print what is wrong; what it refuses is told by an exception.
  Far::SetErrorCallback([](Far::ErrorType, const char*) {});
  const TagArrays tags(cage);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  refiner_.reset(Factory::Create(descriptor_of(cage, tags),
                                 Factory::Options(Sdc::SCHEME_CATMARK, options_of(cage))));
  if (!refiner_) throw CageRefused("OpenSubdiv refuses the cage " + cage.name);
  Far::TopologyRefiner::UniformOptions uniform(levels);
  uniform.fullTopologyInLastLevel = true;  // the rules at its vertices are asked for
  refiner_->RefineUniform(uniform);
}

Primvars FarRefinement::refined(Primvars points) const {
  const Far::PrimvarRefinerReal<double> primvars(*refiner_);
  for (int at = 1; at <= levels(); ++at) {
    Primvars next(level(at).GetNumVertices());
    Primvar* to = next.data();
    primvars.Interpolate(at, points.data(), to);
    points = std::move(next);
  }
  return points;
}

bool is_semi_sharp(const Far::TopologyLevel& level, Index vertex) {
  if (is_finite_sharpness(level.GetVertexSharpness(vertex))) return true;
  for (const Index e : level.GetVertexEdges(vertex))
    if (is_finite_sharpness(level.GetEdgeSharpness(e))) return true;
  return false;
}

bool has_exact_mask(const Far::TopologyLevel& level, Index vertex) {
  return level.GetVertexRule(vertex) != Sdc::Crease::RULE_DART &&
         (level.GetVertexEdges(vertex).size() > 2 || level.IsVertexBoundary(vertex)) &&
         !is_semi_sharp(level, vertex);
}

std::string evaluator_name() {
  return "OpenSubdiv " + std::to_string(OPENSUBDIV_VERSION_MAJOR) + "." +
         std::to_string(OPENSUBDIV_VERSION_MINOR) + "." + std::to_string(OPENSUBDIV_VERSION_PATCH);
}

}  // namespace limitgauge::witness
