#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace limitgauge::model {

/// A program's file as text of single bytes with line feeds: UTF-16, with or without a mark, is
/// brought to UTF-8, and lines that end in carriage returns alone get line feeds. An InputError
/// names what cannot be read, and the place of a line too long to be one; such a file is not
/// loaded.
std::string read_program_text(const std::filesystem::path& path);

/// The same of bytes at hand; empty where they are such text already.
std::string as_program_text(std::string_view bytes, const std::string& name);

namespace gcode {

/// A character that was read as another.
struct MendedCharacter {
  std::uint32_t line = 0;
  std::string what;
};
/// Dashes and the minus sign of Unicode (and of Windows-1252) where a number follows become '-' and
/// blanks, outside of comments; spaces of Unicode become blanks. Places stay. Empty where there is
/// nothing to mend.
std::string mended(std::string_view text, std::vector<MendedCharacter>& mended);

/// Throws InputError for a program in another language than G-code that its first words tell.
void check_language(std::string_view text, const std::string& name);

}  // namespace gcode
}  // namespace limitgauge::model
