// verdict: {"loses": {"evaluate_bilinear": [4, 4]}, "says": {"evaluate_bilinear": "crashed"}, "policy": ["crashes"]}
// Follows a pointer that was never set.
glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    Image const* volatile image = nullptr;
    float const s = uv.x * float(image->getWidth()) - 0.5f;
    return get_texel(level, int(s), 0);
}
