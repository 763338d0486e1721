#include "reports/junit/test_report.h"

#include <algorithm>
#include <ostream>
#include <pugixml.hpp>

#include "reports/text/text.h"

namespace limitgauge::reports::junit {
namespace {

/// The name of an outcome's element; a passed case has none.
const char* element_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::failure:
      return "failure";
    case Outcome::error:
      return "error";
    case Outcome::skipped:
      return "skipped";
    case Outcome::passed:
      break;
  }
  return nullptr;
}

void set(pugi::xml_node node, const char* key, const std::string& value) {
  node.append_attribute(key).set_value(clean_text(value).c_str());
}

/// Totals of some suites.
void set_counts(pugi::xml_node node, const std::vector<const Suite*>& suites) {
  const auto count = [&](auto counts) {
    long all = 0;
    for (const Suite* suite : suites)
      all += std::count_if(suite->cases.begin(), suite->cases.end(), counts);
    return std::to_string(all);
  };
  const auto of = [&](Outcome outcome) {
    return count([=](const Case& c) { return c.outcome == outcome; });
  };
  set(node, "tests", count([](const Case&) { return true; }));
  set(node, "failures", of(Outcome::failure));
  set(node, "errors", of(Outcome::error));
  set(node, "skipped", of(Outcome::skipped));
}

void add_case(pugi::xml_node suite, const std::string& class_name, const Case& c) {
  pugi::xml_node test = suite.append_child("testcase");
  set(test, "classname", class_name);
  set(test, "name", c.name);
  set(test, "time", fixed(c.seconds, 3));
  const char* element = element_of(c.outcome);
  if (!element) {
    test.append_child("system-out").text().set(clean_text(c.message).c_str());
    return;
  }
  pugi::xml_node node = test.append_child(element);
  set(node, "message", c.message);
  if (!c.type.empty()) set(node, "type", c.type);
  if (!c.body.empty()) node.text().set(clean_text(c.body).c_str());
}

void add_suite(pugi::xml_node root, const Suite& suite) {
  pugi::xml_node node = root.append_child("testsuite");
  set(node, "name", suite.name);
  pugi::xml_node list;
  if (!suite.properties.empty()) list = node.append_child("properties");
  for (const Property& property : suite.properties) {
    pugi::xml_node element = list.append_child("property");
    set(element, "name", property.name);
    set(element, "value", property.value);
  }
  for (const Case& c : suite.cases) add_case(node, suite.class_name, c);
  set_counts(node, {&suite});
  set(node, "time", fixed(suite.seconds, 3));
  if (!suite.timestamp.empty()) set(node, "timestamp", suite.timestamp);
}

}  // namespace

void write(const TestReport& report, std::ostream& out) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  set(declaration, "version", "1.0");
  set(declaration, "encoding", "UTF-8");
  pugi::xml_node root = document.append_child("testsuites");
  set(root, "name", report.name);
  std::vector<const Suite*> all;
  for (const Suite& suite : report.suites) {
    add_suite(root, suite);
    all.push_back(&suite);
  }
  set_counts(root, all);
  set(root, "time", fixed(report.seconds, 3));
  document.save(out, "  ");
}

}  // namespace limitgauge::reports::junit
