#pragma once

#include <string>
#include <string_view>

#include "app/usage/command_reference.h"

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

}  // namespace limitgauge::app
