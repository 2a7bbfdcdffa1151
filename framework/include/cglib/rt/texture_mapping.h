#pragma once

#include <cglib/rt/intersection.h>

#include <glm/glm.hpp>

/// Assigns texture coordinates to the points of a shape, in object space.
class TextureMapping {
public:
    virtual ~TextureMapping();

    /// Finite for every finite position.
    virtual glm::vec2 get_uv(Intersection const& isect) const = 0;

    /// Sets tangent and bitangent (unit) from isect->normal. Default: the tangent is +x near the poles
    /// (1 - |n.y| < 1e-4), else (n.z, 0, -n.x) normalised; the bitangent is cross(tangent, normal).
    virtual void compute_tangent_space(Intersection* isect) const;
};

/// (0, 0) everywhere.
class ZeroMapping : public TextureMapping {
public:
    glm::vec2 get_uv(Intersection const& isect) const override;
};

/// What the shape itself has put into isect.uv.
class UVMapping : public TextureMapping {
public:
    glm::vec2 get_uv(Intersection const& isect) const override;
};

/// Longitude and latitude of d, the direction from the centre, times scale_uv:
/// u = atan2(-d.z, d.x) / 2pi brought into [0, 1), v = 1 - acos(d.y) / pi.
class SphericalMapping : public TextureMapping {
public:
    SphericalMapping(glm::vec3 const& center, float scale_uv);
    glm::vec2 get_uv(Intersection const& isect) const override;

private:
    glm::vec3 center_;
    float scale_uv_;
};

/// (dot(d, tangent), dot(d, bitangent)) / scale_uv with d = position - p.
class PlanarMapping : public TextureMapping {
public:
    /// Tangent and bitangent are used as given for uv, whatever their length, and normalised for the tangent space.
    PlanarMapping(glm::vec3 const& p, glm::vec3 const& normal, glm::vec3 const& tangent, glm::vec3 const& bitangent,
                  float scale_uv);
    glm::vec2 get_uv(Intersection const& isect) const override;
    void compute_tangent_space(Intersection* isect) const override;

    /// The one it was made with, unit.
    glm::vec3 const& normal() const { return normal_; }

private:
    glm::vec3 p_;
    glm::vec3 normal_;
    glm::vec3 tangent_;
    glm::vec3 bitangent_;
    float scale_uv_;
};

/// The default tangent for a unit normal, see TextureMapping::compute_tangent_space.
glm::vec3 default_tangent(glm::vec3 const& normal);
