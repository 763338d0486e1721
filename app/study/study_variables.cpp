#include "app/study/study_variables.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "app/toml/toml_table.h"
#include "app/toml/toml_text.h"
#include "model/text/hexadecimal.h"
#include "model/text/message_text.h"
#include "model/text/number_text.h"

namespace limitgauge::app {
namespace {

/// As a basic string of one line.
std::string toml_quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += std::string("\\") + c;
    } else if (byte < 0x20 || byte == 0x7F) {
      out += "\\u00" + model::hexadecimal(byte, model::kUpperHexDigits);
    } else {
      out += c;
    }
  }
  return out + "\"";
}

[[noreturn]] void refuse_value(const toml::node& value, const std::string& what,
                               const std::string& wrong) {
  throw model::InputError(place_of(value.source()), what + " " + wrong,
                          "finite numbers, texts, true, false, lists or inline tables of them");
}

std::string text_of(const toml::node& value, const std::string& what);

std::string list_text(const toml::array& list, const std::string& what) {
  std::string text;
  for (const toml::node& entry : list) text += (text.empty() ? "" : ", ") + text_of(entry, what);
  return "[" + text + "]";
}

std::string table_text(const toml::table& table, const std::string& what) {
  std::string text;
  for (const auto& [key, value] : table)
    text += (text.empty() ? " " : ", ") + toml_quoted(key.str()) + " = " + text_of(value, what);
  return "{" + text + " }";
}

std::string text_of(const toml::node& value, const std::string& what) {
  if (const auto* whole = value.as_integer()) return std::to_string(whole->get());
  if (const auto* number = value.as_floating_point()) {
    if (!std::isfinite(number->get())) refuse_value(value, what, "has a number that is not finite");
    return model::shortest(number->get());
  }
  if (const auto* yes = value.as_boolean()) return yes->get() ? "true" : "false";
  if (const auto* text = value.as_string()) return toml_quoted(text->get());
  if (const toml::array* list = value.as_array()) return list_text(*list, what);
  if (const toml::table* table = value.as_table()) return table_text(*table, what);
  refuse_value(value, what, "has a date or time");
}

}  // namespace

study::Setting setting_of(const toml::node& value, const std::string& what) {
  study::Setting setting{text_of(value, what), std::nullopt};
  if (value.is_number()) setting.number = value.value<double>();
  return setting;
}

void refuse(const model::SourcePlace& place, const std::string& wrong,
            const std::string& expected) {
  throw model::InputError(place, wrong, expected);
}

namespace {

/// Beyond these, rounding would show between the steps of a range.
constexpr double kLargest = 1e12, kSmallest = 1e-12, kNarrowest = 1e-7;

std::vector<study::Setting> read_values(const TomlTable& vary, const toml::table& table) {
  const toml::array* list = table.get("values")->as_array();
  if (list == nullptr || list->empty())
    refuse(vary.place("values"), "\"values\" in [[vary]] is no list with anything in it",
           "one or more settings, as [0.1, 0.2]");
  std::vector<study::Setting> values;
  for (const toml::node& entry : *list) {
    study::Setting setting = setting_of(entry, "\"values\" in [[vary]]");
    if (std::find(values.begin(), values.end(), setting) != values.end())
      refuse(place_of(entry.source()), "the setting " + setting.toml + " a second time",
             "settings that differ");
    values.push_back(std::move(setting));
  }
  return values;
}

void require_fair(const study::Range& range, const model::SourcePlace& place) {
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  const double width = range.high - range.low;
  if (range.logarithmic && !(range.low > 0))
    refuse(place, "a range on a log scale from " + model::shortest(range.low),
           "a range that begins above zero");
  if (largest > kLargest || largest < kSmallest || width < kNarrowest * largest ||
      (range.logarithmic && range.low < kSmallest))
    refuse(place, "the range is too wide or too narrow for decimal steps",
           "numbers from 1e-12 to 1e12, further apart than their seventh digit");
}

study::Range read_range(const TomlTable& vary, bool counted) {
  study::Range range;
  std::tie(range.low, range.high) = vary.ascending_pair("range");
  if (vary.has("scale")) range.logarithmic = vary.one_of("scale", {"linear", "log"}) == "log";
  require_fair(range, vary.place("range"));
  if (vary.has("steps")) {
    const int steps = vary.whole("steps");
    if (steps < 2 || static_cast<std::size_t>(steps) > study::kMostCases)
      refuse(vary.place("steps"), "\"steps\" in [[vary]] is " + std::to_string(steps),
             "a whole number from 2 to 100000");
    range.steps = static_cast<std::size_t>(steps);
  } else if (counted) {
    refuse(vary.place("range"), "a range without \"steps\", and the method counts them",
           "steps = n beside it, or a method that draws or searches");
  }
  return range;
}

VariedKey read_vary(const toml::table& table, bool counted) {
  const TomlTable vary(table, "[[vary]]", {"key", "values", "range", "steps", "scale", "base"});
  VariedKey read{{vary.text("key"), {}, {}, {}}, vary.place("key")};
  require_override_key(read.variable.key, read.place);
  if (vary.has("values") == vary.has("range"))
    refuse(vary.place(),
           "[[vary]] has " + std::string(vary.has("values") ? "both values and range"
                                                            : "neither values nor range"),
           "one of the two");
  for (const char* key : {"steps", "scale"})
    if (vary.has(key) && !vary.has("range"))
      refuse(vary.place(key), "\"" + std::string(key) + "\" beside \"values\" changes nothing",
             "it only beside \"range\"");
  if (vary.has("values")) read.variable.values = read_values(vary, table);
  if (vary.has("range")) read.variable.range = read_range(vary, counted);
  if (vary.has("base")) read.variable.base = setting_of(*table.get("base"), "\"base\" in [[vary]]");
  return read;
}

struct KeyedValue {
  std::string key;
  const toml::node* value;
  model::SourcePlace place;
};

/// Both `"stage.finish.step" = 0.2` and `stage.finish.step = 0.2`.
void flatten(const toml::table& table, const std::string& prefix, std::vector<KeyedValue>& all) {
  for (const auto& [key, value] : table) {
    const std::string dotted = prefix + std::string(key.str());
    const toml::table* below = value.as_table();
    if (below != nullptr && !below->is_inline()) {
      flatten(*below, dotted + ".", all);
    } else {
      all.push_back({dotted, &value, place_of(key.source())});
    }
  }
}

/// In the order of the file.
std::vector<KeyedValue> keyed_values(const toml::table& table) {
  std::vector<KeyedValue> all;
  flatten(table, "", all);
  std::sort(all.begin(), all.end(), [](const KeyedValue& a, const KeyedValue& b) {
    return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
  });
  return all;
}

void add_keys(const toml::table& table, ListedCases& listed) {
  for (const KeyedValue& entry : keyed_values(table)) {
    require_override_key(entry.key, entry.place);
    listed.keys.push_back({{entry.key, {}, {}, {}}, entry.place});
  }
  if (listed.keys.empty() || listed.keys.size() > kMostVariedKeys)
    refuse(place_of(table.source()),
           "a [[case]] with " + std::to_string(listed.keys.size()) + " keys",
           "1 to " + std::to_string(kMostVariedKeys));
  refuse_overlaps(listed.keys);
}

std::vector<study::Setting> read_case(const toml::table& table, ListedCases& listed) {
  std::vector<KeyedValue> entries = keyed_values(table);
  std::vector<study::Setting> settings;
  for (VariedKey& key : listed.keys) {
    const auto found = std::find_if(entries.begin(), entries.end(), [&](const KeyedValue& entry) {
      return entry.key == key.variable.key;
    });
    if (found == entries.end())
      refuse(place_of(table.source()), "a [[case]] without \"" + key.variable.key + "\"",
             "the keys of the first one in every one");
    settings.push_back(setting_of(*found->value, "\"" + key.variable.key + "\" in [[case]]"));
    entries.erase(found);
  }
  if (!entries.empty())
    refuse(entries.front().place,
           "\"" + entries.front().key + "\", which the first [[case]] does not have",
           "the keys of the first one in every one");
  return settings;
}

}  // namespace

void require_override_key(const std::string& key, const model::SourcePlace& place) {
  const bool has_empty_name =
      key.empty() || key.front() == '.' || key.back() == '.' || key.find("..") != std::string::npos;
  const bool has_others = std::any_of(key.begin(), key.end(), [](char c) {
    return c == '=' || static_cast<unsigned char>(c) <= ' ' || c == '\x7F';
  });
  if (has_empty_name || has_others || std::count(key.begin(), key.end(), '.') > kMostDots)
    refuse(place, "no key of a job: " + model::in_quotes(key),
           "dotted names, as \"stage.finish.step\"");
}

void refuse_overlaps(const std::vector<VariedKey>& keys) {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string& later = keys[i].variable.key;
    for (std::size_t j = 0; j < i; ++j) {
      const std::string& earlier = keys[j].variable.key;
      if (later == earlier)
        refuse(keys[i].place, "the key \"" + later + "\" a second time", "each key once");
      if (later.starts_with(earlier + ".") || earlier.starts_with(later + "."))
        refuse(keys[i].place, "\"" + later + "\" beside \"" + earlier + "\"",
               "keys of which none holds another");
    }
  }
}

std::vector<VariedKey> read_varied(const TomlTable& root, bool counted) {
  std::vector<VariedKey> keys;
  for (const toml::table* table : root.tables("vary")) {
    if (keys.size() == kMostVariedKeys)
      refuse(place_of(table->source()), "more than " + std::to_string(kMostVariedKeys) + " keys",
             "fewer tables [[vary]]");
    keys.push_back(read_vary(*table, counted));
  }
  refuse_overlaps(keys);
  return keys;
}

ListedCases read_cases(const TomlTable& root) {
  const std::vector<const toml::table*> tables = root.tables("case");
  ListedCases listed;
  add_keys(*tables.front(), listed);
  std::set<std::vector<std::string>> seen;
  std::vector<std::set<std::string>> used(listed.keys.size());
  for (const toml::table* table : tables) {
    std::vector<study::Setting> settings = read_case(*table, listed);
    std::vector<std::string> texts;
    for (std::size_t v = 0; v < settings.size(); ++v) {
      texts.push_back(settings[v].toml);
      if (used[v].insert(settings[v].toml).second)
        listed.keys[v].variable.values.push_back(settings[v]);
    }
    if (!seen.insert(texts).second)
      refuse(place_of(table->source()), "a [[case]] that is there already", "cases that differ");
    listed.cases.push_back(std::move(settings));
  }
  return listed;
}

}  // namespace limitgauge::app
