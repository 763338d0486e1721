#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "history/entry.h"

namespace limitgauge::tests {

/// A run of two stages with `figures` figures each, all told apart by `number`.
history::Entry sample_entry(int number, int figures = 3);

/// Runs SQL as anybody could, and gives the first column of its last row, as text. Throws
/// std::runtime_error.
std::string query(const std::filesystem::path& file, const std::string& sql);

/// How SQLite would answer `sql`: a line a step.
std::string plan(const std::filesystem::path& file, const std::string& sql);

std::string bytes_of(const std::filesystem::path& file);

/// Process id of a child in which `work` runs; it ends with what that returns, 99 after an
/// exception.
int start_child(const std::function<int()>& work);
/// Its exit code, or minus the signal that ended it.
int wait_for(int child);

}  // namespace limitgauge::tests
