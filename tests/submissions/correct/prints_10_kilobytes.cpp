// verdict: {"loses": {}, "prints": ["evaluate_bilinear"]}
// Debug output that was left in: 10 kB for each call. It costs time and no points.
#include <iostream>
#include <string>

glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    static std::string const noise(10000, '#');
    std::cout << "uv " << uv.x << " " << uv.y << noise << "\n";
    Image const& image = *mip_levels[level];
    float const s = uv.x * float(image.getWidth()) - 0.5f;
    float const t = uv.y * float(image.getHeight()) - 0.5f;
    int const x = int(std::floor(s));
    int const y = int(std::floor(t));
    glm::vec4 const lower = glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), s - float(x));
    glm::vec4 const upper = glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), s - float(x));
    return glm::mix(lower, upper, t - float(y));
}
