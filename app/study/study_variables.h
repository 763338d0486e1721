#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "app/toml/toml_table.h"
#include "study/plan/plan.h"
#include "study/store/table.h"

/// The readers of what a study file varies.
namespace limitgauge::app {

/// Throws the InputError about a place of a study file.
[[noreturn]] void refuse(const model::SourcePlace& place, const std::string& wrong,
                         const std::string& expected);

/// A value of a TOML file as a setting of a study: numbers with the fewest digits that read back as
/// they are, so that 0.20 and 0.2 are the same setting. Throws InputError at the value's place for
/// what no job key takes (dates) and for numbers that are not finite; `what` names it there.
study::Setting setting_of(const toml::node& value, const std::string& what);

/// A key that is varied, with where the study file says so.
struct VariedKey {
  study::Variable variable;
  model::SourcePlace place;
};

/// Keys of one study at most.
inline constexpr std::size_t kMostVariedKeys = 64;

/// The tables [[vary]]; two of one key are an error, as are ranges without steps where `counted`.
std::vector<VariedKey> read_varied(const TomlTable& root, bool counted);

/// What the tables [[case]] list: keys in the order of the first of them, each with its settings in
/// the order of their first use.
struct ListedCases {
  std::vector<VariedKey> keys;
  std::vector<std::vector<study::Setting>> cases;
};
ListedCases read_cases(const TomlTable& root);

/// Whether --set can be given this key: names with single dots between them.
void require_override_key(const std::string& key, const model::SourcePlace& place);
/// Keys of which one is another or holds it.
void refuse_overlaps(const std::vector<VariedKey>& keys);

}  // namespace limitgauge::app
