#include "text.h"

#include <nettle/sha2.h>

#include <algorithm>
#include <array>
#include <cstdint>

namespace testat {
namespace {
/// One code point from the front of `bytes`: its length in bytes, or 0 if it is not valid UTF-8.
std::size_t decode(std::string_view bytes, std::uint32_t& code)
{
    auto const lead = static_cast<unsigned char>(bytes[0]);
    std::size_t const length = lead < 0x80                   ? 1
                               : lead >= 0xc2 && lead < 0xe0 ? 2
                               : (lead & 0xf0) == 0xe0       ? 3
                               : lead >= 0xf0 && lead < 0xf5 ? 4
                                                             : 0;
    if (length == 0 || length > bytes.size())
        return 0;
    code = length == 1 ? lead : lead & (0x7fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        auto const next = static_cast<unsigned char>(bytes[i]);
        if ((next & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (next & 0x3f);
    }
    constexpr std::array<std::uint32_t, 5> smallest = {0, 0, 0x80, 0x800, 0x10000};
    bool const surrogate = code >= 0xd800 && code < 0xe000;
    return code < smallest[length] || surrogate || code > 0x10ffff ? 0 : length;
}

/// Characters that steer a terminal or reorder text instead of being seen.
bool is_invisible(std::uint32_t code)
{
    bool const control = (code < 0x20 && code != '\n' && code != '\t') || (code >= 0x7f && code < 0xa0);
    bool const direction = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069) || code == 0x200e ||
                           code == 0x200f || code == 0x061c;
    bool const no_width = (code >= 0x200b && code <= 0x200d) || (code >= 0x2060 && code <= 0x2064) || code == 0xad ||
                          code == 0x180e || code == 0xfeff || (code >= 0xe0000 && code <= 0xe007f);
    return control || direction || no_width || code == 0x2028 || code == 0x2029;
}
}  // namespace

std::string clean_text(std::string_view bytes, std::size_t max_bytes)
{
    std::string result;
    while (!bytes.empty()) {
        std::uint32_t code = 0xfffd;
        std::size_t const length = decode(bytes, code);
        std::string_view const piece = length == 0 ? "\xef\xbf\xbd" : bytes.substr(0, length);
        if (result.size() + piece.size() > max_bytes)
            return result + "...";
        if (!is_invisible(code) || length == 0)
            result += piece;
        bytes.remove_prefix(length == 0 ? 1 : length);
    }
    return result;
}

std::string one_line(std::string_view bytes, std::size_t max_bytes)
{
    std::string result = clean_text(bytes, max_bytes);
    std::replace_if(
        result.begin(), result.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
    return result;
}

std::string sha256(std::string_view bytes)
{
    sha256_ctx context;
    sha256_init(&context);
    sha256_update(&context, bytes.size(), reinterpret_cast<std::uint8_t const*>(bytes.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context, digest.size(), digest.data());
    std::string hex;
    for (std::uint8_t byte : digest) {
        hex += "0123456789abcdef"[byte >> 4];
        hex += "0123456789abcdef"[byte & 15];
    }
    return hex;
}
}  // namespace testat
