#include <algorithm>
#include <map>

#include "reports/compare/remarks.h"

namespace limitgauge::reports::compare {
namespace {

using record::InputRecord;

const InputRecord* find_input(const std::vector<InputRecord>& all, const InputRecord& wanted) {
  const auto same = std::find_if(all.begin(), all.end(), [&](const InputRecord& i) {
    return i.role == wanted.role && i.file == wanted.file;
  });
  if (same != all.end()) return &*same;
  // Another folder, another command line: of a role that only one file has, it is that one.
  const auto has_role = [&](const InputRecord& i) { return i.role == wanted.role; };
  if (std::count_if(all.begin(), all.end(), has_role) != 1) return nullptr;
  return &*std::find_if(all.begin(), all.end(), has_role);
}

/// The cage and the stock say what is measured: with others, figures are of another part.
std::string consequence(const std::string& role) {
  if (role == "cage") return ": the figures are those of another surface";
  return role == "stock" ? ": the figures are those of another stock" : "";
}

std::vector<Remark> compare_inputs(const std::vector<InputRecord>& base,
                                   const std::vector<InputRecord>& now) {
  std::vector<Remark> out;
  const auto add = [&out](const std::string& text) {
    out.push_back({"input", Judgement::not_judged, text});
  };
  for (const InputRecord& input : now) {
    const InputRecord* was = find_input(base, input);
    if (!was)
      add(input.role + " " + input.file + " is new");
    else if (was->sha256 != input.sha256)
      add(input.role + " " + input.file + " was changed" + consequence(input.role));
  }
  for (const InputRecord& input : base)
    if (!find_input(now, input)) add(input.role + " " + input.file + " is read no more");
  return out;
}

/// Names of `run` that `other` has, too, in their order.
std::vector<std::string> shared_names(const record::RunRecord& run,
                                      const record::RunRecord& other) {
  std::vector<std::string> out;
  for (const record::StageRecord& stage : run.stages)
    if (std::any_of(other.stages.begin(), other.stages.end(),
                    [&](const auto& o) { return o.name == stage.name; }))
      out.push_back(stage.name);
  return out;
}

}  // namespace

std::vector<Remark> compare_heads(const record::RunRecord& base, const record::RunRecord& now) {
  std::vector<Remark> out;
  const auto name = [&out](const std::string& id, const std::string& text) {
    out.push_back({id, Judgement::not_judged, text});
  };
  if (base.job != now.job)
    name("job", "these are results of two jobs: " + base.job + " and " + now.job);
  if (base.version != now.version)
    name("version", "Limitgauge was " + base.version + ", is " + now.version);
  for (Remark& remark : compare_inputs(base.inputs, now.inputs)) out.push_back(std::move(remark));
  if (shared_names(base, now) != shared_names(now, base))
    name("order", "the stages follow each other in another order");
  return out;
}

}  // namespace limitgauge::reports::compare
