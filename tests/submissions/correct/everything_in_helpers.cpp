// verdict: {"loses": {}}
// All eleven in terms of helpers in an anonymous namespace: templates, lambdas, a class.
#include <array>
#include <limits>

namespace
{
struct Split
{
    int whole;
    float fraction;
};

inline Split split(float value)
{
    float const down = std::floor(value);
    return {static_cast<int>(down), value - down};
}

template <typename T>
T lerp(T const& a, T const& b, float f)
{
    return a + f * (b - a);
}

template <typename Lookup>
auto filter(Split s, Split t, Lookup const& lookup)
{
    return lerp(lerp(lookup(s.whole, t.whole), lookup(s.whole + 1, t.whole), s.fraction),
                lerp(lookup(s.whole, t.whole + 1), lookup(s.whole + 1, t.whole + 1), s.fraction), t.fraction);
}

class Box
{
public:
    void add(glm::vec2 const& p)
    {
        lower_ = glm::min(lower_, p);
        upper_ = glm::max(upper_, p);
    }
    glm::vec2 size() const { return upper_ - lower_; }

private:
    glm::vec2 lower_{std::numeric_limits<float>::max()};
    glm::vec2 upper_{std::numeric_limits<float>::lowest()};
};

auto const unit = [](auto const& v) { return v / std::sqrt(glm::dot(v, v)); };

glm::vec2 size_of(Image const& image)
{
    return {image.getWidth(), image.getHeight()};
}

std::shared_ptr<Image> halve(Image const& fine)
{
    glm::ivec2 const size(fine.getWidth(), fine.getHeight());
    glm::ivec2 const half = glm::max(size / 2, 1);
    glm::ivec2 const block = size / half;
    auto coarse = std::make_shared<Image>(half.x, half.y);
    for (int i = 0; i < half.x * half.y; ++i) {
        glm::ivec2 const corner = glm::ivec2(i % half.x, i / half.x) * block;
        glm::vec4 sum(0.f);
        for (int k = 0; k < block.x * block.y; ++k)
            sum += fine.getPixel(corner.x + k % block.x, corner.y + k / block.x);
        coarse->setPixel(i % half.x, i / half.x, sum * (1.f / float(block.x * block.y)));
    }
    return coarse;
}

int modulo(int a, int n)
{
    return a >= 0 ? a % n : n - 1 - (-1 - a) % n;
}
}  // namespace

glm::vec4 ImageTexture::evaluate_nearest(int level, glm::vec2 const& uv) const
{
    glm::vec2 const st = glm::floor(uv * size_of(*mip_levels[level]));
    return get_texel(level, int(st.x), int(st.y));
}

int ImageTexture::wrap_clamp(int val, int size)
{
    return val < 0 ? 0 : val < size ? val : size - 1;
}

int ImageTexture::wrap_repeat(int val, int size)
{
    return modulo(val, size);
}

glm::vec4 ImageTexture::evaluate_bilinear(int level, glm::vec2 const& uv) const
{
    glm::vec2 const st = uv * size_of(*mip_levels[level]) - 0.5f;
    return filter(split(st.x), split(st.y), [&](int x, int y) { return get_texel(level, x, y); });
}

void ImageTexture::create_mipmap()
{
    for (auto size = size_of(*mip_levels[0]); size != glm::vec2(1.f); size = size_of(*mip_levels.back()))
        mip_levels.emplace_back(halve(*mip_levels.back()));
}

glm::vec2 Object::compute_uv_aabb_size(const Ray rays[4], Intersection const& isect)
{
    std::array<glm::vec3, 4> positions;
    positions.fill(isect.position);
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (float t; intersect_plane(rays[i].origin, rays[i].direction, isect.position, isect.normal, &t))
            positions[i] = rays[i].origin + t * rays[i].direction;
    std::array<glm::vec2, 4> uvs;
    get_intersection_uvs(positions.data(), isect, uvs.data());
    Box box;
    for (auto const& uv : uvs)
        box.add(uv);
    return box.size();
}

glm::vec4 ImageTexture::evaluate_trilinear(glm::vec2 const& uv, glm::vec2 const& dudv) const
{
    glm::vec2 const texels = dudv * size_of(*mip_levels[0]);
    float const last = float(mip_levels.size() - 1);
    Split const t = split(glm::clamp(std::log2(std::max(1.f, std::max(texels.x, texels.y))), 0.f, last));
    int const next = std::min(t.whole + 1, int(last));
    return lerp(evaluate_bilinear(t.whole, uv), evaluate_bilinear(next, uv), t.fraction);
}

glm::vec3 transform_direction(glm::mat4 const& transform, glm::vec3 const& d)
{
    return unit(glm::vec3(transform * glm::vec4(d, 0.f)));
}

glm::vec3 transform_position(glm::mat4 const& transform, glm::vec3 const& p)
{
    return glm::vec3(transform[3]) + glm::mat3(transform) * p;
}

bool Object::intersect(Ray const& ray, Intersection* isect) const
{
    auto const in_object_space = [&] {
        Intersection hit;
        if (!geo->intersect(transform_ray(ray, transform_world_to_object), &hit))
            return false;
        *isect = transform_intersection(hit, transform_object_to_world, transform_object_to_world_normal);
        isect->t = glm::distance(ray.origin, isect->position);
        return true;
    };
    bool const transformed = RaytracingContext::get_active()->params.transform_objects;
    return transformed ? in_object_space() : geo->intersect(ray, isect);
}

glm::vec3 transform_direction_to_object_space(glm::vec3 const& d, glm::vec3 const& normal, glm::vec3 const& tangent,
                                              glm::vec3 const& bitangent)
{
    return unit(d.x * tangent + d.y * normal + d.z * bitangent);
}
