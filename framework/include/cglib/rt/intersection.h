#pragma once

#include <cglib/rt/material.h>

#include <glm/glm.hpp>

#include <cfloat>
#include <cstdint>

/// Where a ray has hit, in the space the ray was given in. Without a hit, t, position and the normals are FLT_MAX.
struct Intersection {
    /// What the material's textures are here.
    MaterialSample material;

    glm::vec3 position = glm::vec3(FLT_MAX);
    /// Of the shape itself, unit.
    glm::vec3 geometric_normal = glm::vec3(FLT_MAX);
    /// Of the shape, possibly interpolated, unit.
    glm::vec3 normal = glm::vec3(FLT_MAX);
    /// Unit, as is bitangent; with normal they span the tangent space.
    glm::vec3 tangent = glm::vec3(0.f);
    glm::vec3 bitangent = glm::vec3(0.f);
    /// The normal after normal mapping, unit.
    glm::vec3 shading_normal = glm::vec3(FLT_MAX);

    /// Texture coordinates; any finite values.
    glm::vec2 uv = glm::vec2(0.f);
    /// The size >= 0 of the pixel's footprint in uv space; zero where it is not known.
    glm::vec2 dudv = glm::vec2(0.f);

    /// Which part of the shape was hit, for shapes of several.
    std::uint32_t primitive_id = 0;
    /// The distance along the ray's (unit) direction.
    float t = FLT_MAX;

    /// Whether something was hit.
    bool isValid() const { return t != FLT_MAX; }
};
