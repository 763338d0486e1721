#pragma once

#include <string>
#include <string_view>

#include "app/usage/command_reference.h"

/// What is written of the command line from its one definition.
namespace limitgauge::app {

/// What `limitgauge --help` prints, at most 80 columns wide.
std::string program_help(const CommandReference& program);
/// What `limitgauge COMMAND --help` prints, at most 80 columns wide.
std::string command_help(const std::string& program, const CommandReference& command);

/// "-o,--output DIR", "JOB".
std::string signature(const OptionReference& option);
/// "limitgauge run [OPTIONS] JOB", with those options that a command cannot do without.
std::string synopsis(const std::string& program, const CommandReference& command);
/// What an option does, and whether it is required or repeatable.
std::string summary(const OptionReference& option);

/// The manual page limitgauge(1), in the macros of man(7).
std::string man_page(const CommandReference& program, std::string_view version);

/// Completions for one shell each: commands, options, and files, folders or words as their values.
std::string bash_completion(const CommandReference& program);
std::string zsh_completion(const CommandReference& program);
std::string fish_completion(const CommandReference& program);

}  // namespace limitgauge::app
