#pragma once

#include <filesystem>
#include <span>

#include "reports/vtk/stage_facts.h"
#include "simulator/stock/stock_model.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::reports {

/// The deviation field: points of the limit surface with deviation_mm (the active scalars),
/// uncut_mm, gouge_mm, reachable, patch, u, v, line and the unit normal (the active normals).
/// `facts` become field data. Throws model::ResourceError when the file cannot be written.
void write_deviation_vtp(const verifier::DeviationField& field, const std::filesystem::path& file,
                         std::span<const Fact> facts = {});
/// The stock's surface. Throws model::ResourceError when the file cannot be written.
void write_stock_vtp(const simulator::StockMesh& mesh, const std::filesystem::path& file,
                     std::span<const Fact> facts = {});

}  // namespace limitgauge::reports
