// A zip from anywhere becomes a list of uploads, or is refused; no file is outside the directory for it.
#include "batch/intake.h"
#include "file_in_memory.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace {
void check(testat::Intake const& intake, std::filesystem::path const& scratch)
{
    for (auto const& upload : intake.uploads) {
        bool const is_inside = upload.file.string().rfind(std::filesystem::canonical(scratch).string() + "/", 0) == 0;
        bool const is_name = !upload.student.empty() && upload.student.find('/') == std::string::npos;
        if (!is_inside || !is_name ||
            std::filesystem::symlink_status(upload.file).type() != std::filesystem::file_type::regular)
            std::abort();
    }
}
}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    FileInMemory const file(data, size);
    testat::TemporaryDirectory const root;
    std::filesystem::path const scratch = root.path() / "scratch";
    try {
        check(testat::take_in(file.path(), scratch, 1), scratch);
    } catch (std::invalid_argument const&) {  // as it says
    }
    auto const entries = std::filesystem::directory_iterator(root.path());
    if (std::any_of(begin(entries), end(entries), [&](auto const& entry) { return entry.path() != scratch; }))
        std::abort();
    return 0;
}
