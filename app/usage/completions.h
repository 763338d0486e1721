#pragma once

#include <string>

#include "app/usage/command_reference.h"

namespace limitgauge::app {

/// Completions for one shell each: commands, options, and files, folders or words as their values.
std::string bash_completion(const CommandReference& program);
std::string zsh_completion(const CommandReference& program);
std::string fish_completion(const CommandReference& program);

}  // namespace limitgauge::app
