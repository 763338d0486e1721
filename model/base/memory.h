#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace limitgauge::model {

/// The most that a run's grids and moves may take, in bytes: three quarters of the memory that the
/// machine has, whatever else runs on it now, so that one machine always chooses the same layout.
std::size_t run_memory_limit_bytes();

/// The memory that several runs beside each other may take together: nine tenths of what is
/// available now. Their forecasts hold a reserve of their own.
std::uint64_t shared_memory_limit_bytes();

/// Memory that this process and its children may still take without driving the machine to its
/// swap: what the kernel holds to be available, within the limits of the control groups that we
/// are in. The largest number where nothing is known. `root` stands in for "/" in tests.
std::uint64_t available_memory_bytes(const std::filesystem::path& root = "/");

/// From now on the peak counts anew, where the kernel lets us say so.
void reset_process_peak();
/// Most memory that this process had in use since then; 0 where the kernel does not say.
std::uint64_t process_peak_bytes();

}  // namespace limitgauge::model
