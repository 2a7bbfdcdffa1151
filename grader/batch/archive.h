#pragma once
#include "batch/contents.h"

/// Zips from outside: nothing in them is believed.
namespace testat {
constexpr std::uint64_t max_entry_bytes = 64ull << 20;
constexpr std::uint64_t max_unpacked_bytes = 512ull << 20;

/// An entry of more than a megabyte that was packed into less than a hundredth is no source file.
constexpr std::uint64_t max_ratio = 100;

/// Writes the files of a zip into `directory`, each as <number>/<its name, made safe>, so that names of the zip decide
/// nothing: neither where a file goes, nor whether it replaces another one. An entry is left out with a remark if it is
/// a link or a device, encrypted, larger than `max_entry_bytes`, packed beyond `max_ratio`, or if its path is absolute
/// or has "..". Archives in the archive are files like others.
///
/// `directory` is made; it must not exist or be empty. Throws std::invalid_argument for a file that is no zip, a
/// damaged zip, more than `max_entries` or `max_unpacked_bytes`, and std::runtime_error if it cannot write. Then
/// `directory` is empty again.
Contents unpack(std::filesystem::path const& zip, std::filesystem::path const& directory);
}  // namespace testat
