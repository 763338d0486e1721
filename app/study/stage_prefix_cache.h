#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <string>

#include "app/run/stage_prefix.h"

namespace limitgauge::app {

/// The last few prefixes by their keys, within a bound on their memory: those not used for longest
/// are let go, but never the one that was put in last.
class StagePrefixCache {
 public:
  static constexpr std::size_t kMostKept = 3;
  explicit StagePrefixCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}
  /// Nothing where there is none.
  std::shared_ptr<const StagePrefix> find(const std::string& key);
  void put(const std::string& key, std::shared_ptr<const StagePrefix> prefix);

 private:
  struct Entry {
    std::string key;
    std::shared_ptr<const StagePrefix> prefix;
    std::size_t bytes = 0;
  };
  std::list<Entry>::iterator entry(const std::string& key);

  std::size_t most_bytes_;
  std::list<Entry> entries_;  ///< the last used first
};

}  // namespace limitgauge::app
