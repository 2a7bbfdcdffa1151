// verdict: {"loses": {}}
// The texel itself and the neighbour on the nearer side.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    float s = uv.x * mip_levels[level]->getWidth();
    float t = uv.y * mip_levels[level]->getHeight();
    int x = int(std::floor(s)), y = int(std::floor(t));
    float ds = s - x - 0.5f, dt = t - y - 0.5f;
    int nx = ds < 0 ? x - 1 : x + 1;
    int ny = dt < 0 ? y - 1 : y + 1;
    ds = std::abs(ds);
    dt = std::abs(dt);
    glm::vec4 row0 = get_texel(level, x, y) * (1 - ds) + get_texel(level, nx, y) * ds;
    glm::vec4 row1 = get_texel(level, x, ny) * (1 - ds) + get_texel(level, nx, ny) * ds;
    return row0 * (1 - dt) + row1 * dt;
}
