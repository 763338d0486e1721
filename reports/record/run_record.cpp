#include "reports/record/run_record.h"

#include <limits>

#include "model/base/text_file.h"
#include "reports/record/json_tree.h"
#include "reports/record/stage_reader.h"

namespace limitgauge::reports::record {
namespace {

constexpr const char* kSchema = "limitgauge.result/";

int read_schema(const JsonValue& root) {
  const std::string known = std::string(kSchema) + "1 or " + kSchema + "2";
  const std::optional<JsonValue> schema = root.find("schema");
  if (!schema) root.refuse("has no key \"schema\"", "a result of schema " + known);
  for (const int version : {1, 2})
    if (schema->text() == kSchema + std::to_string(version)) return version;
  schema->refuse("is another one", known);
}

/// A finding may name a line of an earlier stage's program: all are gathered first.
LineTexts line_texts(const std::vector<JsonValue>& stages) {
  LineTexts out;
  for (const JsonValue& stage : stages) {
    const std::string name = stage["name"].text();
    for (const JsonValue& entry : stage.items("program_lines")) {
      const std::uint64_t line = entry["line"].count(std::numeric_limits<std::uint32_t>::max());
      out[{name, static_cast<std::uint32_t>(line)}] = entry["text"].text();
    }
  }
  return out;
}

std::vector<InputRecord> read_inputs(const JsonValue& root) {
  std::vector<InputRecord> out;
  for (const JsonValue& input : root.items("inputs"))
    out.push_back({input["role"].text(), input["file"].text(), input["sha256"].text()});
  return out;
}

void read_surface(const JsonValue& surface, RunRecord& out) {
  out.cage = surface["cage"].text();
  const std::vector<JsonValue> corners = surface["bbox_mm"].items();
  if (corners.size() != 2)
    surface["bbox_mm"].refuse("has not two corners", "lower and upper corner");
  out.surface_diagonal_mm = model::distance(corners[0].point(), corners[1].point());
}

}  // namespace

RunRecord read_result_json(std::istream& in, const std::string& shown) {
  const nlohmann::json tree = parse_json(model::read_text(in, shown), shown);
  const JsonValue root(tree, shown);
  RunRecord out;
  out.schema = read_schema(root);
  out.job = root["job"].text();
  out.version = root["version"].text();
  out.created = root["created"].text();
  out.threads = static_cast<unsigned>(root["threads"].count(std::numeric_limits<unsigned>::max()));
  if (out.threads == 0) root["threads"].refuse("is zero", "one or more");
  out.verdict = read_verdict(root["verdict"]);
  out.inputs = read_inputs(root);
  read_surface(root["surface"], out);
  const std::vector<JsonValue> stages = root["stages"].items();
  const LineTexts texts = line_texts(stages);
  for (const JsonValue& stage : stages) out.stages.push_back(read_stage(stage, out.schema, texts));
  return out;
}

}  // namespace limitgauge::reports::record
