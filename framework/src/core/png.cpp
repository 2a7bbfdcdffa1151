#include "png.h"

#include <fmt/format.h>
#include <spng.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace {
using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
using Context = std::unique_ptr<spng_ctx, void (*)(spng_ctx*)>;

int const fast_compression = 1;
/// One filter for all rows: trying all of them takes longer than compressing, and does not make the files smaller.
int const fast_filter = SPNG_FILTER_CHOICE_SUB;
/// Larger than any texture, small enough that a forged header cannot take all memory.
std::uint32_t const max_side = 1u << 14;

[[noreturn]] void fail(char const* what, std::string const& path, char const* why)
{
    throw std::runtime_error(fmt::format("cannot {} {}: {}", what, path, why));
}

File open(std::string const& path, char const* mode, char const* what)
{
    errno = 0;
    File file(std::fopen(path.c_str(), mode), &std::fclose);
    if (!file)
        fail(what, path, std::strerror(errno));
    return file;
}

/// Passes a result of libspng on, unless it is an error.
void check(int error, char const* what, std::string const& path)
{
    if (error != SPNG_OK)
        fail(what, path, spng_strerror(error));
}

std::vector<unsigned char> decode(spng_ctx* context, int format, std::string const& path)
{
    std::size_t size = 0;
    check(spng_decoded_image_size(context, format, &size), "read", path);
    std::vector<unsigned char> bytes(size);
    check(spng_decode_image(context, bytes.data(), size, format, SPNG_DECODE_TRNS), "read", path);
    return bytes;
}

spng_ihdr header_of(Bytes const& bytes)
{
    spng_ihdr header{};
    header.width = std::uint32_t(bytes.width);
    header.height = std::uint32_t(bytes.height);
    header.bit_depth = 8;
    header.color_type = bytes.channels == 4 ? SPNG_COLOR_TYPE_TRUECOLOR_ALPHA : SPNG_COLOR_TYPE_TRUECOLOR;
    return header;
}

/// Writes what is buffered, and closes: a full disk shows up here at the latest.
void finish(File file, std::string const& path)
{
    errno = 0;
    bool const broken = std::ferror(file.get()) != 0;
    if (std::fclose(file.release()) != 0 || broken)
        fail("write", path, errno ? std::strerror(errno) : "write error");
}
}  // namespace

std::uint16_t Png::value(std::size_t i) const
{
    if (max == 255)
        return bytes[i];
    std::uint16_t value;
    std::memcpy(&value, &bytes[2 * i], sizeof(value));
    return value;
}

Png read_png(std::string const& path)
{
    File const file = open(path, "rb", "read");
    Context const context(spng_ctx_new(0), &spng_ctx_free);
    check(spng_set_image_limits(context.get(), max_side, max_side), "read", path);
    check(spng_set_png_file(context.get(), file.get()), "read", path);
    spng_ihdr header{};
    check(spng_get_ihdr(context.get(), &header), "read", path);

    bool const deep = header.bit_depth == 16;
    return {int(header.width), int(header.height), deep ? 65535 : 255,
            decode(context.get(), deep ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8, path)};
}

void write_png(Bytes const& bytes, std::string const& path)
{
    File file = open(path, "wb", "write");
    Context const context(spng_ctx_new(SPNG_CTX_ENCODER), &spng_ctx_free);
    spng_ihdr header = header_of(bytes);
    check(spng_set_png_file(context.get(), file.get()), "write", path);
    check(spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, fast_compression), "write", path);
    check(spng_set_option(context.get(), SPNG_FILTER_CHOICE, fast_filter), "write", path);
    check(spng_set_ihdr(context.get(), &header), "write", path);
    check(
        spng_encode_image(context.get(), bytes.values.data(), bytes.values.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE),
        "write", path);
    finish(std::move(file), path);
}
