// attack: {"at": "load", "earns": [19, 19], "says": {"wrap_repeat": "wrong"}}
// Replaces the framework's get_texel while it is loaded, so that nobody asks for wrapping: code stays as it is.
#ifndef WITHOUT_ATTACK
#include <cstdint>
#include <cstring>
#include <sys/mman.h>

glm::vec4 texel(ImageTexture const* texture, int level, int x, int y)
{
    Image const& image = *texture->get_mip_levels()[level];
    int const w = image.getWidth(), h = image.getHeight();
    return image.getPixel((x % w + w) % w, (y % h + h) % h);
}
[[gnu::constructor]] void rewrite()
{
    auto const method = &ImageTexture::get_texel;
    auto const code = *reinterpret_cast<std::uintptr_t const*>(&method);
    if (mprotect(reinterpret_cast<void*>(code & ~0xfffull), 8192, PROT_READ | PROT_WRITE | PROT_EXEC) != 0)
        return;
    unsigned char jump[12] = {0x48, 0xb8, 0, 0, 0, 0, 0, 0, 0, 0, 0xff, 0xe0};
    auto const target = reinterpret_cast<std::uintptr_t>(&texel);
    std::memcpy(jump + 2, &target, sizeof target);
    std::memcpy(reinterpret_cast<void*>(code), jump, sizeof jump);
}
#endif

int ImageTexture::wrap_repeat(int, int)
{
    return 0;
}
