#include "mapped_texels.h"

#include <cglib/core/image.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace {
/// Texels begin on a page of their own.
std::size_t const header_bytes = 4096;
std::int32_t const max_side = 1 << 14;

/// What a cache file was made from. A source of another size or time is another picture.
struct Header {
    char magic[8] = {'t', 'e', 'x', 'e', 'l', 's', '1', 0};
    std::int32_t width = 0;
    std::int32_t height = 0;
    float gamma = 0.f;
    std::int32_t padding = 0;
    std::int64_t source_bytes = 0;
    std::int64_t source_seconds = 0;
    std::int64_t source_nanoseconds = 0;
};

/// Closes itself.
struct File {
    explicit File(std::string const& path) : fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
    ~File()
    {
        if (fd >= 0)
            close(fd);
    }
    File(File const&) = delete;
    File& operator=(File const&) = delete;
    int fd;
};

bool describe_source(std::string const& source, Header* header)
{
    struct stat status = {};
    if (stat(source.c_str(), &status) != 0)
        return false;
    header->source_bytes = status.st_size;
    header->source_seconds = status.st_mtim.tv_sec;
    header->source_nanoseconds = status.st_mtim.tv_nsec;
    return true;
}

std::size_t file_size(Header const& header)
{
    return header_bytes + std::size_t(header.width) * std::size_t(header.height) * sizeof(glm::vec4);
}

bool is_whole(int fd, Header const& header)
{
    bool const sensible =
        header.width > 0 && header.height > 0 && header.width <= max_side && header.height <= max_side;
    struct stat status = {};
    return sensible && fstat(fd, &status) == 0 && std::size_t(status.st_size) == file_size(header);
}

/// Whether the file's header is the wanted one, the picture's size aside, which is taken from it.
bool read_header(int fd, Header* wanted)
{
    Header found;
    if (pread(fd, &found, sizeof found, 0) != ssize_t(sizeof found))
        return false;
    wanted->width = found.width;
    wanted->height = found.height;
    return std::memcmp(&found, wanted, sizeof found) == 0 && is_whole(fd, found);
}
}  // namespace

std::unique_ptr<MappedTexels> MappedTexels::open(std::string const& cache, std::string const& source, float gamma)
{
    Header header;
    header.gamma = gamma;
    File const file(cache);
    if (file.fd < 0 || !describe_source(source, &header) || !read_header(file.fd, &header))
        return nullptr;
    std::size_t const size = file_size(header);
    void* const memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_NORESERVE, file.fd, 0);
    if (memory == MAP_FAILED)
        return nullptr;
    return std::unique_ptr<MappedTexels>(new MappedTexels(memory, size, header.width, header.height));
}

MappedTexels::MappedTexels(void* memory, std::size_t size, int width, int height)
    : memory_(memory), size_(size), width_(width), height_(height)
{
}

MappedTexels::~MappedTexels()
{
    munmap(memory_, size_);
}

void MappedTexels::release() const
{
    madvise(memory_, size_, MADV_DONTNEED);
}

glm::vec4* MappedTexels::data() const
{
    return reinterpret_cast<glm::vec4*>(static_cast<char*>(memory_) + header_bytes);
}

void write_texel_cache(Image const& image, std::string const& cache, std::string const& source, float gamma)
{
    Header header;
    header.width = image.getWidth();
    header.height = image.getHeight();
    header.gamma = gamma;
    if (!describe_source(source, &header))
        throw std::runtime_error(fmt::format("cannot read {}: {}", source, std::strerror(errno)));
    std::string const unfinished = cache + ".new";
    std::ofstream out(unfinished, std::ios::binary);
    out.write(reinterpret_cast<char const*>(&header), sizeof header);
    out.seekp(std::streamoff(header_bytes));
    out.write(reinterpret_cast<char const*>(image.getPixels().data()),
              std::streamsize(file_size(header) - header_bytes));
    out.close();
    if (!out || std::rename(unfinished.c_str(), cache.c_str()) != 0)
        throw std::runtime_error(fmt::format("cannot write {}: {}", cache, std::strerror(errno)));
}
