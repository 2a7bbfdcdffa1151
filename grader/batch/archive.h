#pragma once
#include "batch/contents.h"

/// Zips from outside: nothing in them is believed.
namespace testat {
/// Beyond the first two, a whole zip is refused; beyond the others, an entry.
struct UnpackLimits {
    std::size_t entries = max_entries;
    std::uint64_t bytes = 512ull << 20;       ///< unpacked, all entries together
    std::uint64_t entry_bytes = 64ull << 20;  ///< unpacked
    std::uint64_t ratio = 100;                ///< of unpacked to packed bytes; no source file is packed that well,
    std::uint64_t ratio_from = 1ull << 20;    ///< ... unless it is short
};

/// Writes the files of a zip into `directory`, each as <number>/<its name, made safe>, so that names of the zip decide
/// nothing: neither where a file goes, nor whether it replaces another one. An entry is left out with a remark if it is
/// a link or a device, encrypted, beyond the limits, if its path is absolute or has "..", or if its name is marked as
/// UTF-8 and is not, which hides it from libarchive; where there is no such mark, invalid UTF-8 is replaced. Archives
/// in the archive are files like others.
///
/// `directory` is made; it must not exist or be empty. Throws std::invalid_argument for a file that is no zip, a
/// damaged zip or one beyond the limits, and std::runtime_error if it cannot write. Then `directory` is empty again.
Contents unpack(std::filesystem::path const& zip, std::filesystem::path const& directory,
                UnpackLimits const& limits = {});
}  // namespace testat
