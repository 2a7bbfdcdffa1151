#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Zips for tests.
namespace testat {
struct ZipItem {
    std::string name;  ///< a folder if it ends with a slash
    std::string bytes;
    std::optional<std::int64_t> modified = {};
    std::string link = {};  ///< where a symbolic link leads
};

/// With libarchive's writer.
void write_zip(std::filesystem::path const& file, std::vector<ZipItem> const& items);

/// An entry as bytes, with what libarchive does not write.
struct RawItem {
    std::string name;
    std::string bytes = "int x;";
    std::uint16_t flags = 0;                 ///< 1: encrypted, 0x800: the name is UTF-8
    std::uint32_t mode = 0100644;            ///< of Unix
    std::uint32_t wrong_crc = 0;             ///< xored to the checksum
    std::optional<std::uint32_t> size = {};  ///< what it claims to be, if that is a lie
};

/// The bytes of a zip of stored entries.
std::string raw_zip(std::vector<RawItem> const& items);

/// An xlsx of text cells; what is a number is written as one.
void write_xlsx(std::filesystem::path const& file, std::vector<std::vector<std::string>> const& rows);

std::string bytes_of(std::filesystem::path const& file);
}  // namespace testat
