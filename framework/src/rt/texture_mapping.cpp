#include <cglib/rt/texture_mapping.h>

#include <cglib/rt/epsilon.h>

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace {
/// atan2 / 2pi brought into [0, 1).
float turn(float y, float x)
{
    float const u = std::atan2(y, x) / glm::two_pi<float>();
    float const positive = u < 0.f ? u + 1.f : u;
    // A tiny negative number plus one is one.
    return positive < 1.f ? positive : 0.f;
}

/// Some direction also for the centre itself, and for what is too near to it to tell.
glm::vec3 direction_or_up(glm::vec3 const& d)
{
    float const length = glm::length(d);
    return length > FLT_MIN && length < FLT_MAX ? d / length : glm::vec3(0.f, 1.f, 0.f);
}
}  // namespace

TextureMapping::~TextureMapping() = default;

void TextureMapping::compute_tangent_space(Intersection* isect) const
{
    isect->tangent = default_tangent(isect->normal);
    isect->bitangent = glm::cross(isect->tangent, isect->normal);
}

glm::vec3 default_tangent(glm::vec3 const& normal)
{
    if (1.f - std::abs(normal.y) < pole_epsilon)
        return glm::vec3(1.f, 0.f, 0.f);
    return glm::normalize(glm::vec3(normal.z, 0.f, -normal.x));
}

glm::vec2 ZeroMapping::get_uv(Intersection const&) const
{
    return glm::vec2(0.f);
}

glm::vec2 UVMapping::get_uv(Intersection const& isect) const
{
    return isect.uv;
}

SphericalMapping::SphericalMapping(glm::vec3 const& center, float scale_uv) : center_(center), scale_uv_(scale_uv) {}

glm::vec2 SphericalMapping::get_uv(Intersection const& isect) const
{
    glm::vec3 const d = direction_or_up(isect.position - center_);
    float const v = 1.f - std::acos(glm::clamp(d.y, -1.f, 1.f)) / glm::pi<float>();
    return glm::vec2(turn(-d.z, d.x), v) * scale_uv_;
}

PlanarMapping::PlanarMapping(glm::vec3 const& p, glm::vec3 const& normal, glm::vec3 const& tangent,
                             glm::vec3 const& bitangent, float scale_uv)
    : p_(p), normal_(glm::normalize(normal)), tangent_(tangent), bitangent_(bitangent), scale_uv_(scale_uv)
{
}

glm::vec2 PlanarMapping::get_uv(Intersection const& isect) const
{
    glm::vec3 const d = isect.position - p_;
    return glm::vec2(glm::dot(d, tangent_), glm::dot(d, bitangent_)) / scale_uv_;
}

void PlanarMapping::compute_tangent_space(Intersection* isect) const
{
    isect->tangent = glm::normalize(tangent_);
    isect->bitangent = glm::normalize(bitangent_);
}
