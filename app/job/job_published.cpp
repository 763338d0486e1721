#include "app/job/job_parts.h"

namespace limitgauge::app {
namespace {

std::optional<int> read_count(const TomlTable& table, const char* key) {
  if (!table.has(key)) return std::nullopt;
  return table.whole(key);
}

std::optional<double> read_figure(const TomlTable& table, const char* key) {
  if (!table.has(key)) return std::nullopt;
  return table.not_negative(key);
}

std::optional<std::pair<int, int>> read_span(const TomlTable& table, const char* key) {
  if (!table.has(key)) return std::nullopt;
  return table.whole_pair(key);
}

}  // namespace

reports::PublishedFigures read_published(const TomlTable& root) {
  const TomlTable table(
      root.table("published"), "[published]",
      {"source", "patches", "depth", "sampling_interval", "seconds", "memory_mb", "stage"});
  reports::PublishedFigures published;
  published.source = table.text("source");
  published.patches = read_count(table, "patches");
  published.depth = read_span(table, "depth");
  published.sampling_interval = read_span(table, "sampling_interval");
  published.seconds = read_figure(table, "seconds");
  published.memory_mb = read_figure(table, "memory_mb");
  if (!table.has("stage")) return published;
  for (const toml::table* entry : table.tables("stage")) {
    const TomlTable stage(*entry, "[[published.stage]]",
                          {"name", "planes", "seconds", "memory_mb"});
    published.stages.push_back({stage.text("name"), read_count(stage, "planes"),
                                read_figure(stage, "seconds"), read_figure(stage, "memory_mb")});
  }
  return published;
}

}  // namespace limitgauge::app
