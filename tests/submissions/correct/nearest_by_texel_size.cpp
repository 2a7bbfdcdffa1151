// verdict: {"loses": {}}
// uv over the size of a texel.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    glm::vec2 texelSize(1.f / mip_levels[level]->getWidth(), 1.f / mip_levels[level]->getHeight());
    return get_texel(level, std::floor(uv.x / texelSize.x), std::floor(uv.y / texelSize.y));
}
