#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace limitgauge::reports::junit {

/// How a test case ended: JUnit's `failure` is a question answered with no, its `error` one that
/// could not be answered, `skipped` one that was not asked.
enum class Outcome { passed, failure, error, skipped };

struct Case {
  std::string name;
  Outcome outcome = Outcome::passed;
  std::string type = {};     ///< of a failure or an error
  std::string message = {};  ///< of a passed case what it printed
  std::string body = {};     ///< below the message of any other; lines end in \n
  double seconds = 0;
};

struct Property {
  std::string name, value;
};

struct Suite {
  std::string name;
  std::string class_name;  ///< of all its cases; servers sort by it
  std::vector<Property> properties;
  std::vector<Case> cases;
  double seconds = 0;
  std::string timestamp;  ///< ISO 8601
};

/// Any text in these may hold any bytes: what XML does not take is replaced where it is written.
struct TestReport {
  std::string name;
  std::vector<Suite> suites;
  double seconds = 0;
};

/// junit.xml: JUnit's XML as CI servers read it, totals counted.
void write(const TestReport& report, std::ostream& out);

}  // namespace limitgauge::reports::junit
