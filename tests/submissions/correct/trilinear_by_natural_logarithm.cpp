// verdict: {"loses": {}}
// log over log(2).
glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float du = dudv.x * mip_levels[0]->getWidth(), dv = dudv.y * mip_levels[0]->getHeight();
    float S = du > dv ? du : dv;
    float T = logf(S) / logf(2.f);
    if (!(T > 0)) return evaluate_bilinear(0, uv);
    int top = mip_levels.size() - 1;
    if (T >= top) return evaluate_bilinear(top, uv);
    float fl = floorf(T);
    float w = T - fl;
    glm::vec4 lo = evaluate_bilinear((int)fl, uv), hi = evaluate_bilinear((int)ceilf(T), uv);
    return lo + w * (hi - lo);
}
