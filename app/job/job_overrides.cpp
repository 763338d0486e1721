#include "app/job/job_parts.h"

#include <utility>
#include <vector>

#include "app/toml/toml_text.h"
#include "model/base/error.h"

namespace limitgauge::app {
namespace {

struct Override {
  std::string shown;  ///< as it is named in errors
  std::vector<std::string> path;
  std::string value;
};

[[noreturn]] void refuse(const Override& override, const std::string& wrong,
                         const std::string& expected) {
  throw model::InputError({override.shown, 0, 0}, wrong, expected);
}

Override parse_override(const std::string& text) {
  Override result{"--set " + text, {}, {}};
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) refuse(result, "no '=' in it", "key=value");
  std::string key = text.substr(0, equals);
  result.value = text.substr(equals + 1);
  for (std::size_t from = 0; from <= key.size();) {
    const std::size_t dot = std::min(key.find('.', from), key.size());
    if (dot == from)
      refuse(result, "an empty name in the key", "dotted names, as stage.rough.step");
    if (result.path.size() > kMostDots)
      refuse(result, "more than " + std::to_string(kMostDots) + " dots in the key", "fewer names");
    result.path.push_back(key.substr(from, dot - from));
    from = dot + 1;
  }
  return result;
}

/// The value as a table with the one key `value`, so that it keeps its source when moved on.
toml::table parse_value(const Override& override) {
  try {
    toml::table table = parse_toml("value = " + override.value, override.shown);
    if (table.size() == 1) return table;
  } catch (const OtherBase&) {
    refuse(override, "the value is no decimal number", "digits from 0 to 9");
  } catch (const model::InputError&) {
    // A bare word: taken as text below, which saves the user a second pair of quotes.
  }
  try {
    if (!override.value.empty() && override.value.find_first_of("'\n") == std::string::npos)
      return parse_toml("value = '" + override.value + "'", override.shown);
  } catch (const model::InputError&) {
    // Control characters, or bytes that are no UTF-8.
  }
  refuse(override, "the value cannot be read", "a number, true, false, text or [list]");
}

/// One step along the path: a table below `at`, created where there is none.
toml::table* step(const Override& override, toml::table& at, std::size_t& index) {
  const std::string& name = override.path[index];
  toml::node* next = at.get(name);
  if (next == nullptr) return at.insert(name, toml::table{}).first->second.as_table();
  if (toml::table* table = next->as_table()) return table;
  toml::array* entries = next->as_array();
  if (entries == nullptr) refuse(override, "\"" + name + "\" is no table", "a key of a table");
  if (++index + 1 >= override.path.size()) {
    refuse(override, "no key after the " + name, name + ".NAME.KEY=value");
  }
  toml::table* entry = entry_named(*entries, override.path[index]);
  if (entry == nullptr) {
    refuse(override, "no " + name + " is called \"" + override.path[index] + "\"",
           "one of the job's");
  }
  return entry;
}

void apply(toml::table& job, const Override& override) {
  toml::table* at = &job;
  for (std::size_t i = 0; i + 1 < override.path.size(); ++i) at = step(override, *at, i);
  toml::table parsed = parse_value(override);
  parsed.get("value")->visit(
      [&](auto& value) { at->insert_or_assign(override.path.back(), std::move(value)); });
}

}  // namespace

void apply_overrides(toml::table& job, std::span<const std::string> overrides) {
  for (const std::string& text : overrides) apply(job, parse_override(text));
}

}  // namespace limitgauge::app
