// verdict: {"loses": {"evaluate_bilinear": [3, 3]}, "says": {"evaluate_bilinear": "partial"}, "policy": []}
// smoothstep of the fraction looks softer, and is not linear. Right at texel centres.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const

{
    glm::vec2 st = uv * glm::vec2(mip_levels[level]->getWidth(), mip_levels[level]->getHeight()) - 0.5f;
    glm::vec2 base = glm::floor(st);
    glm::vec2 w = glm::smoothstep(0.f, 1.f, st - base);
    int x = (int)base.x, y = (int)base.y;
    return glm::mix(glm::mix(get_texel(level, x, y), get_texel(level, x + 1, y), w.x),
                    glm::mix(get_texel(level, x, y + 1), get_texel(level, x + 1, y + 1), w.x), w.y);
}
