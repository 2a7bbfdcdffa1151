#include "batch/zips.h"

#include "report/report.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <pugixml.hpp>
#include <sstream>

namespace testat {
namespace {
struct Free {
    void operator()(archive* a) const { archive_write_free(a); }
    void operator()(archive_entry* e) const { archive_entry_free(e); }
};

void add(archive* zip, ZipItem const& item)
{
    std::unique_ptr<archive_entry, Free> const entry(archive_entry_new());
    bool const is_folder = item.name.back() == '/';
    archive_entry_copy_pathname(entry.get(), item.name.c_str());
    archive_entry_set_filetype(entry.get(), is_folder ? AE_IFDIR : item.link.empty() ? AE_IFREG : AE_IFLNK);
    archive_entry_set_perm(entry.get(), 0755);
    if (!item.link.empty())
        archive_entry_copy_symlink(entry.get(), item.link.c_str());
    archive_entry_set_size(entry.get(), std::int64_t(item.bytes.size()));
    if (item.modified)
        archive_entry_set_mtime(entry.get(), *item.modified, 0);
    EXPECT_EQ(archive_write_header(zip, entry.get()), ARCHIVE_OK) << archive_error_string(zip);
    if (!item.bytes.empty())
        archive_write_data(zip, item.bytes.data(), item.bytes.size());
}

std::uint32_t crc32(std::string const& bytes)
{
    std::uint32_t crc = ~0u;
    for (char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc >> 1 ^ ((crc & 1) != 0 ? 0xedb88320u : 0u);
    }
    return ~crc;
}

/// Little endian, so many bytes.
std::string number(std::uint64_t value, int bytes)
{
    std::string text;
    for (int i = 0; i < bytes; ++i)
        text += char(value >> (8 * i));
    return text;
}

/// What the local and the central header have in common: from the flags to the lengths of name and extra field.
std::string common(RawItem const& item)
{
    std::uint32_t const size = std::uint32_t(item.bytes.size());
    std::uint32_t const time = 0x5978'0000;  // 2024-11-24
    return number(item.flags, 2) + number(0, 2) + number(time, 4) + number(crc32(item.bytes) ^ item.wrong_crc, 4) +
           number(item.size.value_or(size), 4) + number(item.size.value_or(size), 4) + number(item.name.size(), 2) +
           number(0, 2);
}

bool is_number(std::string const& text)
{
    return !text.empty() && text.find_first_not_of("0123456789.") == std::string::npos;
}
}  // namespace

void write_zip(std::filesystem::path const& file, std::vector<ZipItem> const& items)
{
    std::unique_ptr<archive, Free> const zip(archive_write_new());
    archive_write_set_format_zip(zip.get());
    ASSERT_EQ(archive_write_open_filename(zip.get(), file.c_str()), ARCHIVE_OK);
    for (auto const& item : items)
        add(zip.get(), item);
    archive_write_close(zip.get());
}

std::string raw_zip(std::vector<RawItem> const& items)
{
    std::string entries;
    std::string directory;
    for (auto const& item : items) {
        directory += number(0x02014b50, 4) + number(3 << 8 | 20, 2) + number(20, 2) + common(item) + number(0, 6) +
                     number(std::uint64_t(item.mode) << 16, 4) + number(entries.size(), 4) + item.name;
        entries += number(0x04034b50, 4) + number(20, 2) + common(item) + item.name + item.bytes;
    }
    return entries + directory + number(0x06054b50, 4) + number(0, 4) + number(items.size(), 2) +
           number(items.size(), 2) + number(directory.size(), 4) + number(entries.size(), 4) + number(0, 2);
}

void write_xlsx(std::filesystem::path const& file, std::vector<std::vector<std::string>> const& rows)
{
    pugi::xml_document sheet;
    pugi::xml_document strings;
    auto data = sheet.append_child("worksheet").append_child("sheetData");
    auto table = strings.append_child("sst");
    int count = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        auto row = data.append_child("row");
        for (std::size_t j = 0; j < rows[i].size(); ++j) {
            auto cell = row.append_child("c");
            cell.append_attribute("r") = fmt::format("{}{}", char('A' + j), i + 1).c_str();
            if (!is_number(rows[i][j]))
                cell.append_attribute("t") = "s";
            cell.append_child("v").text() =
                is_number(rows[i][j]) ? rows[i][j].c_str() : fmt::format("{}", count).c_str();
            if (!is_number(rows[i][j]) && ++count > 0)
                table.append_child("si").append_child("t").text() = rows[i][j].c_str();
        }
    }
    std::ostringstream sheet_xml;
    std::ostringstream strings_xml;
    sheet.save(sheet_xml);
    strings.save(strings_xml);
    write_zip(file, {{"xl/worksheets/sheet1.xml", sheet_xml.str()}, {"xl/sharedStrings.xml", strings_xml.str()}});
}

std::string bytes_of(std::filesystem::path const& file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    return bytes.str();
}
}  // namespace testat
