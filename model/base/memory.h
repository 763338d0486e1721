#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace limitgauge::model {

/// The one rule of what a run may take at its peak, or all workers of a study together: four fifths
/// of what is available when it is asked. Ask once, when the work begins: what is chosen by it must
/// not change on the way. The rest is for what a forecast is too low by, and for what others take
/// meanwhile.
std::uint64_t memory_limit_bytes(const std::filesystem::path& root = "/");

/// Memory that this process and its children may still take: the least of what the kernel holds to
/// be available without driving the machine to its swap, of what the control groups that we are in
/// have left (both versions, all that they lie in, file pages that the kernel can drop not counted
/// as taken), and of what this process's limits of address space, less what threads reserve of it,
/// and of data leave. The largest number where nothing is known. `root` stands in for "/" in tests.
std::uint64_t available_memory_bytes(const std::filesystem::path& root = "/");

/// "1234 MiB" for messages.
std::string in_mib(double bytes);

/// Gives memory that was freed back to the machine, where the allocator has kept it for later:
/// between phases of a run, so that its peak is that of its largest phase.
void return_freed_memory();

/// Where the process may have so many addresses only (`ulimit -v`), has all threads allocate from
/// one heap: glibc reserves 64 MiB of addresses for each that has its own, and libraries end the
/// program where none are left. To be called before threads begin.
void spare_addresses();

/// Asks for large pages for an array that is about to be filled: the kernel then clears and hands
/// out 2 MiB at a time where it would 4 KiB. A hint; what the array holds stays.
void prefer_large_pages(void* begin, std::size_t bytes);

/// Of an empty vector that is about to grow to `count` elements: room for them in large pages.
template <class Vector>
void reserve_large(Vector& vector, std::size_t count) {
  vector.reserve(count);
  prefer_large_pages(vector.data(), count * sizeof(typename Vector::value_type));
}

/// From now on the peak counts anew, where the kernel lets us say so.
void reset_process_peak();
/// Most memory that this process had in use since then; 0 where the kernel does not say.
std::uint64_t process_peak_bytes();

}  // namespace limitgauge::model
