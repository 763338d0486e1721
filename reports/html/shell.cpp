#include "reports/html/shell.h"

#include <fmt/format.h>

#include "reports/text/embedded.h"
#include "reports/text/text.h"

namespace limitgauge::reports::html {
namespace {

std::string policy(const Script& script) {
  std::string said = "default-src 'none'; img-src data: blob:; style-src 'unsafe-inline'";
  if (!script.js.empty()) said += fmt::format("; script-src 'sha256-{}'", script.sha256);
  return said;
}

std::string without_tags(std::string_view json) {
  std::string out;
  out.reserve(json.size());
  for (const char c : json) {
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  }
  return out;
}

}  // namespace

std::string shell_head(std::string_view title, const Script& script) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
      "<title>{} – Limitgauge</title>\n<style>\n{}{}</style></head>\n"
      "<body><a class=\"skip\" href=\"#figures\">Skip to the figures</a>\n<div class=\"page\">\n",
      policy(script), escape_markup(std::string(title)), embedded::report_css(), script.css);
}

std::string shell_end(const Script& script, std::string_view data_json) {
  std::string out = "</div>\n";
  if (!script.js.empty()) {
    out += fmt::format(
        "<script type=\"application/json\" id=\"limitgauge-data\">{}</script>\n"
        "<script>{}</script>\n",
        without_tags(data_json), script.js);
  }
  return out + "</body></html>\n";
}

}  // namespace limitgauge::reports::html
