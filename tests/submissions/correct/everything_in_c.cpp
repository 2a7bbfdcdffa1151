// verdict: {"loses": {}}
// As somebody writes who comes from C.
#include <math.h>
#include <stdio.h>
#include <string.h>

#define MIN(a, b) ((a) < (b) ? (a) : (b))
#define MAX(a, b) ((a) > (b) ? (a) : (b))

glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    int w, h, i, j;
    w = mip_levels[level]->getWidth();
    h = mip_levels[level]->getHeight();
    i = (int)floorf(uv.x * w);
    j = (int)floorf(uv.y * h);
    return get_texel(level, i, j);
}

int ImageTexture::wrap_clamp(int val, int size)
{
    return MAX(0, MIN(val, size - 1));
}

int ImageTexture::wrap_repeat(int val, int size)
{
    int r;
    r = val % size;
    if (r < 0) r += size;
    return r;
}

glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    float s, t, fs, ft;
    int i, j, k;
    glm::vec4 c[4], r;
    s = uv.x * mip_levels[level]->getWidth() - 0.5f;
    t = uv.y * mip_levels[level]->getHeight() - 0.5f;
    i = (int)floorf(s);
    j = (int)floorf(t);
    fs = s - i;
    ft = t - j;
    c[0] = get_texel(level, i, j);
    c[1] = get_texel(level, i + 1, j);
    c[2] = get_texel(level, i, j + 1);
    c[3] = get_texel(level, i + 1, j + 1);
    for (k = 0; k < 4; k++)
        r[k] = (c[0][k] * (1 - fs) + c[1][k] * fs) * (1 - ft) + (c[2][k] * (1 - fs) + c[3][k] * fs) * ft;
    return r;
}

glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    float S, T, f;
    int last, l;
    glm::vec4 a, b;
    last = (int)mip_levels.size() - 1;
    S = MAX(dudv.x * mip_levels[0]->getWidth(), dudv.y * mip_levels[0]->getHeight());
    if (S < 1) S = 1;
    T = logf(S) / logf(2.0f);
    if (T >= last) return evaluate_bilinear(last, uv);
    l = (int)T;
    f = T - l;
    a = evaluate_bilinear(l, uv);
    b = evaluate_bilinear(l + 1, uv);
    return a * (1 - f) + b * f;
}

glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    glm::vec3 p[4];
    glm::vec2 uv[4], lo, hi;
    int i;
    for (i = 0; i < 4; i++) {
        float t = -1;
        p[i] = isect.position;
        if (intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t) && t > 0)
            p[i] = rays[i].origin + t * rays[i].direction;
    }
    get_intersection_uvs(p, isect, uv);
    memcpy(&lo, &uv[0], sizeof lo);
    memcpy(&hi, &uv[0], sizeof hi);
    for (i = 1; i < 4; i++) {
        lo.x = MIN(lo.x, uv[i].x);
        lo.y = MIN(lo.y, uv[i].y);
        hi.x = MAX(hi.x, uv[i].x);
        hi.y = MAX(hi.y, uv[i].y);
    }
    return hi - lo;
}

glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    glm::vec4 r;
    float l;
    r = transform * glm::vec4(d.x, d.y, d.z, 0);
    l = sqrtf(r.x * r.x + r.y * r.y + r.z * r.z);
    return glm::vec3(r.x / l, r.y / l, r.z / l);
}
