#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace limitgauge::app {

/// What a folder of results says of itself: the SHA-256 of each of its files, a line a file, as
/// `sha256sum --check` reads it. It proves, file by file, what may be deleted as ours.
inline constexpr const char* kManifestFile = "manifest.sha256";
/// In a folder of results that is not whole: why.
inline constexpr const char* kIncompleteFile = "INCOMPLETE.txt";

/// Writes the manifest of all that is in `folder`, and has the disk hold it with all of that.
/// Throws ResourceError.
void seal(const std::filesystem::path& folder);

/// What tells one sealed folder from another, with other results or of another run; nothing where
/// `folder` has no manifest.
std::optional<std::string> seal_of(const std::filesystem::path& folder);

/// Whether `entry`, relative to `folder`, is the file that was sealed there: unknown where `folder`
/// has no manifest. Throws ResourceError where it breaks while it is read.
enum class Sealed { unknown, as_written, otherwise };
Sealed sealed(const std::filesystem::path& folder, const std::filesystem::path& entry);

/// Something in `folder`, relative to it, that its manifest does not prove to be ours: a file that
/// it does not name or that was changed since, a link, a folder without files of ours. Nothing
/// where all is ours. Throws ResourceError where it cannot be looked at.
std::optional<std::filesystem::path> foreign_in(const std::filesystem::path& folder);

/// Deletes what the manifest proves to be ours, and the folder where nothing else is in it; says
/// whether it is gone. Does not throw.
bool remove_ours(const std::filesystem::path& folder);

}  // namespace limitgauge::app
