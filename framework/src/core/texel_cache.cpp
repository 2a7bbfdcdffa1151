#include "packed_texels.h"
#include "png.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace {
std::int32_t const max_side = 1 << 14;

/// What a cache file was made from. A source of another size or time is another picture. The texels follow.
struct Header {
    char magic[8] = {'t', 'e', 'x', 'e', 'l', 's', '2', 0};
    std::int32_t width = 0;
    std::int32_t height = 0;
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
    return sizeof header + 4 * std::size_t(header.width) * std::size_t(header.height);
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

/// The bytes behind the header; null if they cannot be mapped.
std::shared_ptr<unsigned char const> map_texels(int fd, std::size_t size)
{
    void* const memory = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, fd, 0);
    if (memory == MAP_FAILED)
        return nullptr;
    std::shared_ptr<void> const mapping(memory, [size](void* m) { munmap(m, size); });
    return {mapping, static_cast<unsigned char const*>(memory) + sizeof(Header)};
}
}  // namespace

std::shared_ptr<TexelBytes const> open_texel_cache(std::string const& cache, std::string const& source)
{
    Header header;
    File const file(cache);
    if (file.fd < 0 || !describe_source(source, &header) || !read_header(file.fd, &header))
        return nullptr;
    auto texels = map_texels(file.fd, file_size(header));
    if (!texels)
        return nullptr;
    return std::make_shared<TexelBytes>(TexelBytes{header.width, header.height, std::move(texels)});
}

std::shared_ptr<TexelBytes const> decode_texels(std::string const& path)
{
    Png const png = read_png(path);
    if (png.max != 255)
        return nullptr;
    std::size_t const row = 4 * std::size_t(png.width);
    auto const flipped = std::make_shared<std::vector<unsigned char>>();
    flipped->reserve(png.bytes.size());
    for (int j = png.height - 1; j >= 0; --j) {
        unsigned char const* const begin = png.bytes.data() + std::size_t(j) * row;
        flipped->insert(flipped->end(), begin, begin + row);
    }
    return std::make_shared<TexelBytes>(TexelBytes{png.width, png.height, {flipped, flipped->data()}});
}

void write_texel_cache(std::string const& cache, std::string const& source)
{
    Header header;
    if (!describe_source(source, &header))
        throw std::runtime_error(fmt::format("cannot read {}: {}", source, std::strerror(errno)));
    auto const texels = decode_texels(source);
    if (!texels)
        throw std::runtime_error(fmt::format("cannot keep {}: it has more than 8 bit for each channel", source));
    header.width = texels->width;
    header.height = texels->height;
    std::string const unfinished = cache + ".new";
    std::ofstream out(unfinished, std::ios::binary);
    out.write(reinterpret_cast<char const*>(&header), sizeof header);
    out.write(reinterpret_cast<char const*>(texels->rgba.get()), std::streamsize(file_size(header) - sizeof header));
    out.close();
    if (!out || std::rename(unfinished.c_str(), cache.c_str()) != 0)
        throw std::runtime_error(fmt::format("cannot write {}: {}", cache, std::strerror(errno)));
}
