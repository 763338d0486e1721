#pragma once

#include <string>
#include <string_view>

namespace limitgauge::reports::html {

/// A page's script with the style of what it adds; empty where a page has none.
struct Script {
  std::string_view js, sha256, css;  ///< the checksum in base64, for the page's policy
};

/// The head of a page that needs nothing but itself, and the begin of its body: `<main>` or what
/// comes before it follows. Nothing is loaded, and no script runs but `script`. `title` is text.
std::string shell_head(std::string_view title, const Script& script);

/// The end of its body. `data` is JSON that the script finds under the id `limitgauge-data`; "<"
/// in it is written as an escape, so that no text of it ends the element.
std::string shell_end(const Script& script, std::string_view data_json);

}  // namespace limitgauge::reports::html
