#include <openssl/evp.h>

#include <array>
#include <set>

#include "reports/page/page_data.h"
#include "reports/text/embedded.h"
#include "tests/reports/page/page_support.h"
#include "tests/reports/sample_result.h"
#include "tests/support/catch.h"

using namespace limitgauge;
using namespace limitgauge::reports;

namespace {

/// As the Content-Security-Policy names a script.
std::string policy_sum(const std::string& text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> sum{};
  unsigned length = 0;
  REQUIRE(EVP_Digest(text.data(), text.size(), sum.data(), &length, EVP_sha256(), nullptr) == 1);
  std::array<unsigned char, 128> base64{};
  EVP_EncodeBlock(base64.data(), sum.data(), static_cast<int>(length));
  return "'sha256-" + std::string(reinterpret_cast<const char*>(base64.data())) + "'";
}

/// Data stands in scripts of a type that no browser runs, and cannot end them; one script runs.
void require_one_script(const ParsedPage& page) {
  int run = 0;
  for (const ParsedPage::Script& script : page.scripts) {
    if (contains(script.tag, "type=\"application/")) {
      CHECK_FALSE(contains(script.text, "<"));
    } else {
      ++run;
      CHECK(script.tag == "<script>");
      CHECK(script.text == embedded::report_js());
      CHECK(contains(page.markup, "script-src " + policy_sum(script.text)));
    }
  }
  CHECK(run == 1);
}

/// Nothing is loaded and nothing else can run: no handlers, no links but within the page.
void require_harmless(const ParsedPage& page) {
  for_each_element(page.tree, [](const pugi::xml_node& node) {
    const std::set<std::string> loading = {"script", "iframe", "object", "embed", "link",
                                           "base",   "form",   "video",  "audio"};
    CHECK_FALSE(loading.contains(node.name()));
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      const std::string name = attribute.name(), value = attribute.value();
      INFO(node.name() << " " << name << "=" << value.substr(0, 60));
      CHECK_FALSE(name.starts_with("on"));
      CHECK_FALSE(value.starts_with("javascript:"));
      if (name == "href") CHECK(value.starts_with("#"));
      if (name == "src") CHECK(value.starts_with("data:image/png;"));
      if (name == "style") CHECK_FALSE(contains(value, "url("));
    }
  });
  for (const char* word : {"http:", "https:", "@import", "url("})
    CHECK_FALSE(contains(page.markup, word));
}

/// Every text that comes from a file or the command line becomes `text`.
RunResult with_texts(const std::string& text) {
  RunResult r = sample_result(Outcome::failed, 3);
  r.job = r.created = r.version = r.surface->cage = text;
  r.assumptions = {text};
  r.inputs = {{text, text, 1, text}};
  r.published = PublishedFigures{};
  r.published->source = text;
  for (StageResult& s : r.stages) {
    s.name = s.tool = s.strategy = s.program_part = text;
    s.decision.reasons = {text};
    if (!s.ran) continue;
    s.ran->ignored_words = {text};
    std::string program;
    for (int line = 0; line < 2000; ++line) program += text + "\n";
    s.ran->program_text = std::make_shared<const std::string>(program);
    for (verifier::UncertaintyTerm& term : s.ran->deviation->budget) term.source = text;
    for (verifier::BodyFigure& body : s.ran->deviation->bodies) body.body = text;
    for (verifier::Finding& f : s.ran->deviation->gouges) f.body = text;
    for (simulator::Finding& f : s.ran->process) f.part = f.against = text;
  }
  r.stages[0].program = text;
  return r;
}

std::vector<std::string> elements_of(const ParsedPage& page) {
  std::vector<std::string> names;
  for_each_element(page.tree, [&](const pugi::xml_node& node) {
    std::string name = node.name();
    for (const pugi::xml_attribute& a : node.attributes()) name += std::string(" ") + a.name();
    names.push_back(std::move(name));
  });
  return names;
}

}  // namespace

TEST_CASE("the page nests, loads nothing and runs one script, known by its checksum",
          "[slow][html]") {
  for (const Outcome outcome : {Outcome::passed, Outcome::failed, Outcome::indeterminate}) {
    ParsedPage page;
    parse_page(page_of(sample_result(outcome, 5), true), page);
    require_one_script(page);
    require_harmless(page);
    CHECK(contains(page.markup, "default-src 'none'"));
    CHECK_FALSE(contains(page.markup, "unsafe-eval"));
  }
}

TEST_CASE("text from files is shown as text", "[unit][html]") {
  ParsedPage plain;
  parse_page(page_of(with_texts("a program's text")), plain);
  for (const std::string hostile :
       {"\"><script>alert('x')</script><img src=x onerror=y>&amp;\x01", "' onload='alert(1)",
        "--></style></table><!--", "</script><script>alert(1)</script>", "{}{0}%s"}) {
    ParsedPage page;
    parse_page(page_of(with_texts(hostile)), page);
    require_one_script(page);
    require_harmless(page);
    // The very same elements with the very same attributes: the text made none.
    CHECK(elements_of(page) == elements_of(plain));
    CHECK_FALSE(contains(page.markup, "\x01"));
  }
  ParsedPage page;
  parse_page(page_of(with_texts("<b>&amp;\"'")), page);
  CHECK(text_of(page.tree.find_node([](const pugi::xml_node& n) {
          return std::string(n.name()) == "h1";
        })) == "<b>&amp;\"'");
  CHECK(contains(page.markup, "<code>&lt;b&gt;&amp;amp;&quot;&#39;</code>"));
}
