#include "app/cli/error_message.h"

#include <cxxabi.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <new>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <typeinfo>

#include "app/cli/usage_error.h"
#include "model/base/error.h"
#include "verifier/gate/verify.h"

namespace limitgauge::app {
namespace {

std::string words_of(const std::filesystem::filesystem_error& error) {
  const std::string file = error.path1().empty() ? "limitgauge" : error.path1().string();
  return file + ": error: " + error.code().message();
}

/// What asks for a thread that cannot be had says no more than to try again.
std::string words_of(const std::error_code& code) {
  const bool of_thread = code == std::errc::resource_unavailable_try_again;
  return std::string("limitgauge: error: ") +
         (of_thread ? "no thread can be started" : "the system refuses what is needed") + ": " +
         code.message();
}

/// What a library knows of no file is the program's own to say.
std::string with_prefix(const std::string& words) {
  const bool has_one =
      words.starts_with("limitgauge: ") || words.find("error: ") < words.find('\n');
  return has_one ? words : "limitgauge: error: " + words;
}

template <class Kind>
bool is(const std::exception& error) {
  return dynamic_cast<const Kind*>(&error) != nullptr;
}

[[noreturn]] void on_terminate() {
  std::string words = "limitgauge: internal error: ended without an exception";
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::exception& error) {
    words = message_of(error);
  } catch (...) {
    words = "limitgauge: internal error: an exception of no known kind";
  }
  words += '\n';
  static_cast<void>(!::write(STDERR_FILENO, words.data(), words.size()));
  constexpr int kResources = 4;
  ::_exit(kResources);
}

/// Of the project's own broken contracts; what libraries have to say means nothing to a user.
bool is_own(const std::exception& error) {
  return is<verifier::InstrumentDisagreement>(error) || typeid(error) == typeid(std::logic_error) ||
         typeid(error) == typeid(std::runtime_error) ||
         typeid(error) == typeid(std::domain_error) ||
         (typeid(error) == typeid(std::invalid_argument) &&
          !std::string_view(error.what()).starts_with("sto"));
}

std::string kind_of(const std::exception& error) {
  int failure = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, &failure), &std::free);
  return failure == 0 ? name.get() : "of no known kind";
}

}  // namespace

std::string message_of(const std::exception& error) {
  if (is<UsageError>(error)) return std::string("limitgauge: error: ") + error.what();
  if (is<model::InputError>(error)) return error.what();
  if (is<model::ResourceError>(error)) return with_prefix(error.what());
  if (is<model::Interrupted>(error)) return "limitgauge: interrupted; nothing was kept";
  if (is<std::bad_alloc>(error)) return "limitgauge: error: out of memory";
  if (const auto* of_file = dynamic_cast<const std::filesystem::filesystem_error*>(&error))
    return words_of(*of_file);
  if (const auto* of_system = dynamic_cast<const std::system_error*>(&error))
    return words_of(of_system->code());
  // TBB's own words, thrown where nothing but the end of the program can follow.
  if (std::string_view(error.what()).starts_with("pthread_create"))
    return words_of(std::make_error_code(std::errc::resource_unavailable_try_again));
  return "limitgauge: internal error: " +
         (is_own(error) ? error.what()
                        : "something unexpected (" + kind_of(error) +
                              "); please report it with the command and its input");
}

void end_instead_of_aborting() {
  std::set_terminate(on_terminate);
}

}  // namespace limitgauge::app
