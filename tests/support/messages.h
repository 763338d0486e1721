#pragma once

#include <string>

namespace limitgauge::tests {

/// The message of the `Error` that `call` throws; "no error" where it throws none.
template <typename Error, typename Call>
std::string message_of(Call&& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace limitgauge::tests
