#pragma once

#include <filesystem>

#include "simulator/stock/stock_model.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::reports {

/// The deviation field: points of the limit surface with deviation_mm, uncut_mm, gouge_mm,
/// reachable, patch, u, v, line. Throws model::ResourceError when the file cannot be written.
void write_deviation_vtp(const verifier::DeviationField& field, const std::filesystem::path& file);
/// The stock's surface. Throws model::ResourceError when the file cannot be written.
void write_stock_vtp(const simulator::StockMesh& mesh, const std::filesystem::path& file);

}  // namespace limitgauge::reports
