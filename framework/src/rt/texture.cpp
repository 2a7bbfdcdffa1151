#include <cglib/rt/texture.h>

const char* tex_filter_mode_names[] = {"Nearest", "Bilinear", "Trilinear", "Debug Mip", "White"};
const char* tex_wrap_mode_names[] = {"Repeat", "Clamp", "Zero"};

namespace {
glm::vec4 const level_colors[] = {{1.f, 0.f, 0.f, 0.f}, {0.f, 1.f, 0.f, 0.f}, {0.f, 0.f, 1.f, 0.f},
                                  {1.f, 1.f, 0.f, 0.f}, {1.f, 0.f, 1.f, 0.f}, {0.f, 1.f, 1.f, 0.f}};

bool is_inside(Image const& image, int x, int y)
{
    return x >= 0 && x < image.getWidth() && y >= 0 && y < image.getHeight();
}

std::shared_ptr<Image> load_image(std::string const& filename, float gamma)
{
    auto image = std::make_shared<Image>();
    image->load(filename, gamma);
    return image;
}
}  // namespace

Texture::~Texture() = default;
ConstTexture::~ConstTexture() = default;
ImageTexture::~ImageTexture() = default;

ConstTexture::ConstTexture(glm::vec3 const& value) : value_(value) {}

glm::vec4 ConstTexture::evaluate(glm::vec2 const&, glm::vec2 const&) const
{
    return glm::vec4(value_, 0.f);
}

ImageTexture::ImageTexture(std::string const& filename, TextureFilterMode filter, TextureWrapMode wrap, float gamma)
    : filter_mode(filter), wrap_mode(wrap), mip_levels{load_image(filename, gamma)}
{
}

ImageTexture::ImageTexture(Image const& image, TextureFilterMode filter, TextureWrapMode wrap)
    : filter_mode(filter), wrap_mode(wrap), mip_levels{std::make_shared<Image>(image)}
{
}

ImageTexture::ImageTexture(TextureFilterMode filter, TextureWrapMode wrap) : filter_mode(filter), wrap_mode(wrap) {}

glm::vec4 ImageTexture::evaluate(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    switch (filter_mode) {
        case NEAREST:
            return evaluate_nearest(0, uv);
        case BILINEAR:
            return evaluate_bilinear(0, uv);
        case TRILINEAR:
        case DEBUG_MIP:
            return evaluate_trilinear(uv, dudv);
        default:
            return glm::vec4(1.f);
    }
}

glm::vec4 ImageTexture::get_texel(int level, int x, int y) const
{
    if (filter_mode == WHITE)
        return glm::vec4(1.f);
    cg_assert(level >= 0 && level < int(mip_levels.size()));
    if (filter_mode == DEBUG_MIP)
        return level_colors[level % 6];

    cg_assert(mip_levels[level] != nullptr);
    Image const& image = *mip_levels[level];
    if (wrap_mode == REPEAT) {
        x = wrap_repeat(x, image.getWidth());
        y = wrap_repeat(y, image.getHeight());
    } else if (wrap_mode == CLAMP) {
        x = wrap_clamp(x, image.getWidth());
        y = wrap_clamp(y, image.getHeight());
    } else if (!is_inside(image, x, y)) {
        return glm::vec4(0.f);
    }
    // Asserts that both are inside.
    return image.texel(x, y);
}

void ImageTexture::set_texel(int level, int x, int y, glm::vec4 const& value)
{
    cg_assert(level >= 0 && level < int(mip_levels.size()));
    cg_assert(mip_levels[level] != nullptr);
    mip_levels[level]->setPixel(x, y, value);
}
