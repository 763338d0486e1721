#pragma once

#include <string>
#include <vector>

namespace limitgauge::app {

/// What may stand as an option's value: what a shell can offer for it.
struct ValueHint {
  enum class Kind { text, file, folder };
  Kind kind = Kind::text;
  std::string extension;           ///< of files, without its dot; empty: any file
  std::vector<std::string> words;  ///< words that a value begins with ("ball:D=")
};

/// An option or a positional argument as the parser knows it.
struct OptionReference {
  std::vector<std::string> names;  ///< "-o", "--output"; of an argument its one name
  bool positional = false, required = false, repeatable = false;
  std::string value;  ///< what stands for its value ("FILE"); empty for a flag
  std::string summary;
  ValueHint hint;
};

/// A command as the parser knows it; the program itself is the one that has commands.
struct CommandReference {
  std::string name, summary;
  std::vector<OptionReference> options;
  std::vector<CommandReference> commands;
};

}  // namespace limitgauge::app
