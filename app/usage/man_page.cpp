#include "app/usage/usage_texts.h"

#include <algorithm>
#include <cctype>
#include <sstream>

#include "app/usage/usage_notes.h"

namespace limitgauge::app {
namespace {

/// When what this page says beyond the options was changed last.
const std::string kDate = "2026-11-21";

/// `text` so that roff prints it as it stands: a hyphen stays one that can be pasted, and a line
/// that begins with a dot or a quote is no request.
std::string plain(std::string_view text) {
  std::string out;
  if (!text.empty() && (text.front() == '.' || text.front() == '\'')) out += "\\&";
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

/// `text` on lines that a reader of the source can read, too; where they end means nothing.
std::string paragraph(std::string_view text) {
  constexpr std::size_t kWidth = 76;
  std::istringstream words{std::string(text)};
  std::string out, line;
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > kWidth) {
      out += plain(line) + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return out + plain(line) + "\n";
}

std::string bold(std::string_view text) {
  return "\\fB" + plain(text) + "\\fR";
}
std::string italic(std::string_view text) {
  return "\\fI" + plain(text) + "\\fR";
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string section(const std::string& title) {
  return ".SH " + title + "\n";
}

std::string man_entry(const std::string& term, std::string_view text) {
  return ".TP\n" + term + "\n" + paragraph(text);
}

/// "\fB-o\fR, \fB--output\fR \fIDIR\fR".
std::string term_of(const OptionReference& option) {
  if (option.positional) return italic(option.names.front());
  std::string term;
  for (const std::string& name : option.names) term += (term.empty() ? "" : ", ") + bold(name);
  return option.value.empty() ? term : term + " " + italic(option.value);
}

std::string sentence(std::string text) {
  if (!text.empty() && text.back() != '.') text += '.';
  return text;
}

std::string options(const CommandReference& command) {
  std::string out;
  for (const bool positional : {true, false})
    for (const OptionReference& option : command.options)
      if (option.positional == positional)
        out += man_entry(term_of(option), sentence(summary(option)));
  return out;
}

std::string synopsis_lines(const CommandReference& program) {
  std::string out;
  for (const CommandReference& command : program.commands) {
    if (!out.empty()) out += ".br\n";
    const std::string line = synopsis(program.name, command);
    const std::string words = program.name + " " + command.name;
    out += bold(words) + plain(line.substr(words.size())) + "\n";
  }
  return out + ".br\n" + bold(program.name) + plain(" --help | --version") + "\n";
}

std::string command_sections(const CommandReference& program) {
  std::string out;
  for (const CommandReference& command : program.commands) {
    out += ".SS " + command.name + "\n" + plain(sentence(command.summary)) + "\n";
    out += options(command);
  }
  return out;
}

std::string man_notes(std::span<const UsageNote> notes, bool names_in_bold) {
  std::string out;
  for (const UsageNote& note : notes)
    out += man_entry(names_in_bold ? bold(note.name) : italic(note.name),
                     sentence(std::string(note.text)));
  return out;
}

std::string examples() {
  std::string out;
  for (const UsageNote& note : example_notes()) {
    if (!out.empty()) out += ".PP\n";
    out += plain(note.text) + "\n.PP\n.RS 4\n" + bold(note.name) + "\n.RE\n";
  }
  return out;
}

std::string description(const CommandReference& program) {
  return paragraph(program.summary) +
         paragraph(
             "The stages of a job are planned, or read from programs in G-code, cut in simulation, "
             "measured against the exact limit surface of a Catmull-Clark cage, and gated.") +
         paragraph(
             "Every figure is an interval that is proven: a stage passes, fails, or is said to be "
             "indeterminate.") +
         paragraph("Lengths are in millimetres, angles in degrees, feeds in mm/min.");
}

}  // namespace

std::string man_page(const CommandReference& program, std::string_view version) {
  std::string out = ".\\\" Written by the program from the options that it parses.\n";
  out += ".TH " + upper(program.name) + " 1 \"" + kDate + "\" \"" + program.name + " " +
         std::string(version) + "\" \"User Commands\"\n";
  out += section("NAME") + program.name + " \\- go or no\\-go for toolpaths\n";
  out += section("SYNOPSIS") + synopsis_lines(program);
  out += section("DESCRIPTION") + description(program);
  out += section("OPTIONS") + options(program);
  out += section("COMMANDS") + command_sections(program);
  out += section("EXIT STATUS") + man_notes(exit_code_notes(), true);
  out += section("FILES") + "Results go to " + italic("limitgauge-out/NAME") + ", or where " +
         bold("-o") + " says:\n" + man_notes(file_notes(), false);
  out += section("ENVIRONMENT") + man_notes(environment_notes(), true);
  out += section("EXAMPLES") + examples();
  out += section("SEE ALSO") +
         paragraph(
             "README.md and docs/ in share/doc/limitgauge, and the schema of result.json in "
             "share/limitgauge, below the folder that the program was installed to.");
  return out;
}

}  // namespace limitgauge::app
