#include "app/share/piece_store.h"

#include "app/output/checksum.h"
#include "app/run/packed_path.h"

namespace limitgauge::app {
namespace {

constexpr std::string_view kSharedBegin = "limitgauge shared stage 2\n";
constexpr std::size_t kWords = 3;
constexpr const char* kNone = "-";
/// A path without moves: start, chord error, how many, and how many axes.
constexpr std::size_t kPathBytes = 48;

}  // namespace

std::string to_bytes(const SharedStage& shared) {
  model::Packer out;
  out.mark(kSharedBegin);
  out.text(shared.job_key);
  out.number(std::uint64_t{shared.stage});
  out.number(std::uint64_t{shared.paths.size()});
  for (std::size_t i = 0; i < shared.paths.size(); ++i) {
    pack_path(out, *shared.paths[i]);
    pack_axes(out, shared.axes[i].get());
  }
  return out.take();
}

std::optional<SharedStage> shared_stage_of(std::string_view bytes) {
  model::Unpacker in(bytes);
  in.mark(kSharedBegin);
  SharedStage shared;
  shared.job_key = in.text();
  shared.stage = in.number<std::uint64_t>();
  for (std::size_t left = in.count(kPathBytes); left > 0 && in.good(); --left) {
    shared.paths.push_back(std::make_shared<const model::Toolpath>(unpack_path(in)));
    shared.axes.push_back(unpack_axes(in, *shared.paths.back()));
  }
  if (!in.done() || shared.paths.size() != shared.stage + 1) return std::nullopt;
  return shared;
}

std::vector<std::string> words_of(const PieceTask& task) {
  return {task.stage_key, task.reach_key.empty() ? kNone : task.reach_key, to_text(task.piece)};
}

std::optional<PieceTask> piece_task_of(std::span<const std::string> words) {
  if (words.size() != kWords) return std::nullopt;
  const auto piece = verifier::piece_of(words[2]);
  if (!piece) return std::nullopt;
  return PieceTask{words[0], words[1] == kNone ? std::string() : words[1], *piece};
}

std::string piece_key(const PieceTask& task) {
  std::string text = "piece";
  for (const std::string& word : words_of(task)) text += "\n" + word;
  return sha256_of(text);
}

}  // namespace limitgauge::app
