#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace limitgauge::model {

/// Writes `file` through `write`. Throws ResourceError naming the file where that fails, the disk
/// being full among others.
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);
/// Writes `bytes` as `file`; errors as above.
void write_file(const std::filesystem::path& file, std::string_view bytes);
/// Makes `folder` with its parents. Throws ResourceError.
void make_folder(const std::filesystem::path& folder);

/// Writes a file that is there whole or not at all, whoever else writes, reads or is killed, and
/// whenever the power fails: beside its name first, synced, then renamed. Behind a symbolic link it
/// writes what the link leads to; what is no regular file (a pipe, a device) is written into. Makes
/// the folders above it. Throws ResourceError.
void write_whole_file(const std::filesystem::path& file,
                      const std::function<void(std::ostream&)>& write);
void write_whole_file(const std::filesystem::path& file, std::string_view bytes);
/// True for the name of what write_whole_file() has not renamed yet.
bool is_part_file(std::string_view name);

/// Has the disk hold what was written to `file`, a folder's list of names among others. Throws
/// ResourceError.
void sync_file(const std::filesystem::path& file);

/// The same of all that was written to the file system that `folder` is on, by whomever: of many
/// files it takes a twentieth of the time that one after the other takes. Throws ResourceError.
void sync_file_system(const std::filesystem::path& folder);

/// 32 hexadecimal digits that nobody can foresee: processes of several machines and containers make
/// names in one folder, and their numbers may be the same.
std::string random_digits();

/// Where `path` leads once its symbolic links are followed, the last one too; what is missing in
/// it stands as it is stated. Throws InputError where they lead round in a circle.
std::filesystem::path behind_links(const std::filesystem::path& path);

}  // namespace limitgauge::model
