#pragma once

#include <functional>
#include <pugixml.hpp>
#include <string>
#include <vector>

#include "reports/run/run_result.h"

namespace limitgauge::reports {

/// The page of `result`, its stages with pictures or without.
std::string page_of(const RunResult& result, bool pictures = false);

/// A page taken apart: its scripts, and everything else as a tree, which it must be.
struct ParsedPage {
  struct Script {
    std::string tag;  ///< "<script ...>"
    std::string text;
  };
  std::vector<Script> scripts;
  std::string markup;  ///< without the scripts
  pugi::xml_document tree;
};
void parse_page(const std::string& page, ParsedPage& parsed);

/// Every element in the order of the page.
void for_each_element(const pugi::xml_node& root, const std::function<void(pugi::xml_node)>& visit);
/// The first element whose attribute has this value; none is a failure.
pugi::xml_node element_with(const pugi::xml_node& root, const char* attribute,
                            const std::string& value);
/// All text below an element, as a reader sees it.
std::string text_of(const pugi::xml_node& element);

bool contains(const std::string& text, const std::string& part);

}  // namespace limitgauge::reports
