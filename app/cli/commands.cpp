#include "app/cli/commands.h"

#include <exception>
#include <filesystem>
#include <new>
#include <ostream>

#include "model/base/error.h"

namespace limitgauge::app {
namespace {

ExitCode say(const Console& console, const std::string& what, ExitCode code) {
  console.errors << what << std::endl;
  return code;
}

}  // namespace

ExitCode report_exception(const Console& console) {
  try {
    throw;
  } catch (const UsageError& error) {
    return say(console, std::string("limitgauge: error: ") + error.what(), ExitCode::bad_input);
  } catch (const model::InputError& error) {
    return say(console, error.what(), ExitCode::bad_input);
  } catch (const model::Interrupted&) {
    return say(console, "limitgauge: interrupted; nothing was kept", ExitCode::resources);
  } catch (const model::ResourceError& error) {
    return say(console, error.what(), ExitCode::resources);
  } catch (const std::bad_alloc&) {
    return say(console, "limitgauge: error: out of memory", ExitCode::resources);
  } catch (const std::exception& error) {
    return say(console, std::string("limitgauge: internal error: ") + error.what(),
               ExitCode::resources);
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
