// verdict: {"loses": {}, "remarks": ["races"], "sanitizers": false}
// Keeps the whole part of the coordinates in static variables: right as long as there is one thread.
glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    static double column;
    static double row;
    double const s = std::modf(double(uv.x * float(mip_levels[level]->getWidth())), &column);
    double const t = std::modf(double(uv.y * float(mip_levels[level]->getHeight())), &row);
    if (s < 0)
        column -= 1;
    if (t < 0)
        row -= 1;
    return get_texel(level, int(column), int(row));
}
