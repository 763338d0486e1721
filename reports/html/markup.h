#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reports/run/gate_figures.h"
#include "verifier/gate/deviation.h"

namespace limitgauge::reports::html {

/// One column of a table; numbers stand flush right. On a narrow page a row becomes a block of
/// lines, each with its column's title.
struct Column {
  std::string title;
  bool is_number = false;
};
/// A row of cells that are markup already; `attributes` begin with a space.
struct Row {
  std::vector<std::string> cells;
  std::string attributes;
};
/// A table with `caption` from cells that are markup already.
std::string table(std::string_view caption, const std::vector<Column>& columns,
                  const std::vector<Row>& rows);
std::string table(std::string_view caption, const std::vector<Column>& columns,
                  const std::vector<std::vector<std::string>>& rows);

/// A list of terms and values; both are markup already.
struct Term {
  std::string name, value;
};
std::string terms(const std::vector<Term>& list);

/// `body` folded away below `summary`, or open to begin with; both are markup already.
std::string fold(std::string_view css, std::string_view summary, std::string_view body,
                 bool open = false);

/// A coloured word with a sign that needs no colour; `css` is the class name that carries the
/// colour.
std::string badge(std::string_view css, std::string_view sign, std::string_view word);
/// The verdict as one.
std::string badge(verifier::Verdict verdict);
std::string badge(Standing standing);
/// "Passed", "Failed", "Undecided", "Not run".
const char* word(verifier::Verdict verdict);
/// Class name that carries the verdict's colour.
const char* css_class(verifier::Verdict verdict);

/// A plain number, with its unit or without, with a minus sign in place of the hyphen and a power
/// of ten as such.
std::string typeset(const std::string& number);
/// "1.250, −3.000, 0.125", never broken over lines.
std::string coordinates(const model::Vec3& p_mm);

/// `bytes` as the data: URI of a PNG.
std::string png_uri(std::string_view bytes);

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
