// The probe: the only program of ours that runs an upload. It knows questions, never answers.
#include "probe/server.h"

#include <sys/mman.h>
#include <sys/stat.h>

#include <cstdio>
#include <exception>
#include <stdexcept>

namespace {
std::vector<std::byte> read_request(int fd)
{
    struct stat status = {};
    if (fstat(fd, &status) != 0)
        throw std::runtime_error("no request on descriptor 3");
    auto const size = static_cast<std::size_t>(status.st_size);
    void* memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, fd, 0);
    if (memory == MAP_FAILED)
        throw std::runtime_error("cannot read the request");
    auto const* bytes = static_cast<std::byte const*>(memory);
    std::vector<std::byte> request(bytes, bytes + size);
    munmap(memory, size);
    return request;
}
}  // namespace

/// probe UPLOAD.so REFERENCES ASSETS, with the request on descriptor 3 and the answers going to descriptor 4.
int main(int argc, char** argv)
{
    if (argc != 4) {
        std::fputs("probe: started by testat, not by hand\n", stderr);
        return 2;
    }
    try {
        auto const request = testat::parse_request(read_request(3));
        AssetLibrary assets(argv[3]);
        testat::serve(request, {argv[1], argv[2]}, assets, 4);
        return 0;
    } catch (std::exception const& e) {
        std::fprintf(stderr, "probe: %s\n", e.what());
        return 1;
    }
}

#if defined(__SANITIZE_ADDRESS__)
/// An upload's crash must look the same with and without the sanitizer; what it leaks is not ours to report.
extern "C" char const* __asan_default_options()
{
    return "handle_segv=0:handle_abort=0:handle_sigfpe=0:handle_sigbus=0:handle_sigill=0:detect_leaks=0:"
           "verify_asan_link_order=0:detect_odr_violation=0";
}
#endif
