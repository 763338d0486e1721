#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace limitgauge::reports::html {

/// Ids of elements that can be linked to; the page's script finds its places by them as well.
std::string stage_anchor(std::size_t stage);
/// Of the row of "G1", "U3" or "P2" of a stage.
std::string finding_anchor(std::size_t stage, const std::string& finding);
/// Of a line of `program_stage`'s program in the listing of `stage`.
std::string line_anchor(std::size_t stage, std::size_t program_stage, std::uint32_t line);

/// Attributes of such a row, with which the script adds what flies to the place.
std::string finding_attributes(std::size_t stage, const std::string& finding);
/// A link to the row.
std::string finding_link(std::size_t stage, const std::string& finding, const std::string& text);

}  // namespace limitgauge::reports::html
