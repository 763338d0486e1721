#pragma once

#include <exception>
#include <string>

namespace limitgauge::app {

/// What an exception says to the user. Those of the project speak for themselves; of the standard
/// library's, which name no file or speak of the library's own parts, this tells the file and the
/// reason of the system.
std::string message_of(const std::exception& error);

/// Has what would be std::abort(), an exception that nobody can catch any more (a thread that
/// cannot be started in the middle of a library), say what it is and end the program with the exit
/// code for lack of resources.
void end_instead_of_aborting();

}  // namespace limitgauge::app
