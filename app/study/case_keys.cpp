#include "app/study/case_keys.h"

#include <algorithm>
#include <bit>

#include "app/inputs/input_checksums.h"
#include "app/job/job_parts.h"
#include "app/job/oriented_job.h"
#include "app/run/stage_planner.h"
#include "app/toml/toml_text.h"
#include "model/base/text_file.h"

namespace limitgauge::app {
namespace {

/// What a key is made of, part by part; each says what it is and how long.
class KeyText {
 public:
  explicit KeyText(const std::string& what) { add("what", what); }
  void add(const std::string& part, const std::string& content) {
    sum_.add(part + ' ' + std::to_string(content.size()) + '\n');
    sum_.add(content);
  }
  void add(const std::string& part, double number) {
    add(part, std::to_string(std::bit_cast<std::uint64_t>(number)));
  }
  std::string digits() { return sum_.digits(); }

 private:
  Sha256 sum_;
};

bool is_planned(const JobStage& stage) {
  return stage.plan.has_value();
}
bool is_program(const JobStage& stage) {
  return !stage.plan;
}

/// Everything that keys of one case are made of.
class KeySources {
 public:
  KeySources(const toml::table& table, const Job& job, InputCache& files)
      : table_(table),
        job_(job),
        program_sum_(files.checksum("/proc/self/exe").sha256),
        inputs_(input_checksums(
            job, [&](const std::filesystem::path& file) { return files.checksum(file); })) {}

  std::string result_key() const;
  std::string prefix_key(std::size_t stages) const;
  std::string model_key() const;

 private:
  void add_table(KeyText& key, const char* name) const;
  void add_files(KeyText& key, const char* role) const;
  void add_stage_tables(KeyText& key, std::size_t stages) const;
  void add_tools(KeyText& key, std::size_t stages) const;
  void add_tolerances(KeyText& key, std::size_t stages) const;
  bool uses_tool(std::size_t stages, std::string_view id) const;
  void add_programs(KeyText& key) const;
  template <class Is>
  bool any(std::size_t stages, const Is& is) const;

  const toml::table& table_;
  const Job& job_;
  std::string program_sum_;
  std::vector<reports::InputFile> inputs_;
};

template <class Is>
bool KeySources::any(std::size_t stages, const Is& is) const {
  return std::any_of(job_.stages.begin(), job_.stages.begin() + static_cast<std::ptrdiff_t>(stages),
                     is);
}

void KeySources::add_table(KeyText& key, const char* name) const {
  const toml::node* table = table_.get(name);
  key.add(name, table == nullptr ? std::string("none") : canonical(*table));
}

void KeySources::add_files(KeyText& key, const char* role) const {
  for (const reports::InputFile& input : inputs_)
    if (input.role == role) key.add(input.role, input.sha256);
}

void KeySources::add_stage_tables(KeyText& key, std::size_t stages) const {
  const toml::array& all = *table_.get_as<toml::array>("stage");
  for (std::size_t i = 0; i < stages; ++i) key.add("stage", canonical(*all.get(i)));
}

/// Programs may ask for any tool.
bool KeySources::uses_tool(std::size_t stages, std::string_view id) const {
  return any(stages, is_program) ||
         any(stages, [&](const JobStage& stage) { return stage.cutter.id == id; });
}

void KeySources::add_tools(KeyText& key, std::size_t stages) const {
  for (const toml::node& tool : *table_.get_as<toml::array>("tool"))
    if (uses_tool(stages, (*tool.as_table())["id"].value_or<std::string_view>("")))
      key.add("tool", canonical(tool));
}

/// Those of tools that only later stages use change nothing so far.
void KeySources::add_tolerances(KeyText& key, std::size_t stages) const {
  const toml::table* all = table_.get_as<toml::table>("tolerances");
  key.add("tolerances", all == nullptr ? "none" : "stated");
  if (all == nullptr) return;
  for (const auto& [name, value] : *all)
    if (name != "tool") key.add("tolerances." + std::string(name.str()), canonical(value));
  const toml::table* tools = all->get_as<toml::table>("tool");
  if (tools == nullptr) return;
  for (const auto& [id, value] : *tools)
    if (uses_tool(stages, id.str()))
      key.add("tolerances.tool." + std::string(id.str()), canonical(value));
}

/// A part of a program ends where a later stage's begins.
void KeySources::add_programs(KeyText& key) const {
  add_files(key, "program");
  const toml::array& all = *table_.get_as<toml::array>("stage");
  for (std::size_t i = 0; i < job_.stages.size(); ++i)
    if (!job_.stages[i].plan) key.add("stage with a program", canonical(*all.get(i)));
}

std::string KeySources::model_key() const {
  KeyText key("model 1");
  key.add("limitgauge", program_sum_);
  add_table(key, "surface");
  add_files(key, "cage");
  key.add("largest offset", model_request(job_).largest_offset_mm);
  return key.digits();
}

/// Voxel, offset of the model and the parts of programs are all that a stage takes from later ones;
/// all else that is chosen for it follows from the tables and files named here.
std::string KeySources::prefix_key(std::size_t stages) const {
  KeyText key("stages 1");
  key.add("limitgauge", program_sum_);
  if (any(stages, is_planned)) key.add("model", model_key());
  // The job's name stands in the programs that are written.
  for (const char* table : {"name", "surface", "stock", "machine", "post", "program_frame",
                            "fixture", "simulation", "verification"})
    add_table(key, table);
  add_tolerances(key, stages);
  for (const char* role : {"cage", "mesh", "stock", "fixture", "tool table"}) add_files(key, role);
  add_tools(key, stages);
  add_stage_tables(key, stages);
  if (!job_.voxel_mm) key.add("voxel", automatic_voxel_mm(job_));
  if (any(stages, is_program)) add_programs(key);
  return key.digits();
}

std::string KeySources::result_key() const {
  KeyText key("result 1");
  key.add("limitgauge", program_sum_);
  key.add("job", canonical(table_));
  for (const reports::InputFile& input : inputs_) {
    key.add(input.role, input.file);
    key.add("sum", input.sha256);
  }
  return key.digits();
}

}  // namespace

ReadCase read_case(const std::filesystem::path& file, std::span<const std::string> overrides,
                   InputCache& files) {
  const toml::table table = merged_job(model::read_text_file(file), file.string(), overrides);
  ReadCase read;
  read.job = read_merged_job(table, {file.parent_path(), {}, {}, files.stock_readers()});
  read.job.sources.push_back({JobFile::Role::job, file, file.string()});
  const KeySources sources(table, read.job, files);
  read.model = sources.model_key();
  read.keys.result = sources.result_key();
  for (std::size_t i = 1; i < read.job.stages.size(); ++i)
    read.keys.prefixes.push_back(sources.prefix_key(i));
  read.keys.prefix = read.keys.prefixes.empty() ? sources.prefix_key(0) : read.keys.prefixes.back();
  // Its stretches are what its program says: the keys have the program.
  read.job = oriented(std::move(read.job));
  return read;
}

struct CaseKeyMaker::Known {
  InputCache files;
};

CaseKeyMaker::CaseKeyMaker() : known_(std::make_unique<Known>()) {}
CaseKeyMaker::~CaseKeyMaker() = default;
CaseKeyMaker::CaseKeyMaker(CaseKeyMaker&&) noexcept = default;
CaseKeyMaker& CaseKeyMaker::operator=(CaseKeyMaker&&) noexcept = default;

CaseKeys CaseKeyMaker::keys(const std::filesystem::path& job,
                            std::span<const std::string> overrides) {
  return read_case(job, overrides, known_->files).keys;
}

CaseKeys case_keys(const std::filesystem::path& job, std::span<const std::string> overrides) {
  return CaseKeyMaker().keys(job, overrides);
}

}  // namespace limitgauge::app
