// verdict: {"loses": {}}
// Weights by floor of uv times size less a half, written as a quotient.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    float w = mip_levels[level]->getWidth(), h = mip_levels[level]->getHeight();
    glm::vec2 p = uv - glm::vec2(0.5f / w, 0.5f / h);
    float s = p.x * w, t = p.y * h;
    float x1 = floor(s), x2 = x1 + 1, y1 = floor(t), y2 = y1 + 1;
    glm::vec4 R1 = (x2 - s) / (x2 - x1) * get_texel(level, x1, y1) + (s - x1) / (x2 - x1) * get_texel(level, x2, y1);
    glm::vec4 R2 = (x2 - s) / (x2 - x1) * get_texel(level, x1, y2) + (s - x1) / (x2 - x1) * get_texel(level, x2, y2);
    return (y2 - t) / (y2 - y1) * R1 + (t - y1) / (y2 - y1) * R2;
}
