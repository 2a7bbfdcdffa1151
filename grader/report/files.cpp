#include "json_schema.h"
#include "process/run.h"
#include "report/report.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace testat {
namespace {
void write_and_sync(std::filesystem::path const& file, std::string const& bytes)
{
    int const fd = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (fd < 0)
        throw std::runtime_error(std::strerror(errno));
    try {
        write_all(fd, bytes.data(), bytes.size());
    } catch (...) {
        close(fd);
        throw;
    }
    bool const synced = fsync(fd) == 0;
    if (close(fd) != 0 || !synced)
        throw std::runtime_error(std::strerror(errno));
}
}  // namespace

void make_output_directory(std::filesystem::path const& directory)
{
    std::string const option = "--out " + directory.string();
    std::error_code error;
    std::filesystem::create_directories(directory, error);
    if (!std::filesystem::is_directory(directory))
        throw std::invalid_argument(option + ": cannot be made: " + error.message());
    auto const trial = directory / (".testat-" + std::to_string(getpid()));
    bool const writable = std::ofstream(trial).is_open();
    std::filesystem::remove(trial, error);
    if (!writable)
        throw std::invalid_argument(option + ": cannot be written to");
}

void write_file(std::filesystem::path const& file, std::string const& bytes)
{
    std::ofstream out(file, std::ios::binary);
    out << bytes;
    if (!out.flush())
        throw std::runtime_error("cannot write " + file.string());
}

void write_atomically(std::filesystem::path const& file, std::string const& bytes)
{
    auto const temporary = file.string() + "." + std::to_string(getpid()) + ".part";
    try {
        write_and_sync(temporary, bytes);
        std::filesystem::rename(temporary, file);
    } catch (std::exception const& e) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw std::runtime_error("cannot write " + file.string() + ": " + e.what());
    }
}

Report read_if_there(std::filesystem::path const& file)
{
    std::ifstream in(file);
    Report const document = in ? Report::parse(in, nullptr, false) : Report();
    return document.is_object() ? document : Report::object();
}

Report read_report(std::filesystem::path const& file, std::filesystem::path const& schema)
{
    nlohmann::json const plain = read_json(file);
    validate_json(plain, schema, file.string());
    std::ifstream in(file);
    return Report::parse(in);  // again, in the order of the file
}
}  // namespace testat
