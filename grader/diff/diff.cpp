#include "diff/diff.h"

#include "installation.h"
#include "json_schema.h"
#include "report/png.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace testat {
namespace {
std::string read_bytes(std::filesystem::path const& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in || std::filesystem::is_directory(file))
        throw std::invalid_argument(file.string() + ": cannot be read");
    return {std::istreambuf_iterator<char>(in), {}};
}

Report read(std::filesystem::path const& file)
{
    try {
        return read_report(file, installation().rubric.parent_path() / "report.schema.json");
    } catch (BadJson const& e) {
        throw std::invalid_argument(e.what());
    }
}
}  // namespace

Difference diff(std::filesystem::path const& a, std::filesystem::path const& b, Language language)
{
    std::string const bytes_a = read_bytes(a), bytes_b = read_bytes(b);
    if (is_png(bytes_a) != is_png(bytes_b))
        throw std::invalid_argument("a picture and a report cannot be compared");
    if (is_png(bytes_a))
        return diff_pictures(decode_png(bytes_a), decode_png(bytes_b), language);
    return diff_reports(read(a), read(b), language);
}
}  // namespace testat
