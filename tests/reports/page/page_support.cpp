#include "tests/reports/page/page_support.h"

#include <sstream>

#include "reports/run/report.h"
#include "tests/support/catch.h"

namespace limitgauge::reports {
namespace {

/// Moves the scripts of `page` over to `parsed`, the rest stays.
std::string without_scripts(const std::string& page, std::vector<ParsedPage::Script>& scripts) {
  std::string rest;
  std::size_t at = 0;
  for (std::size_t begin; (begin = page.find("<script", at)) != std::string::npos;) {
    const std::size_t tag = page.find('>', begin) + 1, end = page.find("</script>", tag);
    REQUIRE(end != std::string::npos);
    scripts.push_back({page.substr(begin, tag - begin), page.substr(tag, end - tag)});
    rest += page.substr(at, begin - at);
    at = end + std::string("</script>").size();
  }
  return rest + page.substr(at);
}

}  // namespace

std::string page_of(const RunResult& result, bool pictures) {
  std::ostringstream out;
  RunResult shown = result;
  for (StageResult& stage : shown.stages) {
    stage.pictures.reset();
    if (pictures) stage.pictures = draw_pictures(stage);
  }
  write_html(shown, out);
  return out.str();
}

void parse_page(const std::string& page, ParsedPage& parsed) {
  parsed.markup = without_scripts(page, parsed.scripts);
  const std::string type = "<!DOCTYPE html>";
  REQUIRE(parsed.markup.starts_with(type));
  const pugi::xml_parse_result read = parsed.tree.load_string(
      parsed.markup.c_str() + type.size(), pugi::parse_default | pugi::parse_ws_pcdata);
  INFO(read.description() << " at " << parsed.markup.substr(type.size() + read.offset, 80));
  REQUIRE(read);
}

void for_each_element(const pugi::xml_node& root,
                      const std::function<void(pugi::xml_node)>& visit) {
  for (const pugi::xml_node child : root.children()) {
    if (child.type() != pugi::node_element) continue;
    visit(child);
    for_each_element(child, visit);
  }
}

pugi::xml_node element_with(const pugi::xml_node& root, const char* attribute,
                            const std::string& value) {
  const pugi::xml_node found = root.find_node([&](const pugi::xml_node& node) {
    return node.attribute(attribute).as_string() == value && node.attribute(attribute);
  });
  INFO(attribute << "=" << value);
  REQUIRE(found);
  return found;
}

std::string text_of(const pugi::xml_node& element) {
  std::string out;
  for (const pugi::xml_node child : element.children())
    out += child.type() == pugi::node_element ? text_of(child) : child.value();
  return out;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace limitgauge::reports
