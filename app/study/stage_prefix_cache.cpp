#include "app/study/stage_prefix_cache.h"

#include <algorithm>

namespace limitgauge::app {

std::list<StagePrefixCache::Entry>::iterator StagePrefixCache::entry(const std::string& key) {
  return std::find_if(entries_.begin(), entries_.end(),
                      [&](const Entry& entry) { return entry.key == key; });
}

std::shared_ptr<const StagePrefix> StagePrefixCache::find(const std::string& key) {
  const auto found = entry(key);
  if (found == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, found);
  return entries_.front().prefix;
}

void StagePrefixCache::put(const std::string& key, std::shared_ptr<const StagePrefix> prefix) {
  if (const auto found = entry(key); found != entries_.end()) entries_.erase(found);
  const std::size_t bytes = prefix->memory_bytes();
  entries_.push_front({key, std::move(prefix), bytes});
  std::size_t sum = 0;
  for (const Entry& kept : entries_) sum += kept.bytes;
  const auto too_many = [&] {
    return entries_.size() > kMostKept || (sum > most_bytes_ && entries_.size() > 1);
  };
  for (; too_many(); entries_.pop_back()) sum -= entries_.back().bytes;
}

}  // namespace limitgauge::app
