#pragma once

#include <glm/glm.hpp>

#include <memory>

class Texture;

/// The values of a material at one point.
struct MaterialSample {
    /// The Phong coefficients (rgb) for ambient, diffuse and specular light.
    glm::vec3 k_a = glm::vec3(0.f);
    glm::vec3 k_d = glm::vec3(0.f);
    glm::vec3 k_s = glm::vec3(0.f);
    /// The share (rgb) that is reflected, and that is transmitted.
    glm::vec3 k_r = glm::vec3(0.f);
    glm::vec3 k_t = glm::vec3(0.f);
    /// From the normal map, unit, in tangent space: y is the normal's axis.
    glm::vec3 normal = glm::vec3(0.f);
    /// Index of refraction.
    float eta = 0.f;
    /// Phong exponent.
    float n = 0.f;
};

/// How a surface looks: one texture for each coefficient.
class Material {
public:
    /// k_d is 0.18, everything else absent: k_s, k_r, k_t are 0, the normal map is flat.
    Material();
    ~Material();

    /// All textures but the normal map at uv, the sum of a channel's coefficients being scaled down to 1 where above.
    /// dudv is the size of the footprint in uv space. The sample's normal is the axis (0, 1, 0).
    MaterialSample evaluate(glm::vec2 const& uv, glm::vec2 const& dudv) const;

    /// The normal map at uv, unit: rgb becomes (2r - 1, b, 2g - 1).
    glm::vec3 evaluate_normal(glm::vec2 const& uv, glm::vec2 const& dudv) const;

    /// Whether any texture but the normal map depends on uv.
    bool is_textured() const;
    /// Whether the normal map is more than the flat default: a texture that depends on uv, or another constant.
    bool has_normal_map() const;

    /// None by default: then it is a tenth of k_d.
    std::shared_ptr<Texture> k_a;
    std::shared_ptr<Texture> k_d;
    std::shared_ptr<Texture> k_s;
    std::shared_ptr<Texture> k_r;
    std::shared_ptr<Texture> k_t;
    /// (0.5, 0.5, 1) by default, which is flat.
    std::shared_ptr<Texture> normal;
    /// Index of refraction, >= 1.
    float eta = 1.f;
    /// Phong exponent, >= 0.
    float n = 1.f;
};
