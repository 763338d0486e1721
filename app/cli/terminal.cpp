#include "app/cli/terminal.h"

#include <sys/ioctl.h>

#include <string_view>

namespace limitgauge::app {

bool may_redraw(bool is_terminal, const char* term) {
  const std::string_view kind = term == nullptr ? "" : term;
  return is_terminal && !kind.empty() && kind != "dumb";
}

bool may_colour(bool is_terminal, const char* no_color, const char* term) {
  const bool unwanted = no_color != nullptr && *no_color != '\0';
  return !unwanted && may_redraw(is_terminal, term);
}

std::size_t columns_of(int descriptor, std::size_t otherwise) {
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return otherwise;
  return size.ws_col;
}

}  // namespace limitgauge::app
