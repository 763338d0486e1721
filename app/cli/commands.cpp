#include "app/cli/commands.h"

#include <exception>
#include <ostream>

#include "app/cli/error_message.h"
#include "model/base/error.h"
#include "reports/text/text.h"

namespace limitgauge::app {
namespace {

/// Whoever reads it may be a terminal, and what it quotes may be anybody's: no bytes that steer
/// one.
ExitCode say(const Console& console, const std::exception& error, ExitCode code) {
  console.errors << reports::clean_text(message_of(error)) << std::endl;
  return code;
}

}  // namespace

ExitCode report_exception(const Console& console) {
  try {
    throw;
  } catch (const UsageError& error) {
    return say(console, error, ExitCode::bad_input);
  } catch (const model::InputError& error) {
    return say(console, error, ExitCode::bad_input);
  } catch (const std::exception& error) {
    return say(console, error, ExitCode::resources);
  }
}

ExitCode run_command_line(int argc, const char* const* argv, const Console& console) {
  try {
    const CommandLine line = parse_command_line(argc, argv);
    if (const auto* print = std::get_if<PrintCommand>(&line.command)) {
      console.out << print->text << std::flush;
      return ExitCode::pass;
    }
    return std::visit(
        [&](const auto& command) {
          if constexpr (std::is_same_v<decltype(command), const PrintCommand&>) {
            return ExitCode::pass;
          } else {
            return execute(command, line.common, console);
          }
        },
        line.command);
  } catch (const std::exception&) {
    return report_exception(console);
  }
}

}  // namespace limitgauge::app
