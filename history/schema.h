#pragma once

#include <filesystem>

namespace limitgauge::history {

class Database;

/// "LGHI": tells a history from any other file of SQLite.
constexpr int kApplicationId = 0x4C474849;

/// Version of the schema that this program writes.
int newest_version();

/// Throws InputError for a file that is no history of Limitgauge, or one that is newer than this
/// program. Touches nothing. A file without content is a history without runs.
void require_history(const std::filesystem::path& file);

/// Brings the file from whatever version it is to the newest; within the caller's transaction.
void migrate(const Database& database);

}  // namespace limitgauge::history
