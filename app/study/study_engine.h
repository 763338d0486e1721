#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "study/execute/executor.h"
#include "study/store/store.h"

namespace limitgauge::app {

/// Job arrays of Slurm whose tasks run this program with the words of `worker`; their folder is
/// beside the store's entries. `note` and `stop` as below.
std::unique_ptr<study::Executor> slurm_engine(const EngineOptions& asked,
                                              const std::vector<std::string>& worker,
                                              const study::Store& store,
                                              const std::function<void(const std::string&)>& note,
                                              const std::atomic<bool>* stop);

/// What runs the cases of this study, as the command line asks for. `job` is absolute. `note` is
/// told of what was not expected. `stop` (null: never) is heeded while the engine is made. Throws
/// InputError where this machine does not have it.
std::unique_ptr<study::Executor> study_engine(const StudyCommand& command,
                                              const CommonOptions& common,
                                              const std::filesystem::path& job,
                                              const study::Store& store,
                                              const std::function<void(const std::string&)>& note,
                                              const std::atomic<bool>* stop = nullptr);

}  // namespace limitgauge::app
