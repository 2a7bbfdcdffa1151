#include "compile/compile.h"
#include "text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace testat {
namespace {
constexpr std::size_t most_bytes = 1'000'000;
/// Larger files are not even read.
constexpr std::uintmax_t largest_hashed = 256 << 20;
constexpr char too_large[] = "the file is larger than 1 MB";

std::string read_file(std::filesystem::path const& file, std::uintmax_t size)
{
    std::ifstream in(file, std::ios::binary);
    std::string bytes(size, '\0');
    if (!in.read(bytes.data(), std::streamsize(size)))
        throw UnreadableInput(file.string() + ": cannot be read: " + std::strerror(errno));
    return bytes;
}

bool is_control(char c)
{
    return static_cast<unsigned char>(c) < 0x20 && std::string_view("\t\n\v\f\r").find(c) == std::string_view::npos;
}

/// Latin-1 and UTF-8 both count as text, and a few control characters, which text copied from elsewhere may bring
/// along; what they mean is for the compiler to say.
bool is_binary(std::string const& bytes)
{
    constexpr double most_controls = 0.01;
    auto const controls = std::count_if(bytes.begin(), bytes.end(), is_control);
    return double(controls) > most_controls * double(bytes.size()) || bytes.find('\0') != std::string::npos;
}

std::optional<std::string> reason_to_refuse(std::string const& bytes)
{
    if (bytes.find_first_not_of(" \t\r\n") == std::string::npos)
        return "the file is empty";
    if (bytes.size() > most_bytes)
        return too_large;
    if (is_binary(bytes))
        return "this is not a text file: save exercise_03.cpp as UTF-8 text and hand in that file";
    return std::nullopt;
}
}  // namespace

Submission read_submission(std::filesystem::path const& file)
{
    std::error_code error;
    auto const status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
        throw UnreadableInput(file.string() + ": no such file");
    if (std::filesystem::is_directory(status))
        throw UnreadableInput(file.string() + ": is a directory; name the file exercise_03.cpp in it");
    if (!std::filesystem::is_regular_file(status))
        throw UnreadableInput(file.string() + ": is not a regular file");
    auto const size = std::filesystem::file_size(file, error);
    if (error)
        throw UnreadableInput(file.string() + ": " + error.message());

    Submission submission;
    submission.file = one_line(file.filename().string(), 200);
    if (size > largest_hashed) {
        submission.refused = too_large;
        return submission;
    }
    std::string bytes = read_file(file, size);
    submission.sha256 = sha256(bytes);
    submission.refused = reason_to_refuse(bytes);
    if (!submission.refused)
        submission.text = std::move(bytes);
    return submission;
}
}  // namespace testat
